/**
 * Rewriting of a mapper's fragment shader that has it write its colour alone.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_OUTPUTS_H
#define VITRINE_CORE_SHADER_SHADER_OUTPUTS_H

#include <string>

namespace vitrine
{

/**
 * Make plain variables of all outputs but gl_FragData[0]: of gl_FragData[1] and on, and of what is declared as `out` at global
 * scope. The shader may go on writing and reading them. Sources are GLSL as VTK writes it, before its shader cache has them.
 * `dropped` takes the number of outputs. Returns an empty string, or what is wrong; the shader is unchanged then.
 */
std::string DropFurtherOutputs(std::string& fragmentShader, int& dropped);

}
#endif
