#include "FrameAnswers.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPVSession.h"

#include <algorithm>
#include <cstddef>
#include <map>

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
         << static_cast<vtkTypeInt64>(answers.CulledParts) << answers.LayersProblem
         << static_cast<unsigned int>(answers.OpenParts.size())
         << static_cast<unsigned int>(answers.Layers.size());
  for (const auto& [representation, block] : answers.OpenParts)
  {
    stream << representation << block;
  }
  for (const LayerOfPixel& layer : answers.Layers)
  {
    stream << layer.Rank << layer.Representation << layer.Block << layer.Depth << layer.Distance
           << layer.Share;
  }
}

FrameAnswers Read(vtkMultiProcessStream& stream)
{
  FrameAnswers answers;
  vtkTypeInt64 fragments = 0, layers = 0, culled = 0;
  unsigned int open = 0, count = 0;
  stream >> answers.Reason >> fragments >> layers >> answers.CullingReason >> culled >>
    answers.LayersProblem >> open >> count;
  answers.Fragments = static_cast<vtkIdType>(fragments);
  answers.MostLayers = static_cast<vtkIdType>(layers);
  answers.CulledParts = static_cast<vtkIdType>(culled);
  answers.OpenParts.resize(open);
  for (auto& [representation, block] : answers.OpenParts)
  {
    stream >> representation >> block;
  }
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
  std::map<std::pair<unsigned int, unsigned int>, int> ranksOfParts;
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    const FrameAnswers told = Read(all[rank]);
    for (const auto& part : told.OpenParts)
    {
      this->DividedParts += ++ranksOfParts[part] == 2 ? 1 : 0;
    }
    this->CulledParts += rank > 0 ? told.CulledParts : 0;
    for (std::size_t i = 0; i < std::min(this->Layers.size(), told.Layers.size()); ++i)
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
