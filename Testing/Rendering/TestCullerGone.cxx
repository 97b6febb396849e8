// Props that are gone for good, and others that come in their place.
#include "CullerScene.h"
#include "DividedActor.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <malloc.h>
#include <string>

namespace
{

using CullerGone = CullerTest;

void AddDivided(CullerScene& scene, Division kind, const PartsOfQuads& parts)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(DividedMapperOf(kind, parts));
  actor->GetProperty()->LightingOff();
  scene.Renderer->AddActor(actor);
}

std::size_t BytesInUse()
{
  const struct mallinfo2 all = mallinfo2();
  return all.uordblks + all.hblkhd;
}

// New ones may come to be at their addresses, and pieces of theirs are others' next.
TEST_P(CullerGone, OthersComeInTheirPlace)
{
  TestRandom random(350);
  for (int round = 0; round < 12; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 350");
    Scene.Clear();
    const double wall = random.Unit() < 0.5 ? 0.0 : 0.6;
    Scene.AddWall(wall);
    const int boxes = static_cast<int>(Scene.AddHidden(wall - 0.4).size());
    const bool isBefore = random.Unit() < 0.5;
    const Division kind = random.Unit() < 0.5 ? Division::Blocks : Division::Leaves;
    AddDivided(Scene, kind, Patches(isBefore ? wall + 0.2 : wall - 0.3));
    Scene.LookAhead();
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_EQ(Scene.ExpectSame(), isBefore ? boxes : boxes + PatchCount);
    }
  }
}

// What cannot be hidden has no place: not that of what was hidden at its address either.
TEST_P(CullerGone, WhatCannotBeHiddenComesInTheirPlace)
{
  Scene.AddWall();
  Scene.AddHidden();
  Scene.LookAhead();
  const void* address = nullptr;
  for (int tries = 0; tries < 100; ++tries)
  {
    vtkSmartPointer<vtkActor> gone = Scene.AddBox({ 0.0, 0.0, -0.6 }, { 0.1, 0.1, 0.1 });
    const int hidden = Scene.ExpectSame();
    address = gone;
    Scene.Renderer->RemoveActor(gone);
    gone = nullptr;
    const vtkSmartPointer<vtkActor> next = Scene.MakeBox({ 0.0, 0.0, 0.5 }, { 0.3, 0.3, 0.1 });
    next->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  fragOutput0.r = 1.0;\n", false);
    Scene.Renderer->AddActor(next);
    EXPECT_LT(Scene.ExpectSame(), hidden); // others may shine through it
    Scene.Renderer->RemoveActor(next);
    if (next == address)
    {
      return;
    }
  }
  FAIL() << "no actor has come to be at the address of one that is gone";
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerGone, testing::ValuesIn(CullerSettings()), CullerSettingName);

TEST(CullerGoneParts, GiveTheirMemoryBack)
{
  CullerScene scene({ "", 0, true, 270, 61, 51 });
  const auto fill = [&]
  {
    scene.Clear();
    scene.AddWall();
    for (int i = 0; i < 30; ++i)
    {
      scene.AddSphere(0.1 * (i % 6) - 0.3, 0.1 * (i / 6) - 0.2, 0.3, 0.05, { 1, 1, 1, 1 }, 60);
    }
    AddDivided(scene, Division::Blocks, Patches(0.2));
    AddDivided(scene, Division::Leaves, Patches(0.3));
    scene.LookAhead();
    scene.Render();
    scene.Render();
  };
  const auto empty = [&]
  {
    scene.Clear();
    scene.Render();
    return BytesInUse();
  };
  fill();
  const std::size_t full = BytesInUse();
  const std::size_t before = empty();
  ASSERT_GT(full, before + (std::size_t{ 4 } << 20));
  for (int round = 0; round < 8; ++round)
  {
    fill();
  }
  EXPECT_LT(empty(), before + (full - before) / 4);
}

}
