#include "shader/ShaderTags.h"

namespace vitrine
{

std::string ReplaceTag(std::string& source, const std::string& tag, const std::string& text)
{
  const std::size_t at = source.find(tag);
  if (at == std::string::npos)
  {
    return "the shader has no tag " + tag;
  }
  source.replace(at, tag.size(), text);
  return source.find(tag, at + text.size()) == std::string::npos
    ? std::string()
    : "the shader has the tag " + tag + " more than once";
}

void InsertBeforeEach(std::string& shader, const std::string& place, const std::string& text)
{
  for (std::size_t at = shader.find(place); at != std::string::npos;
       at = shader.find(place, at + text.size() + place.size()))
  {
    shader.insert(at, text);
  }
}

}
