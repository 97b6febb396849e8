#include "scene/PipelineState.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkPolyDataMapper.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

namespace vitrine
{

namespace
{
// Drawing updates output 0, whichever output the mapper is connected to.
const int DrawnPort = 0;

/** Sets the requests of vtkPolyDataMapper::Render(), for mappers of one piece. */
void RequestPieces(vtkPolyDataMapper* mapper, vtkInformation* requests)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  requests->Set(Pipeline::UPDATE_PIECE_NUMBER(), mapper->GetPiece());
  requests->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), mapper->GetNumberOfPieces());
  requests->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), mapper->GetGhostLevel());
}

/** Finds the latest modification time in the pipeline, as the pipeline itself does. Returns false if it cannot. */
bool FindTime(vtkDemandDrivenPipeline* producer, vtkMTimeType& time)
{
  return producer->ComputePipelineMTime(nullptr, producer->GetInputInformation(),
           producer->GetOutputInformation(), DrawnPort, &time) != 0;
}
}

PipelineState::PipelineState(vtkPolyDataMapper* mapper)
{
  int port = DrawnPort;
  vtkAlgorithm* const producer = mapper->GetInputAlgorithm(0, 0, port);
  producer->UpdateInformation();
  this->Requests = mapper->GetInputInformation(0, 0);
  RequestPieces(mapper, this->Requests);
  vtkExecutive* const executive = producer->GetExecutive();
  // VTK retries failed data in each update, even if nothing has changed.
  const bool isMade = executive->Update(DrawnPort) != 0;
  this->RequestsTime = this->Requests->GetMTime();
  auto* const known = vtkDemandDrivenPipeline::SafeDownCast(executive);
  this->Producer = isMade && port == DrawnPort ? known : nullptr;
  if (this->Producer && !FindTime(this->Producer, this->Time))
  {
    this->Producer = nullptr;
  }
}

bool PipelineState::IsCurrent(vtkPolyDataMapper* mapper) const
{
  vtkMTimeType time = 0;
  return this->Producer && mapper->GetInputInformation(0, 0) == this->Requests &&
    this->Requests->GetMTime() == this->RequestsTime && FindTime(this->Producer, time) &&
    time == this->Time;
}

bool IsInputMade(vtkAlgorithm* consumer)
{
  if (consumer->GetNumberOfInputConnections(0) == 0 ||
    vtkTrivialProducer::SafeDownCast(consumer->GetInputAlgorithm()))
  {
    return true;
  }
  int port = DrawnPort;
  auto* const producer =
    vtkDemandDrivenPipeline::SafeDownCast(consumer->GetInputAlgorithm(0, 0, port)->GetExecutive());
  vtkDataObject* const data = consumer->GetInputDataObject(0, 0);
  const bool hasTime =
    consumer->GetInputInformation(0, 0)->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  vtkMTimeType time = 0;
  return producer && data && port == DrawnPort && !hasTime && !data->GetDataReleased() &&
    FindTime(producer, time) && time < data->GetUpdateTime();
}

}
