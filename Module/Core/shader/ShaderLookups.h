/**
 * Rewriting of texture lookups in a shader that sees its inputs moved (Core/shader/ShaderInputs). There, fragments that see the same
 * place differ in nothing, so that derivatives are to be taken of the inputs as they come.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_LOOKUPS_H
#define VITRINE_CORE_SHADER_SHADER_LOOKUPS_H

#include <set>
#include <string>

namespace vitrine
{

/** What lookups are made with. */
struct LookupNames
{
  std::set<std::string> Inputs;   ///< that the shader sees moved
  std::set<std::string> Samplers; ///< whose gradients have as many components as their coordinates

  /** The same inputs, not moved, are named so with this before it. */
  std::string Unmoved;

  std::string TextureGrad; ///< textureGrad() or what stands for it
};

/** Whether gradients have as many components as coordinates, as for "sampler2D". Shadows and arrays have fewer. Integers are none. */
bool HasPlainGradients(const std::string& samplerType);

/**
 * The code of a function in which each texture() by moved inputs is textureGrad() by their gradients, and each fwidth() of
 * moved inputs is theirs, both of a pixel. `pixelSize` is an expression of GLSL, a vec2: the steps between fragments that a pixel is wide and
 * high. Lookups with samplers that are not named stay as they are, and so do comments and the preprocessor's lines.
 */
std::string KeepDerivatives(
  const std::string& code, const LookupNames& names, const std::string& pixelSize);

}
#endif
