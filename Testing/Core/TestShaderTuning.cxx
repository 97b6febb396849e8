// Rewriting of VTK's shaders: what moves, what stays, and what is left alone.
#include "Contains.h"

#include "Core/shader/ShaderTuning.h"

#include <gtest/gtest.h>

namespace
{

const std::string Vertex =
  "#version 150\nin vec4 vertexMC;\nuniform float shared;\nvoid main()\n{\n"
  "  gl_Position = vertexMC;\n}\n";

TEST(FlatVaryings, TakeThePlaceOfScalarsAndVectors)
{
  std::string vertex = Vertex;
  std::string fragment = "uniform float opacityUniform; // the opacity\n  uniform vec3 diffuse;\n"
                         "uniform int count;\nuniform uvec2 pair;\nvoid main() { use(diffuse); }\n";
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 4);
  EXPECT_FALSE(Contains(fragment, "uniform "));
  EXPECT_TRUE(Contains(fragment, "flat in vec3 vitrineFlat_diffuse;\n"));
  EXPECT_TRUE(Contains(fragment, "#define diffuse vitrineFlat_diffuse\n"));
  EXPECT_TRUE(Contains(fragment, "void main() { use(diffuse); }"));
  EXPECT_TRUE(Contains(vertex, "uniform vec3 diffuse;\nflat out vec3 vitrineFlat_diffuse;\n"));
  // Set at the end of main().
  const std::size_t assignment = vertex.find("vitrineFlat_diffuse = diffuse;");
  ASSERT_NE(assignment, std::string::npos);
  EXPECT_GT(assignment, vertex.find("gl_Position"));
  EXPECT_LT(assignment, vertex.rfind('}'));
  EXPECT_LT(vertex.find("flat out"), vertex.find("void main"));
}

TEST(FlatVaryings, DeclareNoUniformTwice)
{
  std::string vertex = Vertex;
  std::string fragment = "uniform float shared;\nvoid main() {}\n";
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 1);
  EXPECT_EQ(vertex.find("uniform float shared;"), vertex.rfind("uniform float shared;"));
  EXPECT_TRUE(Contains(vertex, "vitrineFlat_shared = shared;"));
}

// As vtkOpenGLRenderer of VTK 9.1 declares two positional lights.
TEST(FlatVaryings, TakeTwoDeclarationsOfALine)
{
  std::string vertex = Vertex;
  std::string fragment =
    "uniform vec3 lightColor0;\n  uniform float shared; uniform int lightPositional0;uniform vec3 "
    "lightColor1; // both; uniform int none;\nuniform float a[2];uniform float b;\nvoid main() "
    "{}\n";
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 5);
  for (const std::string name : { "lightColor0", "shared", "lightPositional0", "lightColor1", "b" })
  {
    EXPECT_TRUE(Contains(fragment, "#define " + name + " vitrineFlat_" + name + "\n")) << name;
    EXPECT_TRUE(Contains(vertex, "vitrineFlat_" + name + " = " + name + ";")) << name;
  }
  EXPECT_TRUE(Contains(fragment, " // both; uniform int none;\n"));
  EXPECT_TRUE(Contains(fragment, "uniform float a[2];"));
}

TEST(FlatVaryings, NeverRepeatAUniformBehindAnother)
{
  std::string vertex = "uniform int x;uniform vec3 y;\nvoid main()\n{\n}\n";
  std::string fragment = "uniform int x;uniform vec3 y;\nvoid main() {}\n";
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 2);
  EXPECT_EQ(vertex.find("uniform vec3 y;"), vertex.rfind("uniform vec3 y;"));
}

TEST(FlatVaryings, LeaveArraysMatricesAndSamplers)
{
  const std::string original =
    "uniform vec3 lightColor[6];\nuniform mat4 MCDCMatrix;\nuniform sampler2D texture1;\n"
    "uniform usamplerBuffer nodes;\nuniform float a, b;\n// uniform float comment;\n"
    "layout(r32ui) uniform uimage2D heads;\nuniform bool flag;\nvoid main() {}\n";
  std::string vertex = Vertex;
  std::string fragment = original;
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 0);
  EXPECT_EQ(fragment, original);
  EXPECT_EQ(vertex, Vertex);
}

TEST(FlatVaryings, LeaveWhatVaryingsHaveNoRoomFor)
{
  std::string vertex = Vertex;
  std::string fragment;
  for (int i = 0; i < 40; ++i)
  {
    fragment += "uniform float u" + std::to_string(i) + ";\n";
  }
  fragment += "void main() {}\n";
  const int moved = vitrine::PassUniformsAsFlatVaryings(vertex, fragment);
  EXPECT_GT(moved, 0);
  EXPECT_LT(moved, 40);
  EXPECT_TRUE(Contains(fragment, "\nuniform float u39;\n"));
}

TEST(FlatVaryings, NeedAVertexShader)
{
  std::string vertex;
  std::string fragment = "uniform float a;\nvoid main() {}\n";
  const std::string original = fragment;
  EXPECT_EQ(vitrine::PassUniformsAsFlatVaryings(vertex, fragment), 0);
  EXPECT_EQ(fragment, original);
  EXPECT_TRUE(vertex.empty());
}

TEST(SpecularPower, IsDroppedWithItsArguments)
{
  std::string fragment =
    "float sf = df > 0.0 ? pow( max(1e-5, dot(reflect(lightDir, normalVCVSOutput),"
    " normalize(-vertexVC.xyz))), specularPower) : 0.0;\nfloat g = pow(x, 2.2);\n"
    "sf += pow(y, specularPower);\n";
  EXPECT_TRUE(vitrine::DropSpecularPower(fragment));
  EXPECT_EQ(fragment, "float sf = df > 0.0 ? 0.0 : 0.0;\nfloat g = pow(x, 2.2);\nsf += 0.0;\n");
}

TEST(SpecularPower, IsNotThereOrNotWhole)
{
  for (const std::string original :
    { "", "float g = pow(x, 2.2);\n", "pow(x, specularPower", "pow(", "specularPower)" })
  {
    std::string fragment = original;
    EXPECT_FALSE(vitrine::DropSpecularPower(fragment)) << original;
    EXPECT_EQ(fragment, original);
  }
}

}
