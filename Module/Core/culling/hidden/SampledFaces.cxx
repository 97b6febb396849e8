#include "Core/culling/hidden/SampledFaces.h"

#include <algorithm>

namespace vitrine
{

VITRINE_FOR_EACH_PROCESSOR
void SampledFaces::Begin(
  const MeshProjection& projection, const SampleGrid& samples, const glm::vec2& growth)
{
  this->Projection = &projection;
  const std::vector<float>& columns = projection.ColumnsOfPoints();
  const std::vector<float>& lines = projection.LinesOfPoints();
  const float across = projection.Margin().Column + growth.x;
  const float up = projection.Margin().Line + growth.y;
  this->Points.resize(std::max(columns.size(), this->Points.size()));
  for (std::size_t i = 0; i < columns.size(); i += LaneCount)
  {
    const std::size_t first = std::min(i, columns.size() - LaneCount);
    const Lanes column = LoadLanes(&columns[first]), line = LoadLanes(&lines[first]);
    const Lanes unknown =
      (column - column) + (line - line); // 0, or no number if either is not finite
    const Lanes left = column + unknown - across, bottom = line + unknown - up;
    const SampleCounts ofColumns = samples.CountUpTo(left, column + across);
    const SampleCounts ofLines = samples.CountUpTo(bottom, line + up);
    StoreInterleaved(
      ofColumns.Least, -ofColumns.Most, ofLines.Least, -ofLines.Most, &this->Points[first].All);
  }
}

VITRINE_FOR_EACH_PROCESSOR
void SampledFaces::Add(std::size_t first, std::size_t end, std::vector<std::uint32_t>& to) const
{
  const std::vector<MeshFace>& faces = this->Projection->Faces();
  for (std::size_t i = first; i < end; ++i)
  {
    if (this->MayHaveAny(faces[i]))
    {
      to.push_back(static_cast<std::uint32_t>(i));
    }
  }
}

VITRINE_FOR_EACH_PROCESSOR
void SampledFaces::Add(
  const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& to) const
{
  for (const std::uint32_t face : faces)
  {
    if (this->MayHaveAny(this->Projection->Faces()[face]))
    {
      to.push_back(face);
    }
  }
}

/**
 * Returns true if more samples come before the farthest corner than before the nearest one, both in columns and in
 * lines.
 */
VITRINE_INLINE bool SampledFaces::MayHaveAny(const MeshFace& face) const
{
  const HalfMask a = this->Points[face[0]].All, b = this->Points[face[1]].All,
                 c = this->Points[face[2]].All;
  const HalfMask ab = Chosen(a < b, a, b);
  const HalfMask least = Chosen(ab < c, ab, c);
  return least[0] + least[1] < 0 && least[2] + least[3] < 0;
}

}
