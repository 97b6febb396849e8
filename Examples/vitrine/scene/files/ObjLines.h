/**
 * The lines of Wavefront's text files, .obj and .mtl, as words.
 */
#ifndef VITRINE_OBJ_LINES_H
#define VITRINE_OBJ_LINES_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace program
{

/** A line that is not empty. Its words are views of the file's bytes. */
struct ObjLine
{
  const std::string& Path; ///< of the file
  int Number = 0;          ///< from 1
  std::vector<std::string_view> Words;

  /** The words from `first` on, with a space between them. */
  std::string Rest(std::size_t first = 1) const;

  /** The finite number that a word is. Throws InputError if it is none. */
  double NumberAt(std::size_t word) const;

  /** Throw InputError, with the line's number before the problem. */
  [[noreturn]] void Fail(const std::string& problem) const;
};

/** Goes through lines, of which one goes on in the next after a backslash at its end. Comments begin with '#'. */
class ObjLines
{
public:
  /** Both must outlive this object. */
  ObjLines(const std::string& path, const std::string& bytes);

  /** Read the next line that is not empty. Returns false at the end. */
  bool Next();

  const ObjLine& Line() const { return this->Current; }

private:
  const std::string& Bytes;
  std::size_t Position = 0;
  int NextNumber = 1;
  ObjLine Current;
};

}
#endif
