// Nodes of two words: what their fewer bits of alpha and depth still tell apart.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

// These alphas lie just below one that compact nodes can store. Stored as that one, they only leave the rounding of the
// picture.
TEST(CompactNodes, KeepTheNearestAlpha)
{
  TestScene scene(4, 4);
  vtkNew<vtkLinkedListTransparencyPass> pass;
  pass->SetColorStorageToCompact();
  std::vector<vtkSmartPointer<vtkActor>> plates;
  for (const double z : { -0.4, -0.2, 0.0, 0.2 })
  {
    plates.push_back(scene.AddPlate(z, { 1.0, 0.0, 1.0, 0.5 }));
  }
  scene.Use(pass);
  for (int code = 0; code < 100; ++code)
  {
    SCOPED_TRACE(code);
    const double alpha = 0.25 * (1.0 + (code + 0.95) / 256.0);
    for (const auto& plate : plates)
    {
      plate->GetProperty()->SetOpacity(alpha);
    }
    const std::vector<Rgba> stack(plates.size(), { 1.0, 0.0, 1.0, alpha });
    ExpectColor(UniformColor(scene.Render()), CompositePlates(stack, TestBackground), 0.55);
  }
}

// Two faces near the near plane diverge from a common edge to a last bit of a float. In the middle that is a tenth of a
// step of a 24-bit depth buffer. In one of both draws, their colours would order them wrongly.
TEST(CompactNodes, OrderNearDepthsToTheBit)
{
  const Rgba colors[] = { { 0.9, 0.1, 0.1, 0.5 }, { 0.1, 0.1, 0.9, 0.6 } };
  for (const int first : { 0, 1 })
  {
    SCOPED_TRACE(first);
    TestScene scene;
    const double z = 0.75f;
    const double nearer = std::nextafter(0.75f, 1.0f);
    scene.AddTriangle(
      { { { -1.0, -1.0, z }, { 3.0, -1.0, 0.9 }, { -1.0, 3.0, z } } }, colors[first]);
    scene.AddTriangle(
      { { { -1.0, -1.0, z }, { 3.0, -1.0, 0.9 }, { -1.0, 3.0, nearer } } }, colors[1 - first]);
    vtkNew<vtkLinkedListTransparencyPass> pass;
    pass->SetColorStorageToCompact();
    ExpectTruth(scene, pass, 0.9);
  }
}

}
