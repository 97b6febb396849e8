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
 * Tells whether to update a mapper's pipeline once more would make anything, which takes far longer to find out by updating it. VTK has a filter run if the pipeline's time is later than its data, or if
 * other data are requested than those are (vtkStreamingDemandDrivenPipeline::NeedToExecuteData); so it does not where it ran, and none of that has changed.
 */
class PipelineState
{
public:
  /** Of nothing: what would be made is not known. */
  PipelineState() = default;

  /** Updates what a mapper is connected to, as drawing does: with its requests for pieces, and with those that others have left, as for a time. */
  explicit PipelineState(vtkPolyDataMapper* mapper);

  /** Whether nothing would be made. One thread at a time: pipelines keep their time. */
  bool IsCurrent(vtkPolyDataMapper* mapper) const;

private:
  vtkDemandDrivenPipeline* Producer = nullptr; ///< null if that is not known; `Requests` hold it
  vtkMTimeType Time = 0;                       ///< of the pipeline
  vtkInformation* Requests = nullptr;          ///< for data, and what they are
  vtkMTimeType RequestsTime = 0;
};

/** Whether what an algorithm's first input is connected to, if anything, has made all of its data already, so that to update it makes nothing. Updates nothing. */
bool IsInputMade(vtkAlgorithm* consumer);

}

#endif
