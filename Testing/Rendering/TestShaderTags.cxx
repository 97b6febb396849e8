// A mapper's shader that a method cannot be joined to is an error, never silence.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "transparency/common/FillShader.h"
#include "vtkActor.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkObjectFactory.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

namespace
{

class ShaderTags : public testing::TestWithParam<Method>
{
};

TEST_P(ShaderTags, MissingOnesAreErrors)
{
  for (const char* tag : { "//VTK::DepthPeeling::Impl", "//VTK::DepthPeeling::Dec" })
  {
    SCOPED_TRACE(tag);
    TestScene scene(12, 10);
    const std::vector<Rgba> plates = RandomPlates(5, 0.4, 1);
    scene.AddPlates(plates, 2);
    scene.AddSphere(0.0, 0.0, 0.0, 0.5, { 0.9, 0.5, 0.1, 0.4 })
      ->GetShaderProperty()
      ->AddFragmentShaderReplacement(tag, true, "", false);
    scene.Use(GetParam().Make());
    const Rgba color = UniformColor(scene.Render());
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find(std::string("the shader has no tag ") + tag), std::string::npos)
      << messages[0];
    // All else is drawn as ever.
    ExpectColor(color, CompositePlates(plates, TestBackground), 0.75);
  }
}

// A method whose shader no driver compiles.
class UncompilablePass : public vtkLinkedListTransparencyPass
{
public:
  static UncompilablePass* New();
  vtkTypeMacro(UncompilablePass, vtkLinkedListTransparencyPass);

protected:
  vitrine::FillShader GetFillShader() override
  {
    vitrine::FillShader fill;
    fill.Implementation = "  this is no GLSL;\n";
    return fill;
  }
};
vtkStandardNewMacro(UncompilablePass);

// VTK's mappers crash where their shaders do not compile.
TEST(UncompilableShader, IsDrawnAsVTKDoes)
{
  TestScene scene(12, 10);
  scene.AddPlates(RandomPlates(5, 0.4, 1), 2);
  const Picture byVTK = scene.RenderAsVTK();
  vtkNew<UncompilablePass> pass;
  scene.Use(pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    EXPECT_TRUE(Matches(scene.Render(), byVTK));
    EXPECT_NE(std::string(pass->GetFallbackReason()).find("cannot compile"), std::string::npos);
  }
  EXPECT_FALSE(TakeMessages().empty());
}

INSTANTIATE_TEST_SUITE_P(Methods, ShaderTags, testing::ValuesIn(AllMethods()), MethodName());

}
