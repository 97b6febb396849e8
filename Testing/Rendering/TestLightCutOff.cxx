// With the default cut-off, no channel of the unrounded picture is off by more than half of 1/255, for any number of
// lights.
#include "DeferredScene.h"
#include "vtkFramebufferPass.h"
#include "vtkPixelBufferObject.h"
#include "vtkTextureObject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{

constexpr double Bound = 0.5 / 255.0;
constexpr double FloatSlack = 1e-6; ///< of sums that leave out some of what they add

using Floats = std::vector<float>;

double LargestDifference(const Floats& a, const Floats& b)
{
  return std::transform_reduce(
    a.begin(), a.end(), b.begin(), 0.0, [](double x, double y) { return std::max(x, y); },
    [](float x, float y) { return std::abs(static_cast<double>(x) - y); });
}

/** Translucent layers are blended by OpenGL into floats, since methods with lists keep 8 bits of a colour. */
struct CutScene : DeferredScene
{
  explicit CutScene(bool isPhysical)
    : DeferredScene(false, isPhysical)
  {
    this->Window->SetSize(31, 23); // every pixel goes through thousands of lights
    this->Steps->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
    this->Target->SetColorFormat(vtkTextureObject::Float32);
    this->Target->SetDepthFormat(vtkTextureObject::Float32);
  }

  Floats Draw(vtkClusteredLightsPass* pass, double cutOff)
  {
    pass->SetCutOff(cutOff);
    this->Target->SetDelegatePass(pass);
    this->Renderer->SetPass(this->Target);
    this->Render();
    vtkTextureObject* const texture = this->Target->GetColorTexture();
    unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
    Floats colors(std::size_t{ 4 } * size[0] * size[1]);
    const auto pixels = vtkSmartPointer<vtkPixelBufferObject>::Take(texture->Download());
    vtkIdType increments[2] = { 0, 0 };
    pixels->Download2D(VTK_FLOAT, colors.data(), size, 4, increments);
    return colors;
  }

  /** The largest error of forward shading, by clusters and by cubes, and of the deferred ones. */
  double LargestError()
  {
    const Floats exact = this->Draw(this->Lights, 0.0);
    EXPECT_GT(
      LargestDifference(exact, Floats(exact.size(), exact[0])), 2.0 * Bound); // there is light
    double largest = LargestDifference(exact, this->Draw(this->Lights, Bound));
    EXPECT_LT(this->Lights->GetMeanNumberOfLightsPerCluster(), this->Lights->GetNumberOfLights());
    this->Lights->SetGridSpace(vtkClusteredLightsPass::WORLD);
    largest = std::max(largest, LargestDifference(exact, this->Draw(this->Lights, Bound)));
    for (const int assignment : DeferredAssignments)
    {
      this->Deferred->SetAssignment(assignment);
      largest = std::max(largest, LargestDifference(exact, this->Draw(this->Deferred, Bound)));
      EXPECT_EQ(this->Deferred->GetNumberOfDeferredProps(), DeferredParts);
    }
    return largest;
  }

  vtkNew<vtkFramebufferPass> Target;
};

class CutOff : public testing::TestWithParam<bool> // whether shading is physically based
{
protected:
  /** With more and more lights, whose number changes no shader. */
  template <class AddLights>
  void ExpectWithinBound(double least, const AddLights& addLights)
  {
    for (const int count : { 64, 256, 1024, 4096 })
    {
      SCOPED_TRACE(count);
      this->Scene.Renderer->RemoveAllLights();
      addLights(count);
      const double error = this->Scene.LargestError();
      EXPECT_LE(error, Bound + FloatSlack);
      EXPECT_GT(error, least);
    }
  }

  void AddStrewn(int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Scene.AddLight(
        i % 2 == 0 ? LightKind::Point : LightKind::Spot, 0.3, 30.0 * count * this->Steeper);
    }
  }

  CutScene Scene = CutScene(GetParam());

  /**
   * Physically based shading raises sums to the power of 1 / 2.2, which makes little light visible. So the light has to
   * fade sooner.
   */
  const double Steeper = GetParam() ? 1e4 : 1.0;
};

TEST_P(CutOff, HoldsForLightsThatAreStrewn)
{
  this->ExpectWithinBound(0.01 * Bound, [&](int count) { this->AddStrewn(count); });
}

// What is left out adds up to a good part of what may be, as all of it is missing from the same places on.
TEST_P(CutOff, HoldsForLightsThatEndTogether)
{
  for (const auto& part : this->Scene.Parts)
  {
    part->GetProperty()->SetRoughness(1.0); // what is reflected is nowhere much less than it may be
  }
  this->ExpectWithinBound(0.5 * Bound,
    [&](int count)
    {
      for (int i = 0; i < count; ++i)
      {
        const auto light =
          this->Scene.AddLight(LightKind::Point, 16.0 / count, 1e4 * this->Steeper);
        light->SetPosition(0.1, 0.1, 0.6);
        light->SetDiffuseColor(1.0, 1.0, 1.0);
      }
    });
}

// Lists are longer or shorter, but what is cut is left out at the same places. Light volumes cut by tiles.
TEST_P(CutOff, LeavesOutTheSameByAnyGrid)
{
  this->AddStrewn(256);
  const Floats expected = this->Scene.Draw(this->Scene.Lights, Bound);
  for (const int slices : { 1, 5 })
  {
    this->Scene.Lights->SetNumberOfSlices(slices);
    this->Scene.Lights->SetTileSize(slices * 8);
    EXPECT_EQ(this->Scene.Draw(this->Scene.Lights, Bound), expected) << slices;
  }
  this->Scene.Lights->SetGridSpace(vtkClusteredLightsPass::WORLD);
  EXPECT_EQ(this->Scene.Draw(this->Scene.Lights, Bound), expected);
  for (const int assignment : { vtkDeferredLightsPass::TILES, vtkDeferredLightsPass::CLUSTERS })
  {
    this->Scene.Deferred->SetAssignment(assignment);
    EXPECT_EQ(this->Scene.Draw(this->Scene.Deferred, Bound), expected) << assignment;
  }
}

INSTANTIATE_TEST_SUITE_P(Shadings, CutOff, testing::Bool(),
  [](const testing::TestParamInfo<bool>& info)
  { return std::string(info.param ? "Physical" : "Phong"); });

}
