/** Tells whether an update of a VTK pipeline would execute anything. */
#ifndef VITRINE_SCENE_PIPELINE_STATE_H
#define VITRINE_SCENE_PIPELINE_STATE_H

#include "vtkType.h"

class vtkAlgorithm;
class vtkDemandDrivenPipeline;
class vtkInformation;
class vtkPolyDataMapper;

namespace vitrine
{

/**
 * Remembers the state of a mapper's pipeline, and tells whether another update would execute a filter. Asking is far
 * cheaper than updating.
 *
 * VTK executes a filter if the pipeline's time is later than its data, or if other data are requested than it has
 * (vtkStreamingDemandDrivenPipeline::NeedToExecuteData). So it executes none if it has run and neither changed since.
 */
class PipelineState
{
public:
  /** Makes the state of no pipeline. IsCurrent() returns false. */
  PipelineState() = default;

  /**
   * Updates the pipeline of a mapper as drawing does: with its requests for pieces, and with requests that others left,
   * as for a time.
   */
  explicit PipelineState(vtkPolyDataMapper* mapper);

  /**
   * Returns true if an update would execute nothing. Call it from one thread at a time, since pipelines store their
   * time.
   */
  bool IsCurrent(vtkPolyDataMapper* mapper) const;

private:
  /** Null if it is not known. `Requests` keeps it alive. */
  vtkDemandDrivenPipeline* Producer = nullptr;
  vtkMTimeType Time = 0;              ///< Modification time of the pipeline.
  vtkInformation* Requests = nullptr; ///< Requests for the data, and the data.
  vtkMTimeType RequestsTime = 0;
};

/**
 * Returns true if updating the first input of `consumer` would execute nothing, or if there is no input. Updates
 * nothing itself.
 */
bool IsInputMade(vtkAlgorithm* consumer);

}

#endif
