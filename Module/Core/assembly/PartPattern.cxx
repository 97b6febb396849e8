#include "Core/assembly/PartPattern.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <set>
#include <tuple>

namespace vitrine
{

namespace
{
/** Whether a byte is a later one of a character in UTF-8. */
bool ContinuesCharacter(char c)
{
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

const std::string MaterialPrefix = "material:";
constexpr std::size_t MostNearMisses = 3;

/** The ends of the paths of a part's nodes, from the root on. */
std::vector<std::size_t> NodeEnds(const std::string& path)
{
  std::vector<std::size_t> ends;
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos;
       slash = path.find('/', slash + 1))
  {
    ends.push_back(slash);
  }
  ends.push_back(path.size());
  return ends;
}

/** The path without the numbers that tell equal names apart: "/a (2)/b" becomes "/a/b". */
std::string WithoutNumbers(const std::string& path)
{
  std::string plain;
  std::size_t begin = 0;
  for (const std::size_t end : NodeEnds(path))
  {
    std::string name = path.substr(begin, end - begin);
    const std::size_t open = name.rfind(" (");
    const bool isNumbered = open != std::string::npos && name.back() == ')' &&
      name.size() > open + 3 &&
      std::all_of(name.begin() + static_cast<std::ptrdiff_t>(open) + 2, name.end() - 1,
        [](unsigned char c) { return std::isdigit(c) != 0; });
    plain += isNumbered ? name.substr(0, open) : name;
    begin = end;
  }
  return plain;
}

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/** Returns the number of letters to insert, take away or change from one text to the other (Levenshtein, 1966). */
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1] ? 1 : 0);
      diagonal = row[j];
      row[j] = std::min({ row[j] + 1, row[j - 1] + 1, changed });
    }
  }
  return row.back();
}

/** Names that a pattern may be meant for: of materials, whole paths of nodes, or names of nodes. */
std::set<std::string> Candidates(const std::vector<PartNames>& parts, bool ofMaterials, bool whole)
{
  std::set<std::string> names;
  for (const PartNames& part : parts)
  {
    if (ofMaterials)
    {
      names.insert(part.Material);
      continue;
    }
    const std::string path = WithoutNumbers(part.Path);
    for (const std::size_t end : NodeEnds(path))
    {
      const std::string node = path.substr(0, end);
      names.insert(whole ? node : node.substr(node.rfind('/') + 1));
    }
  }
  names.erase("");
  return names;
}
}

bool PartPattern::Token::IsStar() const
{
  return this->Meaning == Some || this->Meaning == Everything;
}

bool PartPattern::Token::Takes(char c) const
{
  switch (this->Meaning)
  {
    case Letter:
      return c == this->Character;
    case Any:
      return c != '/' && !ContinuesCharacter(c);
    case Some:
      return c != '/';
    case Everything:
      break;
  }
  return true;
}

PartPattern::PartPattern(const std::string& text)
  : Text(text)
{
  this->IsMaterial = text.compare(0, MaterialPrefix.size(), MaterialPrefix) == 0;
  const std::string glob = this->IsMaterial ? text.substr(MaterialPrefix.size()) : text;
  if (glob.empty())
  {
    throw PatternError("the pattern '" + text + "' is empty");
  }
  if (!this->IsMaterial && glob.front() != '/')
  {
    this->Pattern = { { Token::Everything, 0 }, { Token::Letter, '/' } };
  }
  for (std::size_t i = 0; i < glob.size(); ++i)
  {
    if (glob[i] == '\\')
    {
      if (++i == glob.size())
      {
        throw PatternError("the pattern '" + text + "' ends with a backslash; write \\\\ for one");
      }
      this->Pattern.push_back({ Token::Letter, glob[i] });
    }
    else if (glob[i] == '*')
    {
      const bool isDouble = i + 1 < glob.size() && glob[i + 1] == '*';
      i += isDouble ? 1 : 0;
      const bool crosses = isDouble || this->IsMaterial;
      this->Pattern.push_back({ crosses ? Token::Everything : Token::Some, 0 });
    }
    else
    {
      this->Pattern.push_back({ glob[i] == '?' ? Token::Any : Token::Letter, glob[i] });
    }
  }
}

