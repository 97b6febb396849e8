#include "Core/culling/cover/OpenLines.h"

#include "Core/geometry/Lanes.h"

#include <algorithm>

namespace vitrine
{

namespace
{

/** Returns a bit for a line and each of the seven above it on which a patch may cover something new. */
VITRINE_FOR_EACH_PROCESSOR
unsigned OpenLinesFor(const ScreenPatches::Patch& patch, const SBuffer& buffer, int line)
{
  const SlantedDepth& plane = patch.Bound;
  const float columns = static_cast<float>(buffer.Columns());
  if (!(patch.Left <= columns && patch.Right >= 0.0f))
  {
    return 0;
  }
  const float left = std::max(patch.Left, 0.0f);
  const float right = std::min(patch.Right, columns);
  const Lanes base = LanesFrom(static_cast<float>(line));
  const Lanes bottom = GreatestOf(base, AllLanes(patch.Bottom));
  const Lanes top = LeastOf(base + 1.0f, AllLanes(patch.Top));
  const Lanes farLine = plane.ByLine > 0.0f ? bottom : top;
  const Lanes atOrigin =
    (farLine - plane.Origin.Line) * plane.ByLine + (plane.Origin.Depth - plane.Slack);
  LaneMask isOpen{};
  const int lastTile = (buffer.Columns() - 1) / SBuffer::TileWidth;
  const int last = std::min(static_cast<int>(right) / SBuffer::TileWidth, lastTile);
  for (int tile = static_cast<int>(left) / SBuffer::TileWidth; tile <= last; ++tile)
  {
    const float tileLeft = static_cast<float>(tile * SBuffer::TileWidth);
    const float nearColumn = plane.ByColumn > 0.0f ? std::min(right, tileLeft + SBuffer::TileWidth)
                                                   : std::max(left, tileLeft);
    const Lanes depth = atOrigin + (nearColumn - plane.Origin.Column) * plane.ByColumn;
    isOpen |= ~(buffer.LeastDepths(line, tile) >= GreatestOf(depth, AllLanes(plane.Farthest)));
  }
  return BitsOf(isOpen & (bottom <= top));
}
}

void OpenLines::Find(const SBuffer& buffer, const ScreenPatches& patches, const LineRange& lines)
{
  this->First = lines.First;
  this->AreOpen.assign(static_cast<std::size_t>(lines.Last - lines.First + LaneCount), 0);
  for (std::uint32_t i = 0; i < patches.Count(); ++i)
  {
    const LineRange own = LinesBetween(patches[i].Bottom, patches[i].Top, lines);
    for (int line = own.First; line <= own.Last; line += LaneCount)
    {
      const unsigned open = OpenLinesFor(patches[i], buffer, line);
      for (int lane = 0; open >> lane != 0; ++lane)
      {
        this->AreOpen[static_cast<std::size_t>(line - lines.First + lane)] |= open >> lane & 1u;
      }
    }
  }
  const auto end = this->AreOpen.begin() + (lines.Last - lines.First + 1);
  this->HasOpen = std::find(this->AreOpen.begin(), end, 1) != end;
}

}
