#include "Core/lists/ScreenBands.h"

#include <algorithm>
#include <cassert>

namespace vitrine
{

namespace
{

// The needs of a region of the picture.
struct NeedView
{
  const std::vector<std::uint32_t>& Need;
  std::size_t Stride;
  PixelRegion Region;

  std::uint32_t At(int x, int y) const { return this->Need[y * this->Stride + x]; }
};

// The need of one row. It lies in the columns First to Last, which are First > Last if the row has none.
struct RowNeed
{
  std::uint64_t Sum = 0;
  int First = 0;
  int Last = -1;
};

RowNeed SumRow(const NeedView& view, int y, std::uint64_t& largestPixel)
{
  RowNeed row;
  for (int x = view.Region.X; x < view.Region.X + view.Region.Width; ++x)
  {
    const std::uint64_t need = view.At(x, y);
    if (need > 0)
    {
      row.First = row.Sum == 0 ? x : row.First;
      row.Last = x;
      row.Sum += need;
      largestPixel = std::max(largestPixel, need);
    }
  }
  return row;
}

// Collects successive rows, or pixels of one row, while their sum fits.
class BandBuilder
{
public:
  BandBuilder(std::uint64_t capacity, std::vector<PixelRegion>& bands)
    : Capacity(capacity)
    , Bands(bands)
  {
  }

  void Add(std::uint64_t need, int firstX, int lastX, int y)
  {
    if (need > this->Capacity - this->Sum)
    {
      this->Flush();
    }
    if (this->Sum == 0)
    {
      this->FirstX = firstX;
      this->LastX = lastX;
      this->FirstY = y;
    }
    this->FirstX = std::min(this->FirstX, firstX);
    this->LastX = std::max(this->LastX, lastX);
    this->LastY = y;
    this->Sum += need;
  }

  void Flush()
  {
    if (this->Sum > 0)
    {
      this->Bands.push_back({ this->FirstX, this->FirstY, this->LastX - this->FirstX + 1,
        this->LastY - this->FirstY + 1 });
      this->Sum = 0;
    }
  }

private:
  std::uint64_t Capacity;
  std::vector<PixelRegion>& Bands;
  std::uint64_t Sum = 0;
  int FirstX = 0;
  int LastX = 0;
  int FirstY = 0;
  int LastY = 0;
};

void CutRow(const NeedView& view, const RowNeed& row, int y, BandBuilder& builder)
{
  builder.Flush();
  for (int x = row.First; x <= row.Last; ++x)
  {
    if (view.At(x, y) > 0)
    {
      builder.Add(view.At(x, y), x, x, y);
    }
  }
  builder.Flush();
}

PixelRegion ClipToPicture(const PixelRegion& region, int width, int height)
{
  const auto clip = [](std::int64_t value, int size)
  { return static_cast<int>(std::clamp<std::int64_t>(value, 0, size)); };
  const int left = clip(region.X, width);
  const int bottom = clip(region.Y, height);
  const int right = clip(std::int64_t{ region.X } + region.Width, width);
  const int top = clip(std::int64_t{ region.Y } + region.Height, height);
  return { left, bottom, std::max(right - left, 0), std::max(top - bottom, 0) };
}

}

BandPlan PlanBands(
  const std::vector<std::uint32_t>& need, int width, int height, std::uint64_t capacity)
{
  return PlanBands(need, width, height, capacity, { 0, 0, width, height });
}

BandPlan PlanBands(const std::vector<std::uint32_t>& need, int width, int height,
  std::uint64_t capacity, const PixelRegion& region)
{
  assert(width >= 0 && height >= 0);
  assert(need.size() == static_cast<std::size_t>(width) * height);
  const NeedView view{ need, static_cast<std::size_t>(width),
    ClipToPicture(region, width, height) };

  BandPlan plan;
  std::vector<RowNeed> rows;
  rows.reserve(view.Region.Height);
  for (int y = view.Region.Y; y < view.Region.Y + view.Region.Height; ++y)
  {
    rows.push_back(SumRow(view, y, plan.LargestPixel));
  }
  plan.Fits = plan.LargestPixel <= capacity;
  if (!plan.Fits)
  {
    return plan;
  }

  BandBuilder builder(capacity, plan.Bands);
  for (int i = 0; i < view.Region.Height; ++i)
  {
    const int y = view.Region.Y + i;
    if (rows[i].Sum > capacity)
    {
      CutRow(view, rows[i], y, builder);
    }
    else if (rows[i].Sum > 0)
    {
      builder.Add(rows[i].Sum, rows[i].First, rows[i].Last, y);
    }
  }
  builder.Flush();
  return plan;
}

std::vector<PixelRegion> CoveringBands(
  const std::vector<PixelRegion>& bands, const PixelRegion& region)
{
  std::vector<PixelRegion> covering;
  int y = region.Y;
  for (auto band = bands.begin(); band != bands.end();)
  {
    // Bands that begin in the same row are parts of it.
    const auto end =
      std::find_if(band, bands.end(), [&](const PixelRegion& b) { return b.Y != band->Y; });
    const int top = end == bands.end() ? region.Y + region.Height : end->Y;
    int x = region.X;
    for (; band != end; ++band)
    {
      const int right = band + 1 == end ? region.X + region.Width : (band + 1)->X;
      covering.push_back({ x, y, right - x, top - y });
      x = right;
    }
    y = top;
  }
  if (covering.empty())
  {
    covering.push_back(region);
  }
  return covering;
}

}