// Follows all ways through the pattern at once, so the time is at most the product of both lengths.
bool PartPattern::Matches(
  const std::vector<Token>& pattern, const std::string& text, bool orItsBeginning)
{
  std::vector<char> reached(pattern.size() + 1, 0);
  std::vector<char> next(pattern.size() + 1, 0);
  const auto skipStars = [&pattern](std::vector<char>& at)
  {
    for (std::size_t i = 0; i < pattern.size(); ++i)
    {
      at[i + 1] |= static_cast<char>(at[i] && pattern[i].IsStar());
    }
  };
  reached[0] = 1;
  skipStars(reached);
  for (std::size_t c = 0; c < text.size(); ++c)
  {
    const bool continues = ContinuesCharacter(text[c]);
    if (orItsBeginning && text[c] == '/' && reached.back())
    {
      return true;
    }
    std::fill(next.begin(), next.end(), 0);
    for (std::size_t i = 0; i < pattern.size(); ++i)
    {
      if (reached[i] && pattern[i].Takes(text[c]))
      {
        next[pattern[i].IsStar() ? i : i + 1] = 1;
      }
      if (continues && reached[i + 1] && pattern[i].Meaning == Token::Any)
      {
        next[i + 1] = 1;
      }
    }
    skipStars(next);
    reached.swap(next);
  }
  return reached.back() != 0;
}

bool PartPattern::Chooses(const PartNames& part) const
{
  if (this->IsMaterial)
  {
    return Matches(this->Pattern, part.Material, /* orItsBeginning= */ false);
  }
  return Matches(this->Pattern, part.Path, /* orItsBeginning= */ true) ||
    Matches(this->Pattern, WithoutNumbers(part.Path), /* orItsBeginning= */ true);
}

std::vector<int> PartPattern::Choose(const std::vector<PartNames>& parts) const
{
  std::vector<int> chosen;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (this->Chooses(parts[i]))
    {
      chosen.push_back(static_cast<int>(i));
    }
  }
  return chosen;
}

std::string PartPattern::DescribeMiss(const std::vector<PartNames>& parts) const
{
  std::string wanted;
  for (const Token& token : this->Pattern)
  {
    wanted += token.Meaning == Token::Letter ? std::string(1, token.Character) : "";
  }
  const bool isWhole = !this->IsMaterial && this->Text.front() == '/';
  wanted = isWhole || this->IsMaterial ? wanted : wanted.substr(1);
  PartPattern folded = *this;
  for (Token& token : folded.Pattern)
  {
    token.Character = static_cast<char>(std::tolower(static_cast<unsigned char>(token.Character)));
  }
  std::vector<std::tuple<std::size_t, std::string>> near;
  for (const std::string& name : Candidates(parts, this->IsMaterial, isWhole))
  {
    const std::string text = this->IsMaterial || isWhole ? name : "/" + name;
    const bool differsInCase = Matches(folded.Pattern, Lower(text), /* orItsBeginning= */ false);
    const std::size_t distance = EditDistance(Lower(wanted), Lower(name));
    if (differsInCase || distance <= std::max(std::size_t(2), wanted.size() / 3))
    {
      near.emplace_back(differsInCase ? 0 : distance, name);
    }
  }
  std::sort(near.begin(), near.end());
  std::string line = "'" + this->Text + "' chooses no part";
  for (std::size_t i = 0; i < std::min(near.size(), MostNearMisses); ++i)
  {
    line += (i == 0 ? "; near are '" : ", '") + std::get<1>(near[i]) + "'";
  }
  return line;
}

}
