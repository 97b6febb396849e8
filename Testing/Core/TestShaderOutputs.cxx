// What of a fragment shader's outputs goes, and what stays.
#include "Contains.h"

#include "Core/shader/ShaderOutputs.h"

#include <gtest/gtest.h>

namespace
{

const std::string OfOneColor = "void main()\n{\n  gl_FragData[0] = vec4(1.0);\n}\n";
const std::string OutputsTag = "//VTK::Output::Dec\n";

// The shader after dropping, which must find `dropped` outputs and nothing wrong.
std::string Dropped(std::string shader, int dropped)
{
  int count = -1;
  EXPECT_EQ(vitrine::DropFurtherOutputs(shader, count), "");
  EXPECT_EQ(count, dropped);
  return shader;
}

TEST(ShaderOutputs, OfOneColorStayAsTheyAre)
{
  const std::string shader = OutputsTag + OfOneColor;
  EXPECT_EQ(Dropped(shader, 0), shader);
}

TEST(ShaderOutputs, OfFurtherDataBecomeVariables)
{
  const std::string shader = Dropped(OutputsTag +
      "void main()\n{\n  gl_FragData[0] = vec4(1.0);\n  gl_FragData[2].xy = vec2(0.5);\n"
      "  gl_FragData[1].r = gl_FragData[0].a;\n  gl_FragData[10] = gl_FragData[2];\n}\n",
    3);
  EXPECT_EQ(shader,
    "vec4 vitrineFurtherOutput1;\nvec4 vitrineFurtherOutput10;\nvec4 vitrineFurtherOutput2;\n" +
      OutputsTag +
      "void main()\n{\n  gl_FragData[0] = vec4(1.0);\n  vitrineFurtherOutput2.xy = vec2(0.5);\n"
      "  vitrineFurtherOutput1.r = gl_FragData[0].a;\n  vitrineFurtherOutput10 = "
      "vitrineFurtherOutput2;\n}\n");
}

TEST(ShaderOutputs, ThatAreDeclaredBecomeVariables)
{
  EXPECT_EQ(Dropped("out vec4 position;\n" + OutputsTag + OfOneColor, 1),
    " vec4 position;\n" + OutputsTag + OfOneColor);
  EXPECT_EQ(Dropped("layout(location = 1) out highp uvec2 a, b;\n" + OfOneColor, 1),
    "  highp uvec2 a, b;\n" + OfOneColor);
  EXPECT_EQ(
    Dropped("in vec3 p; layout (location=2)\n  out float a[2]; out int b;\n" + OfOneColor, 2),
    "in vec3 p; \n   float a[2];  int b;\n" + OfOneColor);
  EXPECT_EQ(Dropped("float one() { return 1.0; } out vec4 a;\n" + OfOneColor, 1),
    "float one() { return 1.0; }  vec4 a;\n" + OfOneColor);
}

// The layout of an input, parameters of functions, names, comments and lines for the preprocessor.
TEST(ShaderOutputs, AreNotWhatLooksLikeThem)
{
  const std::string shader = "#define varying out\n// out vec4 a;\n/* out vec4 b; */\n"
                             "layout(early_fragment_tests) in;\nuniform float layout_out, out_;\n"
                             "void part(out vec3 a,\n  out vec3 b)\n{\n  a = b;\n}\n" +
    OutputsTag + OfOneColor;
  EXPECT_EQ(Dropped(shader, 0), shader);
}

TEST(ShaderOutputs, OfDataAskForTheTagOfTheirDeclarations)
{
  const std::string original = "void main()\n{\n  gl_FragData[1] = vec4(1.0);\n}\n";
  std::string shader = original;
  int dropped = 0;
  EXPECT_TRUE(Contains(vitrine::DropFurtherOutputs(shader, dropped), "//VTK::Output::Dec"));
  EXPECT_EQ(shader, original);
}

}
