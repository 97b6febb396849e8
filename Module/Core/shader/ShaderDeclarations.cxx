#include "Core/shader/ShaderDeclarations.h"

#include "Core/shader/ShaderWords.h"

#include <algorithm>
#include <sstream>

namespace vitrine
{

std::vector<std::string> SplitStatements(const std::string& line, const std::string& keyword)
{
  if (line.find(keyword) == std::string::npos)
  {
    return { line };
  }
  std::vector<std::string> statements;
  const std::size_t comment = line.find("//");
  std::size_t begin = 0;
  for (std::size_t end = line.find(';'); end < comment && end != std::string::npos;
       end = line.find(';', begin))
  {
    statements.push_back(line.substr(begin, end + 1 - begin));
    begin = end + 1;
  }
  statements.push_back(line.substr(begin));
  return statements;
}

// This parses every mapper's shaders, so it avoids slow regular expressions.
std::optional<ShaderDeclaration> ParseDeclaration(
  const std::string& statement, const std::string& keyword)
{
  const std::size_t start = statement.find_first_not_of(" \t");
  if (start == std::string::npos || statement.back() != ';' ||
    statement.compare(start, keyword.size(), keyword) != 0)
  {
    return std::nullopt;
  }
  std::istringstream words(statement.substr(start, statement.size() - 1 - start));
  std::string first;
  std::string declarator;
  ShaderDeclaration declaration;
  words >> first >> declaration.Type >> declarator;
  if (first != keyword)
  {
    return std::nullopt;
  }
  const auto nameEnd = std::find_if_not(declarator.begin(), declarator.end(), IsWordCharacter);
  declaration.Name.assign(declarator.begin(), nameEnd);
  declaration.Alone =
    nameEnd == declarator.end() && (words >> std::ws).eof() && !declaration.Name.empty();
  return declaration;
}

}
