// The linked-list pass's node pool: growth within a frame, limits kept in bands, shrinking, and what it costs.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/DeviceTraits.h"
#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

constexpr int Width = 16;
constexpr int Height = 16;
constexpr int Granule = 16; // pages of several nodes come in whole groups of so many

bool HasFramebufferFetch()
{
  return vitrine::FindDeviceTraits().FramebufferFetch;
}

class MemoryPool : public testing::TestWithParam<int>
{
protected:
  vtkSmartPointer<vtkLinkedListTransparencyPass> MakePass() const
  {
    auto pass = vtkSmartPointer<vtkLinkedListTransparencyPass>::New();
    pass->SetColorStorage(GetParam());
    return pass;
  }
  int NodeBytes() const { return GetParam() == vtkLinkedListTransparencyPass::HALF_FLOAT ? 12 : 8; }
  // Nodes of the pages with which a new pass begins, and the bytes of such a page.
  int PageSize() const { return HasFramebufferFetch() ? 4 : 1; }
  vtkTypeInt64 PageBytes() const { return this->PageSize() * this->NodeBytes() + 4; }

  // Bytes of a pool of the page size that takes the least, for `pixels` pixels of `layers` or one more each.
  vtkTypeInt64 LeastBytes(int layers, int pixels, vtkTypeInt64 fragments) const
  {
    vtkTypeInt64 least = fragments * (this->NodeBytes() + 4);
    for (const int size : { 2, 4, 8 })
    {
      const vtkTypeInt64 longer = fragments - vtkTypeInt64(layers) * pixels;
      const vtkTypeInt64 pages =
        longer * ((layers + size) / size) + (pixels - longer) * ((layers + size - 1) / size);
      const vtkTypeInt64 groups = (pages + Granule - 1) / Granule;
      const vtkTypeInt64 bytes = groups * Granule * (size * this->NodeBytes() + 4);
      least = HasFramebufferFetch() ? std::min(least, bytes) : least;
    }
    return least;
  }
};

TEST_P(MemoryPool, GrowsWithinAFrame)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(8, 0.3, 1), 2);
  const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
  ExpectTruth(scene, pass, 2.0);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2); // the pool was empty
  EXPECT_EQ(pass->GetNumberOfBands(), 1);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Render();
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
  }

  const vtkTypeInt64 before = pass->GetPoolBytes();
  scene.AddPlates(RandomPlates(80, 0.05, 3), 4);
  ExpectTruth(scene, pass, 2.0);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 2);
  EXPECT_GT(pass->GetPoolBytes(), 8 * before);
  scene.Render();
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
}

TEST_P(MemoryPool, KeepsItsLimitAndThePicture)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(8, 0.3, 5), 6);
  scene.AddTriangle(
    { { { -0.9, -0.9, -0.5 }, { 0.9, -0.6, 0.1 }, { 0.0, 0.9, 0.7 } } }, { 0.9, 0.9, 0.3, 0.6 });
  const vtkSmartPointer<vtkLinkedListTransparencyPass> unlimited = this->MakePass();
  scene.Use(unlimited);
  const Picture expected = scene.Render();
  const vtkTypeInt64 fragments = unlimited->GetNumberOfFragments();
  ASSERT_GT(fragments, 8 * Width * Height);
  ASSERT_EQ(unlimited->GetMaximumNumberOfLayers(), 9);

  const vtkTypeInt64 needed = this->LeastBytes(8, Width * Height, fragments);
  const vtkTypeInt64 step = Granule * this->PageBytes();
  const struct
  {
    vtkTypeInt64 Limit;
    int BandsMin;
    int BandsMax;
  } cases[] = {
    { needed, 1, 1 },
    { needed + step, 1, 1 },
    { needed - 1, 2, 2 },
    { needed - step, 2, 2 },
    { needed / 7, 8, 16 },
    { 2 * step, 2, Width * Height },
    { step, 2, Width * Height },
  };
  for (const auto& c : cases)
  {
    SCOPED_TRACE("limit " + std::to_string(c.Limit) + " of " + std::to_string(needed));
    const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
    pass->SetMemoryLimit(c.Limit);
    scene.Use(pass);
    EXPECT_TRUE(Matches(scene.Render(), expected));
    EXPECT_GE(pass->GetNumberOfBands(), c.BandsMin);
    EXPECT_LE(pass->GetNumberOfBands(), c.BandsMax);
    EXPECT_EQ(pass->GetNumberOfGeometryPasses(),
      pass->GetNumberOfBands() == 1 ? 2 : 1 + pass->GetNumberOfBands());
    for (int frame = 1; frame < 3; ++frame)
    {
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_LE(pass->GetPoolBytes(), c.Limit);
      EXPECT_EQ(pass->GetNumberOfFragments(), fragments);
      EXPECT_EQ(pass->GetMaximumNumberOfLayers(), 9);
      EXPECT_DOUBLE_EQ(pass->GetMeanNumberOfLayers(), double(fragments) / (Width * Height));
      // Its pages may have another size from now on.
      EXPECT_TRUE(Matches(scene.Render(), expected)) << "frame " << frame;
    }
  }
}

