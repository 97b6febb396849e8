#ifndef VITRINE_CORE_GEOMETRY_PIXEL_REGION_H
#define VITRINE_CORE_GEOMETRY_PIXEL_REGION_H

namespace vitrine
{

/**
 * A rectangle of pixels in window coordinates (DC). It spans X to X + Width - 1 and Y to Y + Height - 1; the origin is
 * at the bottom left.
 */
struct PixelRegion
{
  int X = 0;
  int Y = 0;
  int Width = 0;
  int Height = 0;

  bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }
  bool operator==(const PixelRegion& other) const
  {
    return this->X == other.X && this->Y == other.Y && this->Width == other.Width &&
      this->Height == other.Height;
  }
};

}

#endif
