/**
 * What commands that compare methods say of scenes on which all methods are alike.
 */
#ifndef VITRINE_OPACITY_ADVICE_H
#define VITRINE_OPACITY_ADVICE_H

#include <string>

namespace program
{

struct Scene;

/** What to do about a scene in which nothing is translucent, in a sentence; empty if something is, or if it has no parts. */
std::string OpacityAdvice(const Scene& scene);

}
#endif
