/**
 * Turns the shader text that VTK's mappers write for one light into a loop over a cluster's lights. The formulas stay
 * VTK's.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_LOOP_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_LOOP_H

#include <string>

namespace vitrine
{

/** Returns true if a mapper's fragment shader computes lighting. */
bool IsLit(const std::string& fragmentShader);

/**
 * Turns the text of a shader's only light into a loop. Returns an empty string, or what is unexpected in the shader.
 */
std::string LoopOverLights(std::string& fragmentShader);

/**
 * Turns the text of a shader's only light into that of one light of many, and appends `result`, which uses VTK's
 * variables. The shader must define vitrineLight, the number of the light in the list. Returns an empty string, or what
 * is unexpected in the shader.
 */
std::string TakeOneLight(std::string& fragmentShader, const std::string& result);

/**
 * Replaces the text of a shader's only light by `sums`. Returns an empty string, or what is unexpected in the shader.
 */
std::string TakeSums(std::string& fragmentShader, const std::string& sums);

}

#endif
