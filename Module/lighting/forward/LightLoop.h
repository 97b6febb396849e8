/**
 * What VTK's mappers write for one light, turned into a loop over the lights of a cluster, so that the formulas are VTK's own.
 */
#ifndef VITRINE_LIGHTING_FORWARD_LIGHT_LOOP_H
#define VITRINE_LIGHTING_FORWARD_LIGHT_LOOP_H

#include <string>

namespace vitrine
{

/** Whether a mapper's fragment shader is lit. */
bool IsLit(const std::string& fragmentShader);

/** Turns a lit shader's text for its first light, which must be its only one, into the loop. Returns an empty string, or what is not as it should be. */
std::string LoopOverLights(std::string& fragmentShader);

/**
 * Turns the same text into that of one light of many, by number, with `result` to be done with what VTK's variables hold then. The number is
 * a vitrineLight of the shader's.
 */
std::string TakeOneLight(std::string& fragmentShader, const std::string& result);

/** Puts `sums` in place of the same text. */
std::string TakeSums(std::string& fragmentShader, const std::string& sums);

}

#endif
