/**
 * VTK's own text in the shaders of its mappers that is looked for: all of it stands here.
 *
 * Tags are what VTK itself replaces. Lines are what it writes (vtkOpenGLPolyDataMapper::ReplaceShader...()). They are the same in VTK 9.1, 9.3, 9.6
 * and 9.7 but where a comment says otherwise; the tests draw by them with 9.1 and 9.6. Where one is missing, VTK has changed, and
 * whoever looks for it has to do without: ReplaceTag() says so.
 */
#ifndef VITRINE_SHADER_VTK_TEXT_H
#define VITRINE_SHADER_VTK_TEXT_H

#include <array>
#include <string>

namespace vitrine
{
namespace vtktext
{

/** Where a piece of a shader begins and ends, both inclusive. */
struct Piece
{
  std::string Begin;
  std::string End;
};

// ---- Tags ----

inline const std::string SystemDec =
  "//VTK::System::Dec"; ///< before all else; #version replaces it
inline const std::string LightDec = "//VTK::Light::Dec";
inline const std::string DepthPeelingDec = "//VTK::DepthPeeling::Dec";
inline const std::string UniformFlowImpl =
  "//VTK::UniformFlow::Impl"; ///< at the beginning of main()
inline const std::string DepthPeelingImpl = "//VTK::DepthPeeling::Impl"; ///< at the end of main()

// ---- Vertex shaders ----

inline const std::string Position = "gl_Position = MCDCMatrix * vertexMC;";

// ---- The first light: its uniforms, and the text of its formula ----

inline const std::string LightColor = "uniform vec3 lightColor0;";
inline const std::string LightDirection = "uniform vec3 lightDirectionVC0; // normalized";

/** What shaders have besides where any light is positional. */
inline const std::array<std::string, 5> UniformsOfPositionalLight = {
  "uniform vec3 lightPositionVC0;", "uniform vec3 lightAttenuation0;",
  "uniform float lightConeAngle0;", "uniform float lightExponent0;", "uniform int lightPositional0;"
};

/** What is written for a light: the first one of these that is there. */
inline const std::array<Piece, 5> LightTexts = { {
  // Positional lights: Phong's shading, then physically based shading from 9.5 on and before.
  { "    attenuation = 1.0;\n    if (lightPositional0 ", "specular += (sf * lightColor0);\n" },
  { "  if (lightPositional0 == 0) {\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  { "  L = lightPositionVC0 - vertexVC.xyz;\n",
    "  Lo += radiance * (diffuse + specular) * NdL;\n" },
  // Directional lights alone: Phong's shading, then physically based shading.
  { "    df = max(0.0, dot(normalVCVSOutput, -lightDirectionVC0));\n",
    "specular += (sf * lightColor0);\n" },
  { "  L = normalize(-lightDirectionVC0);\n", "  Lo += radiance * (diffuse + specular) * NdL;\n" },
} };

// ---- The lit colour: all that is written for lights ----

inline const Piece PhongLighting = { "  vec3 diffuse = vec3(0,0,0);\n",
  "gl_FragData[0] = vec4(ambientColor + diffuse + specular, opacity);" };
inline const Piece PhysicalLighting = { "  vec3 Lo = vec3(0.0);\n",
  "gl_FragData[0] = vec4(color, opacity);" };

/** What all is put into at the end. */
inline const std::string AssignColor = "gl_FragData[0] = ";

/** What textures do to the lit colour, behind AssignColor. */
inline const std::string Textured = "gl_FragData[0] * tcolor;";

/** Image-based light, textures of occlusion, anisotropy, clear coat. */
inline const std::array<std::string, 4> BesidesPlainLight = { "prefilterTex", "material.r",
  "specular = SpecularAnisotropic(", "coatLayer = " };

// ---- Materials ----

/** All that is written to the values of a material, but for a semicolon, where they come from the property alone. */
inline const std::array<std::string, 4> MaterialFromProperty = {
  "diffuseColor = diffuseIntensity * diffuseColorUniform",
  "ambientColor = ambientIntensity * ambientColorUniform",
  "specularColor = specularIntensity * specularColorUniform", "specularPower = specularPowerUniform"
};

/** Declarations behind the word uniform, of physically based shading. */
inline const std::array<std::string, 5> PhysicalUniforms = { "float roughnessUniform;",
  "float metallicUniform;", "vec3 edgeTintUniform;", "float baseF0Uniform;",
  "float aoStrengthUniform;" };

inline const std::string Albedo = "vec3 albedo = diffuseColor;\n";
inline const std::string NoEmission = "vec3 emissiveColor = vec3(0.0);";

}
}

#endif
