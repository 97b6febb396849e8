/**
 * The words of a shader's text.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_WORDS_H
#define VITRINE_CORE_SHADER_SHADER_WORDS_H

#include <set>
#include <string>

namespace vitrine
{

/** Whether names consist of such characters. */
bool IsWordCharacter(char c);

/** The text with blanks in place of comments and of lines for the preprocessor. Each line stays where it is. */
std::string BlankComments(const std::string& text);

/** The text with `prefix` before each of `words`, but where it is a member's name, as in a.word. */
std::string PrefixWords(
  const std::string& text, const std::set<std::string>& words, const std::string& prefix);

/** The end of the word that begins at `begin`, which is `begin` itself if there is none. */
std::size_t EndOfWord(const std::string& text, std::size_t begin);

/** Where the next word from `from` on begins that is no member's name; npos if there is none. */
std::size_t FindWord(const std::string& text, std::size_t from);

}
#endif
