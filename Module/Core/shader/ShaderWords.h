/** Words of a shader's source. */
#ifndef VITRINE_CORE_SHADER_SHADER_WORDS_H
#define VITRINE_CORE_SHADER_SHADER_WORDS_H

#include <set>
#include <string>

namespace vitrine
{

/** Returns true if names may contain the character. */
bool IsWordCharacter(char c);

/**
 * Returns the source with blanks in place of comments and preprocessor lines. Line numbers and offsets stay the same.
 */
std::string BlankComments(const std::string& text);

/** Returns the text with `prefix` before each of `words`, except names of members, as in a.word. */
std::string PrefixWords(
  const std::string& text, const std::set<std::string>& words, const std::string& prefix);

/** Returns the end of the word that begins at `begin`. Returns `begin` if there is none. */
std::size_t EndOfWord(const std::string& text, std::size_t begin);

/** Returns the begin of the next word at or after `from` that is not a member's name. Returns npos if there is none. */
std::size_t FindWord(const std::string& text, std::size_t from);

}
#endif
