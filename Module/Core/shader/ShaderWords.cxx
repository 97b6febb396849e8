#include "Core/shader/ShaderWords.h"

#include <algorithm>
#include <cctype>

namespace vitrine
{
namespace
{

// Returns the end of a comment or preprocessor line that begins at `begin`. Returns `begin` if code begins there.
std::size_t EndOfComment(const std::string& text, std::size_t begin)
{
  std::size_t end = begin;
  if (text.compare(begin, 2, "/*") == 0)
  {
    end = text.find("*/", begin + 2);
    end = end == std::string::npos ? end : end + 2;
  }
  else if (text.compare(begin, 2, "//") == 0 || text[begin] == '#')
  {
    end = text.find('\n', begin);
  }
  return std::min(end, text.size());
}

}

bool IsWordCharacter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::string BlankComments(const std::string& text)
{
  std::string bare = text;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    const std::size_t end = EndOfComment(text, at);
    const auto begin = bare.begin() + static_cast<std::ptrdiff_t>(at);
    std::replace_if(
      begin, begin + static_cast<std::ptrdiff_t>(end - at), [](char c) { return c != '\n'; }, ' ');
    at = std::max(at, end - (end > at ? 1 : 0));
  }
  return bare;
}

std::size_t EndOfWord(const std::string& text, std::size_t begin)
{
  while (begin < text.size() && IsWordCharacter(text[begin]))
  {
    ++begin;
  }
  return begin;
}

std::size_t FindWord(const std::string& text, std::size_t from)
{
  for (std::size_t at = from; at < text.size(); at = std::max(at + 1, EndOfWord(text, at)))
  {
    const bool begins = at == 0 || (text[at - 1] != '.' && !IsWordCharacter(text[at - 1]));
    if (begins && IsWordCharacter(text[at]))
    {
      return at;
    }
  }
  return std::string::npos;
}

std::string PrefixWords(
  const std::string& text, const std::set<std::string>& words, const std::string& prefix)
{
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = FindWord(text, 0); at != std::string::npos; at = FindWord(text, done))
  {
    const std::size_t end = EndOfWord(text, at);
    const std::string word = text.substr(at, end - at);
    result += text.substr(done, at - done) + (words.count(word) > 0 ? prefix : "") + word;
    done = end;
  }
  return result + text.substr(std::min(done, text.size()));
}

}
