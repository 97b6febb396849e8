/**
 * All text of VTK's mapper shaders that Vitrine looks for.
 *
 * Tags are what VTK itself replaces. Lines are what VTK writes (vtkOpenGLPolyDataMapper::ReplaceShader...()). They are
 * the same in VTK 9.1, 9.3, 9.6 and 9.7 unless a comment says otherwise. The tests draw with 9.1 and 9.6. If a text is
 * missing, VTK has changed, and its user must do without: ReplaceTag() reports it.
 */
#ifndef VITRINE_SHADER_VTK_TEXT_H
#define VITRINE_SHADER_VTK_TEXT_H

#include <array>
#include <string>

namespace vitrine
{
namespace vtktext
{

/** The first and the last text of a piece of a shader, both inclusive. */
struct Piece
{
  std::string Begin;
  std::string End;
};

// ---- Tags ----

/** It comes before everything else. VTK replaces it by #version. */
inline const std::string SystemDec = "//VTK::System::Dec";
/** Text for GLSL 4.30 that stands for VTK's text in place of SystemDec. */
inline const std::string System430 =
  "#version 430 core\n"
  "#define highp\n#define mediump\n#define lowp\n"
  "#define texelFetchBuffer texelFetch\n#define texture1D texture\n"
  "#define texture2D texture\n#define texture3D texture\n"
  "#define varying in\n";
/** It comes before all other declarations. */
inline const std::string CustomUniformsDec = "//VTK::CustomUniforms::Dec";
inline const std::string LightDec = "//VTK::Light::Dec";
inline const std::string ClipDec = "//VTK::Clip::Dec";
/** In fragment shaders it comes before the colours, in geometry shaders it is in a loop over the vertices i. */
inline const std::string ClipImpl = "//VTK::Clip::Impl";
/** VTK declares and sets ambientColor, diffuseColor and opacity there. */
inline const std::string ColorImpl = "//VTK::Color::Impl";
/** Vertex shaders of glyphs alone have it. After it, `vertex` is the vertex in the coordinates of their mapper. */
inline const std::string GlyphImpl = "//VTK::Glyph::Impl";
inline const std::string DepthPeelingDec = "//VTK::DepthPeeling::Dec";
/** It is at the beginning of main(). */
inline const std::string UniformFlowImpl = "//VTK::UniformFlow::Impl";
/** It is at the end of main(). */
inline const std::string DepthPeelingImpl = "//VTK::DepthPeeling::Impl";

// ---- Vertex shaders ----

inline const std::string Position = "gl_Position = MCDCMatrix * vertexMC;";

// ---- The first light: its uniforms, and the text of its formula ----

inline const std::string LightColor = "uniform vec3 lightColor0;";
inline const std::string LightDirection = "uniform vec3 lightDirectionVC0; // normalized";

/** Further declarations if any light is positional. */
inline const std::array<std::string, 5> UniformsOfPositionalLight = {
  "uniform vec3 lightPositionVC0;", "uniform vec3 lightAttenuation0;",
  "uniform float lightConeAngle0;", "uniform float lightExponent0;", "uniform int lightPositional0;"
};

/** The text that VTK writes for a light. The first of these that occurs is meant. */
inline const std::array<Piece, 5> LightTexts = { {
  // With positional lights: Phong shading, physically based shading of VTK 9.5 and later, the same before 9.5.
  { "    attenuation = 1.0;\n    if (lightPositional0 ", "specular += (sf * lightColor0);\n" },
  { "  if (lightPositional0 == 0) {\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  { "  L = lightPositionVC0 - vertexVC.xyz;\n",
    "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  // With directional lights only: Phong shading, physically based shading.
  { "    df = max(0.0, dot(normalVCVSOutput, -lightDirectionVC0));\n",
    "specular += (sf * lightColor0);\n" },
  { "  L = normalize(-lightDirectionVC0);\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
} };

// ---- The lit colour: the text that VTK writes for all lights ----

inline const Piece PhongLighting = { "  vec3 diffuse = vec3(0,0,0);\n",
  "gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);" };
inline const Piece PhysicalLighting = { "  vec3 Lo = vec3(0.0);\n",
  "gl_FragData[0] = vec4(color, opacity);" };

/** The final assignment of the colour. */
inline const std::string AssignColor = "gl_FragData[0] = ";

/** The expression that applies textures to the lit colour, after AssignColor. */
inline const std::string Textured = "gl_FragData[0] * tcolor;";

/** Text of image-based light, occlusion textures, anisotropy and clear coat. */
inline const std::array<std::string, 4> BesidesPlainLight = { "prefilterTex", "material.r",
  "specular = SpecularAnisotropic(", "coatLayer = " };

// ---- Materials ----

/** Assignments to the values of a material, without the semicolon, if they come from the property alone. */
inline const std::array<std::string, 4> MaterialFromProperty = {
  "diffuseColor = diffuseIntensity * diffuseColorUniform",
  "ambientColor = ambientIntensity * ambientColorUniform",
  "specularColor = specularIntensity * specularColorUniform", "specularPower = specularPowerUniform"
};

/** Uniforms of physically based shading, after the word uniform. */
inline const std::array<std::string, 5> PhysicalUniforms = { "float roughnessUniform;",
  "float metallicUniform;", "vec3 edgeTintUniform;", "float baseF0Uniform;",
  "float aoStrengthUniform;" };

inline const std::string Albedo = "vec3 albedo = diffuseColor;\n";
inline const std::string NoEmission = "vec3 emissiveColor = vec3(0.0);";

}
}

#endif
