#include "scene/files/ObjLines.h"

#include "Errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace program
{

namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\0' || c == '\f' || c == '\v';
}

/** Appends the words of a text up to a comment. Returns true if a backslash says that the line goes on. */
bool AppendWords(std::string_view text, std::vector<std::string_view>& words)
{
  for (std::size_t begin = 0; begin < text.size();)
  {
    if (IsBlank(text[begin]))
    {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < text.size() && !IsBlank(text[end]))
    {
      ++end;
    }
    const std::string_view word = text.substr(begin, end - begin);
    if (word.front() == '#')
    {
      return false;
    }
    const bool isLast =
      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), IsBlank);
    if (isLast && word.back() == '\\')
    {
      if (word.size() > 1)
      {
        words.push_back(word.substr(0, word.size() - 1));
      }
      return true;
    }
    words.push_back(word);
    begin = end;
  }
  return false;
}
}

std::string ObjLine::Rest(std::size_t first) const
{
  std::string rest;
  for (std::size_t i = first; i < this->Words.size(); ++i)
  {
    rest += i == first ? "" : " ";
    rest += this->Words[i];
  }
  return rest;
}

double ObjLine::NumberAt(std::size_t word) const
{
  std::string_view text = word < this->Words.size() ? this->Words[word] : std::string_view();
  if (!text.empty() && text.front() == '+')
  {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) // too large, or so small that it is 0
  {
    value = std::strtod(std::string(text).c_str(), nullptr);
  }
  if (error == std::errc::invalid_argument || last != text.data() + text.size() ||
    !std::isfinite(value))
  {
    this->Fail("has '" + std::string(text) + "' where a finite number is needed");
  }
  return value;
}

void ObjLine::Fail(const std::string& problem) const
{
  throw InputError(this->Path, "line " + std::to_string(this->Number) + " " + problem);
}

ObjLines::ObjLines(const std::string& path, const std::string& bytes)
  : Bytes(bytes)
  , Current{ path, 0, {} }
{
  const std::string_view mark = "\xEF\xBB\xBF";
  this->Position = bytes.compare(0, mark.size(), mark) == 0 ? mark.size() : 0;
}

bool ObjLines::Next()
{
  this->Current.Words.clear();
  while (this->Current.Words.empty() && this->Position < this->Bytes.size())
  {
    this->Current.Number = this->NextNumber;
    for (bool goesOn = true; goesOn && this->Position < this->Bytes.size();)
    {
      const std::size_t end = std::min(this->Bytes.find('\n', this->Position), this->Bytes.size());
      goesOn =
        AppendWords(std::string_view(this->Bytes).substr(this->Position, end - this->Position),
          this->Current.Words);
      this->Position = end + 1;
      ++this->NextNumber;
    }
  }
  return !this->Current.Words.empty();
}

}
