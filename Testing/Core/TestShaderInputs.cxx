// Fragment shaders that see their inputs somewhere else.
#include "Core/ShaderInputs.h"

#include <gtest/gtest.h>

namespace
{

std::string Moved(std::string shader)
{
  EXPECT_EQ(vitrine::MoveInputs(shader, "vec2(0.5)", "z"), "");
  return shader;
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

const std::string Main = "void main()\n{\n  use(colorVCVSOutput);\n}\n";

TEST(ShaderInputs, AreReplacedInMain)
{
  EXPECT_EQ(Moved("in vec4 colorVCVSOutput;\n" + Main),
    "in vec4 colorVCVSOutput;\n"
    "vec4 vitrineMoved_colorVCVSOutput;\n"
    "void vitrineMoveInputs()\n{\n"
    "  vec2 offset = vec2(0.5);\n"
    "  z = gl_FragCoord.z + dFdx(gl_FragCoord.z) * offset.x + dFdy(gl_FragCoord.z) * offset.y;\n"
    "  vitrineMoved_colorVCVSOutput = colorVCVSOutput + dFdx(colorVCVSOutput) * offset.x + "
    "dFdy(colorVCVSOutput) * offset.y;\n"
    "}\n"
    "#define colorVCVSOutput vitrineMoved_colorVCVSOutput\n"
    "void main()\n{\n  vitrineMoveInputs();\n\n  use(colorVCVSOutput);\n}\n");
}

TEST(ShaderInputs, ThatHaveNoSlopeStay)
{
  for (const char* line : { "flat in vec4 colorVCVSOutput;", "in float colorVCVSOutput[6];",
         "uniform vec4 colorVCVSOutput;", "flat in int colorVCVSOutput;",
         "//in vec4 colorVCVSOutput;", "int inside;" })
  {
    EXPECT_FALSE(Contains(Moved(std::string(line) + "\n" + Main), "#define")) << line;
  }
}

TEST(ShaderInputs, OfTypesWithSlopeAllMove)
{
  for (const std::string type : { "float", "vec2", "vec3", "vec4" })
  {
    EXPECT_TRUE(Contains(Moved("in " + type + " tcoord; in vec3 other;\n" + Main),
      "#define tcoord vitrineMoved_tcoord\n#define other vitrineMoved_other\n"))
      << type;
  }
}

// Moved, they would be the same all over a group, and their derivatives nothing.
TEST(ShaderInputs, WhoseDerivativesAreTakenStay)
{
  const std::string inputs =
    "in vec4 vertexVCVSOutput;\nin vec4 edgeGSOutput;\nin vec2 raw;\nin vec3 normalVCVSOutput;\n";
  const std::string moved = Moved(inputs +
    "void main()\n{\n  vec4 vertexVC = vertexVCVSOutput;\n  a = dFdx(vertexVC.xyz); "
    "b = dFdx(raw); c = dFdx(edge);\n}\n");
  EXPECT_TRUE(Contains(moved, "#define normalVCVSOutput"));
  EXPECT_FALSE(Contains(moved, "#define vertexVCVSOutput"));
  EXPECT_FALSE(Contains(moved, "#define edgeGSOutput"));
  EXPECT_FALSE(Contains(moved, "#define raw"));
}

TEST(ShaderInputs, NeedAMain)
{
  std::string shader = "in vec4 a;\n";
  EXPECT_NE(vitrine::MoveInputs(shader, "vec2(0.0)", "z"), "");
  EXPECT_EQ(shader, "in vec4 a;\n");
}

}
