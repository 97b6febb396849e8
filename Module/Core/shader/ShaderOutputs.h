/** Rewrites a mapper's fragment shader so that it writes only its colour. */
#ifndef VITRINE_CORE_SHADER_SHADER_OUTPUTS_H
#define VITRINE_CORE_SHADER_SHADER_OUTPUTS_H

#include <string>

namespace vitrine
{

/**
 * Turns all outputs but gl_FragData[0] into plain variables: gl_FragData[1] and later, and variables declared as `out`
 * at global scope. The shader may still write and read them. The source must be GLSL as VTK writes it, before the
 * shader cache. `dropped` receives the number of these outputs. Returns an empty string, or an error message; then the
 * shader is unchanged.
 */
std::string DropFurtherOutputs(std::string& fragmentShader, int& dropped);

}
#endif
