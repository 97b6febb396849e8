#include "FrameAnswers.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPVSession.h"

#include <cstddef>

namespace vitrine
{

namespace
{

/** A tag that no message of ParaView has. */
constexpr int Tag = 5654;

void Write(vtkMultiProcessStream& stream, const FrameAnswers& answers)
{
  stream << answers.Reason << static_cast<vtkTypeInt64>(answers.Fragments)
         << static_cast<vtkTypeInt64>(answers.MostLayers) << answers.CullingReason
         << static_cast<vtkTypeInt64>(answers.CulledParts)
         << static_cast<vtkTypeInt64>(answers.OpenCutParts) << answers.LayersProblem
         << static_cast<unsigned int>(answers.Layers.size());
  for (const LayerOfPixel& layer : answers.Layers)
  {
    stream << layer.Rank << layer.Representation << layer.Block << layer.Depth << layer.Distance
           << layer.Share;
  }
}

FrameAnswers Read(vtkMultiProcessStream& stream)
{
  FrameAnswers answers;
  vtkTypeInt64 fragments = 0, layers = 0, culled = 0, open = 0;
  unsigned int count = 0;
  stream >> answers.Reason >> fragments >> layers >> answers.CullingReason >> culled >> open >>
    answers.LayersProblem >> count;
  answers.Fragments = static_cast<vtkIdType>(fragments);
  answers.MostLayers = static_cast<vtkIdType>(layers);
  answers.CulledParts = static_cast<vtkIdType>(culled);
  answers.OpenCutParts = static_cast<vtkIdType>(open);
  answers.Layers.resize(count);
  for (LayerOfPixel& layer : answers.Layers)
  {
    stream >> layer.Rank >> layer.Representation >> layer.Block >> layer.Depth >> layer.Distance >>
      layer.Share;
  }
  return answers;
}

}

void FrameAnswers::Gather(vtkMultiProcessController* ranks)
{
  vtkMultiProcessStream own;
  Write(own, *this);
  std::vector<vtkMultiProcessStream> all;
  ranks->Gather(own, all, 0);
  for (std::size_t rank = 1; rank < all.size(); ++rank)
  {
    const FrameAnswers told = Read(all[rank]);
    this->CulledParts += told.CulledParts;
    this->OpenCutParts += told.OpenCutParts;
    for (std::size_t i = 0; i < this->Layers.size(); ++i)
    {
      if (this->Layers[i].Rank == static_cast<int>(rank))
      {
        this->Layers[i] = told.Layers[i];
      }
    }
  }
}

void FrameAnswers::Exchange(vtkPVSession* session)
{
  if (!session)
  {
    return;
  }
  vtkMultiProcessStream stream;
  if (!session->HasProcessRole(vtkPVSession::CLIENT))
  {
    if (auto* const client = session->GetController(vtkPVSession::CLIENT)) // none on satellites
    {
      Write(stream, *this);
      client->Send(stream, 1, Tag);
    }
  }
  else if (auto* const server = session->GetController(vtkPVSession::RENDER_SERVER_ROOT))
  {
    server->Receive(stream, 1, Tag);
    *this = Read(stream);
  }
}

}
