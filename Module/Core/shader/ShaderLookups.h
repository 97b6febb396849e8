/**
 * Rewrites texture lookups in a shader that sees its inputs moved (ShaderInputs.h). There, fragments that see the same
 * place do not differ, so derivatives must be those of the unmoved inputs.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_LOOKUPS_H
#define VITRINE_CORE_SHADER_SHADER_LOOKUPS_H

#include <set>
#include <string>

namespace vitrine
{

/** The names that lookups use. */
struct LookupNames
{
  std::set<std::string> Inputs; ///< Inputs that the shader sees moved.
  /** Samplers whose gradients have as many components as their coordinates. */
  std::set<std::string> Samplers;

  /** The prefix of the unmoved inputs' names. */
  std::string Unmoved;

  std::string TextureGrad; ///< The name of textureGrad() or its replacement.
};

/**
 * Returns true if gradients have as many components as coordinates, as for "sampler2D". Shadow and array samplers have
 * fewer. Integer samplers are excluded.
 */
bool HasPlainGradients(const std::string& samplerType);

/**
 * Rewrites the code of a function. Each texture() by moved inputs becomes textureGrad() with the gradients of the
 * unmoved inputs per pixel. Each fwidth() of moved inputs becomes that of the unmoved ones. Lookups with samplers that
 * are not named, comments and preprocessor lines stay unchanged.
 * @param pixelSize  a GLSL expression of type vec2: the width and height of a pixel in steps between fragments
 */
std::string KeepDerivatives(
  const std::string& code, const LookupNames& names, const std::string& pixelSize);

}
#endif
