/**
 * Rewriting of a mapper's fragment shader that has it shade another place than its pixel's centre.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_INPUTS_H
#define VITRINE_CORE_SHADER_SHADER_INPUTS_H

#include <string>

namespace vitrine
{

/** Where a shader is to see its inputs. Expressions of GLSL. */
struct InputPlace
{
  std::string Offset;    ///< vec2: so many pixels of the target away
  std::string PixelSize; ///< vec2: the pixels of the target that see the same
  std::string Depth;     ///< the global variable that takes the depth there

  /** The function that looks textures up as this does, declared before main(). */
  std::string TextureGrad = "textureGrad";
};

/**
 * Have the shader see each of its interpolated inputs (float and vectors; no arrays, none that are flat) as it is `place.Offset`
 * pixels away, along its slope in the picture, which for depth is exact and for the rest all but exact. Inputs
 * of which the shader takes derivatives by dFdx() stay as they are. Textures that main() looks up by moved inputs are seen at the level of detail of
 * pixels of size `place.PixelSize`, see Core/shader/ShaderLookups. `place.Depth` is declared before main().
 * Sources are GLSL as VTK writes it: one declaration a line. Returns an empty string, or what is wrong.
 */
std::string MoveInputs(std::string& fragmentShader, const InputPlace& place);

}
#endif
