#include "scene/files/ObjCheck.h"

#include "Errors.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace program
{

namespace
{
const std::size_t LongestObjLine = 99998; // VTK's reader has lines of 100000

using Words = std::vector<std::string>;

/** Calls `take(number, words)` for every line that is not empty. */
template <typename Take>
void ForEachLine(const std::string& path, const std::string& bytes, const Take& take)
{
  std::istringstream lines(bytes);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    if (line.size() > LongestObjLine)
    {
      throw InputError(
        path, "line " + std::to_string(number) + " is longer than VTK's reader can take");
    }
    std::istringstream stream(line);
    Words words;
    for (std::string word; stream >> word;)
    {
      words.push_back(word);
    }
    if (!words.empty())
    {
      take(number, words);
    }
  }
}

/** What follows the first word of a line. */
std::string Rest(const Words& words)
{
  std::string rest;
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    rest += (i == 1 ? "" : " ") + words[i];
  }
  return rest;
}

bool IsNumber(const std::string& word)
{
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size();
}

/** Whether one to `most` numbers follow the word at `index`. */
bool HasNumbers(const Words& words, std::size_t index, std::size_t most)
{
  std::size_t count = 0;
  while (index + 1 + count < words.size() && IsNumber(words[index + 1 + count]))
  {
    ++count;
  }
  return count >= 1 && count <= most;
}

/** Whether the options of a texture have no more numbers than VTK's reader has room for. */
bool HasShortOptions(const Words& words)
{
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    const bool isVector = words[i] == "-s" || words[i] == "-o";
    if ((isVector && !HasNumbers(words, i, 3)) || (words[i] == "-mm" && !HasNumbers(words, i, 2)))
    {
      return false;
    }
  }
  return true;
}

class ObjScanner
{
public:
  explicit ObjScanner(const std::string& path)
    : Path(path)
  {
  }

  void Take(int number, const Words& words)
  {
    this->Number = number;
    const std::string& command = words[0];
    if (command == "v")
    {
      this->TakeVertex(words);
    }
    else if (command == "vt")
    {
      ++this->TextureVertices;
    }
    else if (command == "vn")
    {
      ++this->Normals;
    }
    else if (command == "f" || command == "l" || command == "p")
    {
      this->TakeCell(words);
    }
    else if (command == "o" || command == "g")
    {
      this->Group = Rest(words);
    }
    else if (command == "usemtl")
    {
      this->Contents.PartNames.push_back(this->Group.empty() ? Rest(words) : this->Group);
    }
    else if (command == "mtllib" && this->Contents.MaterialLibrary.empty())
    {
      this->Contents.MaterialLibrary = Rest(words);
    }
  }

  ObjContents Finish() const
  {
    if (this->Vertices == 0)
    {
      throw InputError(this->Path, "has no vertices: it is empty or no OBJ file");
    }
    if (this->LargestCorner > this->Vertices || this->LargestTexture > this->TextureVertices ||
      this->LargestNormal > this->Normals)
    {
      throw InputError(this->Path,
        "is damaged: a corner refers to a vertex, texture vertex or "
        "normal that is not there");
    }
    if (this->ColoredVertices != 0 && this->ColoredVertices != this->Vertices)
    {
      throw InputError(
        this->Path, "has colours at some of its vertices only, which VTK's reader cannot take");
    }
    return this->Contents;
  }

private:
  [[noreturn]] void Fail(const std::string& problem) const
  {
    throw InputError(this->Path, "line " + std::to_string(this->Number) + " " + problem);
  }

  void TakeVertex(const Words& words)
  {
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      char* end = nullptr;
      const float value = std::strtof(words[i].c_str(), &end);
      if (end == words[i].c_str() || !std::isfinite(value))
      {
        this->Fail("has a coordinate that is not a finite number");
      }
    }
    if (words.size() < 4)
    {
      this->Fail("is a vertex with fewer than three coordinates");
    }
    ++this->Vertices;
    this->ColoredVertices += words.size() >= 7;
  }

  void TakeCell(const Words& words)
  {
    for (std::size_t i = 1; i < words.size(); ++i)
    {
      if (words[i] == "\\")
      {
        this->Fail("goes on in the next, which is not supported");
      }
      this->TakeCorner(words[i]);
    }
  }

  /** "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal". */
  void TakeCorner(const std::string& corner)
  {
    const char* position = corner.data();
    const char* end = corner.data() + corner.size();
    long* const largest[3] = { &this->LargestCorner, &this->LargestTexture, &this->LargestNormal };
    for (int i = 0; i < 3 && position <= end; ++i)
    {
      long index = 0;
      const auto [last, error] = std::from_chars(position, end, index);
      if (error == std::errc())
      {
        if (index < 1)
        {
          this->Fail("has an index below 1; indices from the end are not supported");
        }
        *largest[i] = std::max(*largest[i], index);
      }
      else if (i != 1 || error != std::errc::invalid_argument)
      {
        this->Fail("has a corner that is not understood");
      }
      if (last != end && *last != '/')
      {
        this->Fail("has a corner that is not understood");
      }
      position = last + 1;
    }
  }

  const std::string& Path;
  ObjContents Contents;
  std::string Group;
  int Number = 0;
  long Vertices = 0;
  long ColoredVertices = 0;
  long TextureVertices = 0;
  long Normals = 0;
  long LargestCorner = 0;
  long LargestTexture = 0;
  long LargestNormal = 0;
};
}

ObjContents CheckObj(const std::string& path, const std::string& bytes)
{
  ObjScanner scanner(path);
  ForEachLine(
    path, bytes, [&scanner](int number, const Words& words) { scanner.Take(number, words); });
  return scanner.Finish();
}

std::vector<std::string> CheckMtl(const std::string& path, const std::string& bytes)
{
  if (bytes.back() != '\n')
  {
    throw InputError(path, "does not end with the end of a line: it is truncated");
  }
  std::vector<std::string> textures;
  ForEachLine(path, bytes,
    [&](int number, const Words& words)
    {
      const bool isColor = words[0] == "Ka" || words[0] == "Kd" || words[0] == "Ks";
      if ((isColor && !HasNumbers(words, 0, 3)) || !HasShortOptions(words))
      {
        throw InputError(path,
          "line " + std::to_string(number) + " has too few or too many numbers for " + words[0]);
      }
      if (words[0] == "map_Kd" || words[0] == "map_Ka")
      {
        textures.push_back(words.back());
      }
    });
  return textures;
}

}
