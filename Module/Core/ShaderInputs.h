/**
 * Rewriting of a mapper's fragment shader that has it shade another place than its pixel's centre.
 */
#ifndef VITRINE_SHADER_INPUTS_H
#define VITRINE_SHADER_INPUTS_H

#include <string>

namespace vitrine
{

/**
 * Have the shader see each of its interpolated inputs (float and vectors; no arrays, none that are flat) as it is `offset`
 * pixels away, along its slope in the picture, which for depth is exact and for the rest all but exact. Inputs
 * of which the shader takes derivatives stay as they are. `offset` is an expression of GLSL, a vec2. The depth there goes to the global variable `depth`, which is declared before main().
 * Sources are GLSL as VTK writes it: one declaration a line. Returns an empty string, or what is wrong.
 */
std::string MoveInputs(
  std::string& fragmentShader, const std::string& offset, const std::string& depth);

}
#endif
