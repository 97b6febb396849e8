#include "Core/culling/cover/PatchEdges.h"

#include <algorithm>

namespace vitrine
{

void PatchEdges::Find(const Subject& subject)
{
  this->Current = subject;
  this->FindSheets();
  this->Pieces.clear();
  this->Heads.assign(this->IndexOf(subject.Lines.Last) + 1, None);
  this->ForEachEdge([this](const MeshEdge& edge, std::uint32_t left, std::uint32_t right)
    { this->AddEdge(edge, left, right); });
}

/** Calls `work` with each edge and the patches on both sides. Edges within a patch do not count. */
template <class Work>
void PatchEdges::ForEachEdge(const Work& work) const
{
  for (const MeshEdge& edge : this->Current.Projection->Edges())
  {
    const std::uint32_t left = this->Current.Patches->IndexOf(edge.Left);
    const std::uint32_t right =
      edge.Right == OccluderMesh::NoFace ? None : this->Current.Patches->IndexOf(edge.Right);
    if (left != right)
    {
      work(edge, left, right);
    }
  }
}

void PatchEdges::FindSheets()
{
  this->Parents.resize(this->Current.Patches->Count());
  for (std::uint32_t i = 0; i < this->Parents.size(); ++i)
  {
    this->Parents[i] = i;
  }
  this->ForEachEdge(
    [this](const MeshEdge&, std::uint32_t left, std::uint32_t right)
    {
      if (left != None && right != None)
      {
        const std::uint32_t a = this->SheetOf(left);
        const std::uint32_t b = this->SheetOf(right);
        this->Parents[std::max(a, b)] = std::min(a, b);
      }
    });
}

/** Returns the first patch of the sheet that a patch belongs to. Halves the path to it (R. E. Tarjan, 1975). */
std::uint32_t PatchEdges::SheetOf(std::uint32_t patch)
{
  while (this->Parents[patch] != patch)
  {
    this->Parents[patch] = this->Parents[this->Parents[patch]];
    patch = this->Parents[patch];
  }
  return patch;
}

/** @param left, right  the patches on both sides in the direction of the edge */
void PatchEdges::AddEdge(const MeshEdge& edge, std::uint32_t left, std::uint32_t right)
{
  const MeshProjection& projection = *this->Current.Projection;
  const ScreenEdge onScreen(projection.Point(edge.From), projection.Point(edge.To));
  const float own = onScreen.OwnRounding();
  const float above = projection.Margin().Line + own - this->Current.Inset;
  const float aside = projection.Margin().Column + own;
  const bool isLeftSmaller =
    onScreen.GoesUp() == (this->Current.Facing == MeshProjection::Facing::Front);
  const std::uint32_t sheet = this->SheetOf(left != None ? left : right);
  const LineRange lines =
    LinesBetween(onScreen.Bottom().Line - above, onScreen.Top().Line + above, this->Current.Lines);
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    if (!this->Current.Open->IsOpen(line))
    {
      continue;
    }
    const float bottom = static_cast<float>(line);
    LineExtent touched;
    touched.Add(onScreen, bottom - above, bottom + 1.0f + above);
    if (!touched.IsEmpty())
    {
      const bool isCrossing = onScreen.Crosses(bottom + 0.5f);
      std::uint32_t& head = this->Heads[this->IndexOf(line)];
      this->Pieces.push_back({ { touched.Left - aside, touched.Right + aside },
        isCrossing ? onScreen.At(bottom + 0.5f) : 0.0f, isLeftSmaller ? left : right,
        isLeftSmaller ? right : left, sheet, isCrossing, head });
      head = static_cast<std::uint32_t>(this->Pieces.size() - 1);
    }
  }
}

}
