#ifndef VITRINE_SHADER_SHADER_TAGS_H
#define VITRINE_SHADER_SHADER_TAGS_H

#include <string>

namespace vitrine
{

/**
 * Replace `tag`, or any other text of a shader, which must be there exactly once. Returns an empty string, or what is wrong: then the
 * shader must not be used.
 */
std::string ReplaceTag(std::string& source, const std::string& tag, const std::string& text);

}

#endif
