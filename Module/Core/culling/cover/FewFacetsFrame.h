#ifndef VITRINE_CORE_CULLING_COVER_FEW_FACETS_FRAME_H
#define VITRINE_CORE_CULLING_COVER_FEW_FACETS_FRAME_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/screen/MeshProjection.h"
#include "Core/geometry/Lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vitrine
{

/** The lines and columns of the screen that a mesh may cover. Places in it count from the first of them. */
struct FewFacetsFrame
{
  LineRange Lines;
  float Left, Right;
  float Inset; ///< from the sides of a line to its samples

  VITRINE_INLINE FewFacetsFrame(const SBuffer& buffer, const ScreenRectangle& around)
    : Left(std::max(around.Left, 0.0f))
    , Right(std::min(around.Right, static_cast<float>(buffer.Columns())))
    , Inset(buffer.Samples().Inset())
  {
    const float bottom = std::max(around.Bottom, 0.0f);
    const float top = std::min(around.Top, static_cast<float>(buffer.Lines()));
    if (this->Left <= this->Right && bottom <= top)
    {
      this->Lines = { static_cast<int>(std::ceil(bottom - this->Inset)),
        static_cast<int>(std::floor(top - 1.0f + this->Inset)) };
    }
  }

  /** Returns the middle of the first line. */
  float FirstMiddle() const { return static_cast<float>(this->Lines.First) + 0.5f; }

  float Width() const { return this->Right - this->Left; }
  float Height() const { return static_cast<float>(this->Lines.Last - this->Lines.First); }

  /** Returns the distance from the middle of a line to its farthest samples. */
  float HalfLine() const { return 0.5f - this->Inset; }
};

/** The points of a mesh, relative to the first column and the middle of the first line of a frame. */
struct PointLanes
{
  Lanes X, Y, Depth;

  VITRINE_INLINE PointLanes(const MeshProjection& projection, const FewFacetsFrame& frame)
    : X(LoadLanes(projection.ColumnsOfPoints().data()) - frame.Left)
    , Y(LoadLanes(projection.LinesOfPoints().data()) - frame.FirstMiddle())
    , Depth(LoadLanes(projection.DepthsOfPoints().data()))
  {
  }

  VITRINE_INLINE PointLanes(const PointLanes& points, const std::int32_t* lanes)
    : X(Picked(points.X, LoadMask(lanes)))
    , Y(Picked(points.Y, LoadMask(lanes)))
    , Depth(Picked(points.Depth, LoadMask(lanes)))
  {
  }
};

}

#endif
