// Fragment shaders that see their inputs somewhere else.
#include "Contains.h"

#include "Core/shader/ShaderInputs.h"

#include <gtest/gtest.h>

namespace
{

const vitrine::InputPlace Elsewhere = { "vec2(0.5)", "size", "z" };

std::string Moved(std::string shader)
{
  EXPECT_EQ(vitrine::MoveInputs(shader, Elsewhere), "");
  return shader;
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
  EXPECT_NE(vitrine::MoveInputs(shader, Elsewhere), "");
  EXPECT_EQ(shader, "in vec4 a;\n");
}

// What a shader with a moved input t and an unmoved one, f, does in main() becomes of `code`.
std::string Rewritten(const std::string& code)
{
  const std::string body = "\n  vitrineMoveInputs();\n";
  const std::string moved = Moved("uniform sampler2D s; uniform samplerCube c;\n"
                                  "uniform sampler2DArray array;\nuniform sampler2DShadow shadow;\n"
                                  "uniform sampler2D several[3];\n"
                                  "in vec2 t;\nflat in vec2 f;\nvoid main()\n{" +
    code + "}\n");
  const std::size_t at = moved.find(body) + body.size();
  return moved.substr(at, moved.size() - 2 - at);
}

std::string Lookup(const std::string& coordinates, const std::string& unmoved)
{
  return "textureGrad(s, " + coordinates + ", dFdx(" + unmoved + ") * size.x, dFdy(" + unmoved +
    ") * size.y)";
}

TEST(ShaderLookups, ByMovedInputsTakeThePixelsGradients)
{
  const std::string t = "vitrineUnmoved_t";
  EXPECT_EQ(Rewritten("a = texture(s, t);"), "a = " + Lookup("t", t) + ";");
  EXPECT_EQ(Rewritten("texture2D( s,t )"), Lookup("t", t));
  EXPECT_EQ(Rewritten("texture (s, t.st).rgb"), Lookup("t.st", t + ".st") + ".rgb");
  EXPECT_EQ(Rewritten("texture(s, vec2(t, 0.0))"), Lookup("vec2(t, 0.0)", "vec2(" + t + ", 0.0)"));
  EXPECT_EQ(Rewritten("texture(s, m[i, 1] * (f + t))"),
    Lookup("m[i, 1] * (f + t)", "m[i, 1] * (f + " + t + ")"));
  EXPECT_EQ(Rewritten("g(texture(s, t), texture(s, t.ts))"),
    "g(" + Lookup("t", t) + ", " + Lookup("t.ts", t + ".ts") + ")");
  EXPECT_EQ(Rewritten("texture(c, vec3(t, 1.0))"),
    "textureGrad(c, vec3(t, 1.0), dFdx(vec3(vitrineUnmoved_t, 1.0)) * size.x, "
    "dFdy(vec3(vitrineUnmoved_t, 1.0)) * size.y)");
}

TEST(ShaderLookups, WithBiasScaleTheGradients)
{
  EXPECT_EQ(Rewritten("texture(s, t, -1.5)"),
    "textureGrad(s, t, dFdx(vitrineUnmoved_t) * size.x * exp2(-1.5), "
    "dFdy(vitrineUnmoved_t) * size.y * exp2(-1.5))");
}

TEST(ShaderLookups, WithinOthersAreMendedToo)
{
  const std::string inner = Lookup("t", "vitrineUnmoved_t");
  EXPECT_EQ(Rewritten("texture(s, texture(s, t).xy)"),
    Lookup(inner + ".xy", "texture(s, vitrineUnmoved_t).xy"));
  EXPECT_EQ(Rewritten("texture(array, texture(s, t).xyz)"), "texture(array, " + inner + ".xyz)");
}

TEST(ShaderLookups, WidthsAreThePixels)
{
  EXPECT_EQ(Rewritten("if (fwidth(t.x) <= fwidth(f.x))"),
    "if ((abs(dFdx(vitrineUnmoved_t.x) * size.x) + abs(dFdy(vitrineUnmoved_t.x) * size.y)) <= "
    "fwidth(f.x))");
}

TEST(ShaderLookups, OfOtherKindsStay)
{
  for (const std::string code :
    { "textureLod(s, t, 0.0)", "textureGrad(s, t, a, b)", "texelFetch(s, ivec2(t), 0)",
      "textureSize(s, 0) * t", "mytexture(s, t)", "a.texture(s, t)", "texture(s, f)",
      "texture(s, a.t)", "texture(s, tt + t2)", "texture(array, vec3(t, 0.0))",
      "texture(shadow, vec3(t, 0.5))", "texture(several[0], t)", "texture(unknown, t)",
      "texture(s)", "texture(s, t, 0.0, 1.0)", "texture(s, t", "texture", "" })
  {
    EXPECT_EQ(Rewritten(code), code);
  }
}

TEST(ShaderLookups, InCommentsAndForThePreprocessorStay)
{
  for (const std::string code : { "// texture(s, t)\n", "/* texture(s, t)\n texture(s, t) */",
         "\n#define LOOKUP texture(s, t)\n", "texture(s,\n#if A\nt\n#else\nf\n#endif\n)",
         "/* texture(s, t)", "// texture(s, t)" })
  {
    EXPECT_EQ(Rewritten(code), code);
  }
  EXPECT_EQ(Rewritten("// texture(s, t\ntexture(s, /* ), t */ t) // texture(s, t)\n"),
    "// texture(s, t\n" + Lookup("t", "vitrineUnmoved_t") + " // texture(s, t)\n");
}

TEST(ShaderLookups, BeforeMainStay)
{
  const std::string helper = "vec4 look() { return texture(s, t); }\n";
  const std::string moved = Moved("uniform sampler2D s;\nin vec2 t;\n" + helper + Main);
  EXPECT_TRUE(Contains(moved, helper));
  EXPECT_FALSE(Contains(moved, "vitrineUnmoved_"));
}

TEST(ShaderLookups, DeclareWhatTheyNeed)
{
  EXPECT_TRUE(
    Contains(Moved("uniform sampler2D s;\nin vec2 t;\nvoid main()\n{\n  a = texture(s, t);\n}\n"),
      "vec2 vitrineMoved_t;\nvec2 vitrineUnmoved_t;\nvoid vitrineMoveInputs()"));
}

}
