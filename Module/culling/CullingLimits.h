#ifndef VITRINE_CULLING_CULLING_LIMITS_H
#define VITRINE_CULLING_CULLING_LIMITS_H

#include <string>

namespace vitrine
{

/** Returns all rules of CullingPolicy.h and PropPolicy.h as Markdown tables, each under a heading. */
std::string LimitsAsMarkdown();

}

#endif
