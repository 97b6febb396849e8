/** Rewrites a mapper's fragment shader so that it shades another place than its pixel's centre. */
#ifndef VITRINE_CORE_SHADER_SHADER_INPUTS_H
#define VITRINE_CORE_SHADER_SHADER_INPUTS_H

#include <string>

namespace vitrine
{

/** The place where a shader sees its inputs, as GLSL expressions. */
struct InputPlace
{
  std::string Offset;    ///< A vec2: the distance of the place in pixels of the target.
  std::string PixelSize; ///< A vec2: the number of target pixels that see the same place, per axis.
  std::string Depth;     ///< The global variable that receives the depth at the place.

  /** The function that replaces textureGrad(). It must be declared before main(). */
  std::string TextureGrad = "textureGrad";
};

/**
 * Makes a shader see its interpolated inputs at a place `place.Offset` pixels away. It applies to float and vector
 * inputs that are no arrays and not flat. They follow their slope in the picture, which is exact for depth and nearly
 * exact otherwise. Inputs that the shader differentiates by dFdx() stay unchanged.
 *
 * Textures that main() looks up by moved inputs use the level of detail of pixels of size `place.PixelSize`
 * (ShaderLookups.h). `place.Depth` is declared before main(). The source must be GLSL as VTK writes it, with one
 * declaration per line. Returns an empty string, or an error message.
 */
std::string MoveInputs(std::string& fragmentShader, const InputPlace& place);

}
#endif
