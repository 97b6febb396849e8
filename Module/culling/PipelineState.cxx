#include "culling/PipelineState.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"

namespace vitrine
{

PipelineState::PipelineState(vtkAlgorithm* consumer)
{
  if (consumer->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  vtkAlgorithm* const producer = consumer->GetInputAlgorithm(0, 0, this->Port);
  this->Producer = vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive());
  this->Requests = consumer->GetInputInformation(0, 0);
  this->RequestsTime = this->Requests->GetMTime();
  this->Time = this->Producer ? this->FindTime() : 0;
}

bool PipelineState::IsCurrent() const
{
  return this->Producer && this->Requests->GetMTime() == this->RequestsTime &&
    this->FindTime() == this->Time;
}

/** The latest one of all that the data are made of, as the pipeline itself finds it. */
vtkMTimeType PipelineState::FindTime() const
{
  vtkMTimeType time = 0;
  this->Producer->ComputePipelineMTime(nullptr, this->Producer->GetInputInformation(),
    this->Producer->GetOutputInformation(), this->Port, &time);
  return time;
}

}
