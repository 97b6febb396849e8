/** Rewrites a mapper's shaders for speed, without changing results. */
#ifndef VITRINE_CORE_SHADER_SHADER_TUNING_H
#define VITRINE_CORE_SHADER_SHADER_TUNING_H

#include <string>

namespace vitrine
{

/**
 * Moves the scalar and vector uniforms of a fragment shader to its vertex shader, which passes them on as flat
 * varyings. A software rasteriser gathers uniforms lane by lane for each fragment, but loads a flat varying once per
 * triangle. Uniform arrays, matrices and samplers stay. Both sources must be GLSL as VTK writes it, with one
 * declaration per line. There must be no geometry or tessellation shader between the two.
 * @returns  the number of moved uniforms
 */
int PassUniformsAsFlatVaryings(std::string& vertexShader, std::string& fragmentShader);

/**
 * Removes the pow() of VTK's specular term from a fragment shader that multiplies this term by zero. Returns true if
 * there was one.
 */
bool DropSpecularPower(std::string& fragmentShader);

}
#endif
