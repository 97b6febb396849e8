#ifndef VITRINE_CULLING_CULLING_LIMITS_H
#define VITRINE_CULLING_CULLING_LIMITS_H

#include <string>

namespace vitrine
{

/** All rules of CullingPolicy.h and PropPolicy.h as tables of Markdown, under a heading each. */
std::string LimitsAsMarkdown();

}

#endif
