#ifndef VITRINE_CORE_ASSEMBLY_PART_PATTERN_H
#define VITRINE_CORE_ASSEMBLY_PART_PATTERN_H

#include <stdexcept>
#include <string>
#include <vector>

namespace vitrine
{

/** A text that is no pattern. what() says why in one line. */
class PatternError : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

/** What a pattern can choose a part by. */
struct PartNames
{
  std::string Path;     ///< names of the nodes from the root to the part, each after a slash
  std::string Material; ///< name of the material; may be empty
};

/**
 * A pattern that chooses parts by name:
 *
 * - `bolt*` chooses each node of that name, with its subtree.
 * - `/Housing/lid*` chooses each node of that whole path, with its subtree. `*` stops at a slash and `**` does not.
 * - `Housing/lid*` chooses each node whose path ends so, with its subtree.
 * - `material:glass*` chooses the parts of each material of that name.
 *
 * `*` stands for any number of characters and `?` for one. A backslash takes the meaning from the character after it.
 * Case counts. Where a reader has numbered equal names, "bolt (2)", a pattern of "bolt" chooses all of them.
 */
class PartPattern
{
public:
  /** Throws PatternError if the text is empty, or ends within an escape. */
  explicit PartPattern(const std::string& text);

  /** Returns true if the pattern chooses a part. */
  bool Chooses(const PartNames& part) const;

  /** Returns the numbers of the parts that the pattern chooses, in their order. */
  std::vector<int> Choose(const std::vector<PartNames>& parts) const;

  /**
   * Returns a line that tells that the pattern chooses none of `parts`, and names those that it nearly chooses: names
   * that differ in case, and names of few other letters. At most three are named.
   */
  std::string DescribeMiss(const std::vector<PartNames>& parts) const;

private:
  /** One character of the pattern. */
  struct Token
  {
    enum Kind
    {
      Letter,
      Any,       ///< one character other than a slash
      Some,      ///< any number of characters other than a slash
      Everything ///< any number of characters
    };
    Kind Meaning;
    char Character;

    bool IsStar() const;
    bool Takes(char c) const;
  };

  /** Returns true if the pattern matches the text, or, if asked for, its beginning up to a slash. */
  static bool Matches(
    const std::vector<Token>& pattern, const std::string& text, bool orItsBeginning);

  std::string Text;
  std::vector<Token> Pattern;
  bool IsMaterial = false;
};

}

#endif
