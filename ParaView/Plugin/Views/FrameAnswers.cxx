#include "FrameAnswers.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPVSession.h"

#include <algorithm>
#include <cstddef>
#include <utility>

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
         << static_cast<unsigned int>(answers.Layers.size());
  for (const LayerOfPixel& layer : answers.Layers)
  {
    stream << layer.Representation << layer.Block << layer.Depth << layer.Distance << layer.Share;
  }
}

FrameAnswers Read(vtkMultiProcessStream& stream)
{
  FrameAnswers answers;
  vtkTypeInt64 fragments = 0, layers = 0, culled = 0;
  unsigned int count = 0;
  stream >> answers.Reason >> fragments >> layers >> answers.CullingReason >> culled >>
    answers.LayersProblem >> count;
  answers.Fragments = static_cast<vtkIdType>(fragments);
  answers.MostLayers = static_cast<vtkIdType>(layers);
  answers.CulledParts = static_cast<vtkIdType>(culled);
  answers.Layers.resize(count);
  for (LayerOfPixel& layer : answers.Layers)
  {
    stream >> layer.Representation >> layer.Block >> layer.Depth >> layer.Distance >> layer.Share;
  }
  return answers;
}

/** Returns the alphas of layers, from their shares of a picture. */
std::vector<double> AlphasOf(const std::vector<LayerOfPixel>& layers)
{
  std::vector<double> alphas;
  double left = 1.0;
  for (const LayerOfPixel& layer : layers)
  {
    alphas.push_back(left > 0.0 ? layer.Share / left : 0.0);
    left -= layer.Share;
  }
  return alphas;
}

/** Adds the layers of another rank, down to the nearest opaque one of both. */
void Merge(const std::vector<LayerOfPixel>& more, std::vector<LayerOfPixel>& layers)
{
  constexpr double Opaque = 1.0 - 1e-6;
  std::vector<std::pair<LayerOfPixel, double>> all;
  for (const std::vector<LayerOfPixel>* some : { &std::as_const(layers), &more })
  {
    const std::vector<double> alphas = AlphasOf(*some);
    for (std::size_t i = 0; i < some->size(); ++i)
    {
      all.emplace_back((*some)[i], alphas[i]);
    }
  }
  std::stable_sort(all.begin(), all.end(),
    [](const auto& a, const auto& b) { return a.first.Depth < b.first.Depth; });
  layers.clear();
  double left = 1.0;
  for (auto& [layer, alpha] : all)
  {
    layer.Share = left * alpha;
    layers.push_back(layer);
    left -= layer.Share;
    if (alpha > Opaque)
    {
      break;
    }
  }
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
    this->LayersProblem = this->LayersProblem.empty() ? told.LayersProblem : this->LayersProblem;
    Merge(told.Layers, this->Layers);
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