// A screen bin takes its pages from one sub-pool first. Here 5 bins of 64x64 pixels, or parts of them, fill all
// sub-pools to the last page. The last bin has twice the layers of the others. Pages of 8 nodes are all full.
TEST_P(MemoryPool, LeavesNoPageOfASubPoolUnused)
{
  constexpr int Wide = 300;
  TestScene scene(Wide, Height);
  const double aspect = double(Wide) / Height;
  for (int layer = 0; layer < 16; ++layer)
  {
    const double left = layer < 8 ? -1.0 : 2.0 * 256 / Wide - 1.0;
    scene.AddRectangle(
      left * aspect, -1.0, aspect, 1.0, 0.8 - 0.1 * layer, { 0.2, 0.06 * layer, 0.6, 0.3 });
  }
  const vtkSmartPointer<vtkLinkedListTransparencyPass> unlimited = this->MakePass();
  ExpectTruth(scene, unlimited, 2.0);
  const Picture expected = scene.Render();
  const vtkTypeInt64 fragments = unlimited->GetNumberOfFragments();
  ASSERT_EQ(fragments, 8 * Height * (Wide + (Wide - 256)));
  const int pageSize = this->PageSize() > 1 ? 8 : 1;
  const vtkTypeInt64 needed = fragments / pageSize * (pageSize * this->NodeBytes() + 4);
  for (const bool isEnough : { true, false })
  {
    SCOPED_TRACE(isEnough ? "enough" : "one byte less");
    const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
    pass->SetMemoryLimit(isEnough ? needed : needed - 1);
    scene.Use(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), expected)) << "frame " << frame;
      EXPECT_EQ(pass->GetNumberOfBands(), isEnough ? 1 : 2);
      EXPECT_LE(pass->GetPoolBytes(), needed);
      EXPECT_STREQ(pass->GetFallbackReason(), "");
    }
  }
}

TEST_P(MemoryPool, NeedsPagesOfOneNodeForAPixelThatExceedsTheLimit)
{
  TestScene scene(Width, Height);
  scene.AddPlates(RandomPlates(100, 0.05, 7), 8);
  scene.Render(); // the driver's extensions, by which pages have a size, are known then
  const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
  pass->SetMemoryLimit(Granule * this->PageBytes());
  scene.Use(pass);
  scene.Render();
  const vtkTypeInt64 need = 100 * (this->NodeBytes() + 4);
  ExpectRefusal(pass, "one pixel alone needs " + std::to_string(need) + " bytes");
}

TEST_P(MemoryPool, SettlesCloseToTheNeed)
{
  TestScene scene(48, 36);
  scene.AddPlates(RandomPlates(90, 0.05, 9), 10);
  scene.AddSphere(0.0, 0.0, 0.0, 0.8, { 0.9, 0.2, 0.2, 0.5 });
  const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
  scene.Use(pass);
  for (int frame = 0; frame < 40; ++frame)
  {
    scene.Render();
  }
  const double plain = static_cast<double>(pass->GetNumberOfFragments()) * (this->NodeBytes() + 4);
  EXPECT_LE(pass->GetPoolBytes(), 1.3 * plain);
  EXPECT_GE(pass->GetPoolBytes(), pass->GetNumberOfFragments() * this->NodeBytes());
  EXPECT_GT(pass->GetBytes(), pass->GetPoolBytes());
}

TEST_P(MemoryPool, HoldsStillWhereTheUseSwings)
{
  TestScene scene(32, 24);
  scene.AddPlates(RandomPlates(16, 0.05, 15), 16);
  const vtkSmartPointer<vtkActor> more = scene.AddPlates(RandomPlates(16, 0.05, 17), 18);
  const vtkSmartPointer<vtkLinkedListTransparencyPass> pass = this->MakePass();
  scene.Use(pass);
  int changes = 0;
  vtkTypeInt64 previous = 0;
  for (int frame = 0; frame < 80; ++frame)
  {
    more->SetVisibility(frame / 3 % 2 == 0);
    scene.Render();
    changes += pass->GetPoolBytes() != previous ? 1 : 0;
    previous = pass->GetPoolBytes();
    if (frame > 0)
    {
      EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1) << "frame " << frame;
    }
  }
  EXPECT_LE(changes, 2);
}

INSTANTIATE_TEST_SUITE_P(Storage, MemoryPool,
  testing::Values(vtkLinkedListTransparencyPass::HALF_FLOAT,
    vtkLinkedListTransparencyPass::EIGHT_BIT, vtkLinkedListTransparencyPass::COMPACT),
  StorageName());

TEST(PagesAtTheLimit, AreOfOneNodeWhereLargerOnesDoNotFit)
{
  const std::vector<Rgba> plates = RandomPlates(80, 0.05, 7);
  TestScene scene(4, 4);
  scene.AddPlates(plates, 8);
  vtkNew<vtkLinkedListTransparencyPass> unlimited;
  scene.Use(unlimited);
  const Picture expected = scene.Render();
  for (const int limit : { 80 * 16, 1300, 1600, 2000, 3100 })
  {
    SCOPED_TRACE(limit);
    vtkNew<vtkLinkedListTransparencyPass> pass;
    pass->SetMemoryLimit(limit);
    scene.Use(pass);
    for (int frame = 0; frame < 3; ++frame)
    {
      EXPECT_TRUE(Matches(scene.Render(), expected));
      EXPECT_STREQ(pass->GetFallbackReason(), "");
      EXPECT_GT(pass->GetNumberOfBands(), 1);
      EXPECT_LE(pass->GetPoolBytes(), limit);
    }
  }
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetMemoryLimit(80 * 16 - 1);
  scene.Use(pass);
  scene.Render();
  ExpectRefusal(
    pass, "one pixel alone needs 1280 bytes of the node pool, and its limit is 1279 bytes");
}

}
