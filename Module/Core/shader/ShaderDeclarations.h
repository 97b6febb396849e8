/**
 * The declarations at global scope of a shader as VTK writes it: statements that begin and end on one line.
 */
#ifndef VITRINE_CORE_SHADER_SHADER_DECLARATIONS_H
#define VITRINE_CORE_SHADER_SHADER_DECLARATIONS_H

#include <optional>
#include <string>
#include <vector>

namespace vitrine
{

struct ShaderDeclaration
{
  std::string Type;
  std::string Name;
  bool Alone; ///< one name, and no array
};

/**
 * A line in which `keyword` stands, cut behind each semicolon, since VTK declares several variables in one. Comments
 * stay in one piece, and so do other lines.
 */
std::vector<std::string> SplitStatements(const std::string& line, const std::string& keyword);

/** What a statement declares that begins with `keyword`, as "uniform" or "in"; none if it is something else. */
std::optional<ShaderDeclaration> ParseDeclaration(
  const std::string& statement, const std::string& keyword);

}
#endif
