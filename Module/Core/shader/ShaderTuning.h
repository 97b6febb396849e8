/**
 * Rewriting of a mapper's shaders that makes them faster and changes no result.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_TUNING_H
#define VITRINE_CORE_SHADER_SHADER_TUNING_H

#include <string>

namespace vitrine
{

/**
 * Move the scalar and vector uniforms of a fragment shader to its vertex shader and hand them on as flat
 * varyings. A software rasteriser gathers uniforms lane by lane for each fragment, but loads a flat varying
 * once for a triangle. Uniform arrays, matrices and samplers stay. Both sources are GLSL as VTK writes it: one
 * declaration a line. Only valid without a geometry or tessellation shader between the two.
 *
 * Returns how many uniforms moved.
 */
int PassUniformsAsFlatVaryings(std::string& vertexShader, std::string& fragmentShader);

/**
 * Drop the pow() of VTK's specular term from a fragment shader in which that term is multiplied by zero.
 * Returns whether there was one.
 */
bool DropSpecularPower(std::string& fragmentShader);

}
#endif
