// Lights by name (lighting/presets/vtkLightPresets).

#include "TestScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightPresets.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

/** A white plate that faces the camera shows the lights' intensities by the cosines of their angles. */
double LightOfPreset(const char* name)
{
  TestScene scene(8, 8);
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(-2.0, -2.0, 0.0);
  plate->SetPoint1(2.0, -2.0, 0.0);
  plate->SetPoint2(-2.0, 2.0, 0.0);
  scene.AddSource(plate, { 1.0, 1.0, 1.0, 1.0 });
  EXPECT_TRUE(vtkLightPresets::Apply(scene.Renderer, name));
  return 255.0 * scene.Render().At(4, 4)[0];
}

TEST(LightPresets, LightByTheirIntensitiesAndAngles)
{
  EXPECT_NEAR(LightOfPreset("headlight"), 255.0, 1.0);
  const double studio = 0.75 / std::sqrt(2.0) + 0.25 * 0.8 / std::sqrt(1.46) + 0.15;
  EXPECT_NEAR(LightOfPreset("studio"), 255.0 * studio, 1.0);
  EXPECT_NEAR(LightOfPreset("side"), 255.0 * (0.9 / std::sqrt(3.0) + 0.25), 1.0);
  EXPECT_NEAR(LightOfPreset("above"), 255.0 * (0.7 * 0.2 / std::sqrt(1.13) + 0.4), 1.0);
}

TEST(LightPresets, AreToldByNamesAndReplaceLights)
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkLightPresets::GetNumberOfPresets(); ++i)
  {
    names.emplace_back(vtkLightPresets::GetName(i));
  }
  EXPECT_EQ(names, (std::vector<std::string>{ "headlight", "studio", "side", "above" }));
  EXPECT_EQ(vtkLightPresets::GetName(-1), nullptr);
  EXPECT_EQ(vtkLightPresets::GetName(4), nullptr);
  vtkNew<vtkRenderer> renderer;
  for (const auto& [name, count] : std::vector<std::pair<const char*, int>>{
         { "studio", 5 }, { "above", 2 }, { "headlight", 0 }, { "side", 2 } })
  {
    EXPECT_TRUE(vtkLightPresets::Apply(renderer, name));
    EXPECT_EQ(renderer->GetLights()->GetNumberOfItems(), count) << name;
  }
  EXPECT_FALSE(vtkLightPresets::Apply(renderer, "moon"));
  EXPECT_FALSE(vtkLightPresets::Apply(renderer, nullptr));
  EXPECT_FALSE(vtkLightPresets::Apply(nullptr, "side"));
  EXPECT_EQ(renderer->GetLights()->GetNumberOfItems(), 2);
}

}
