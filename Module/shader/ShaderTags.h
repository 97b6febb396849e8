/** Replaces tags and other text in shaders. */
#ifndef VITRINE_SHADER_SHADER_TAGS_H
#define VITRINE_SHADER_SHADER_TAGS_H

#include <string>

namespace vitrine
{

/**
 * Replace `tag`, or any other text that must occur in the shader exactly once. Returns an error message, empty on
 * success. After an error the shader must not be used.
 */
std::string ReplaceTag(std::string& source, const std::string& tag, const std::string& text);

/** Insert `text` before each `place` in the shader. */
void InsertBeforeEach(std::string& shader, const std::string& place, const std::string& text);

}

#endif
