#ifndef VITRINE_CULLING_PIPELINE_STATE_H
#define VITRINE_CULLING_PIPELINE_STATE_H

#include "vtkType.h"

class vtkAlgorithm;
class vtkDemandDrivenPipeline;
class vtkInformation;

namespace vitrine
{

/**
 * Tells whether to update a pipeline once more would make anything, which takes far longer to find out by updating it. VTK has a filter run if the pipeline's time is later than its data, or if
 * other data are requested than those are (vtkStreamingDemandDrivenPipeline::NeedToExecuteData); so it does not where none of what that depends on has changed.
 */
class PipelineState
{
public:
  /** Of nothing: what would be made is not known. */
  PipelineState() = default;

  /** Of what the first connection of an algorithm has for it, once that was updated. */
  explicit PipelineState(vtkAlgorithm* consumer);

  /** Whether nothing would be made. The algorithm has to be connected as it was. One thread at a time: pipelines keep their time. */
  bool IsCurrent() const;

private:
  vtkMTimeType FindTime() const;

  vtkDemandDrivenPipeline* Producer = nullptr; ///< null if that is not known
  int Port = 0;                                ///< of it
  vtkMTimeType Time = 0;                       ///< of the pipeline
  vtkInformation* Requests = nullptr;          ///< for data, and what they are
  vtkMTimeType RequestsTime = 0;
};

}

#endif
