/**
 * What commands that compare methods say of scenes on which all methods are alike.
 */
#ifndef VITRINE_OPACITY_ADVICE_H
#define VITRINE_OPACITY_ADVICE_H

#include <string>

namespace program
{

struct Scene;

/**
 * Returns a sentence of advice if nothing in the scene is translucent. It is empty if something is, or if the scene has
 * no parts.
 */
std::string OpacityAdvice(const Scene& scene);

}
#endif
