/** Declarations at global scope of a shader as VTK writes it. Each statement begins and ends on one line. */
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
  bool Alone; ///< True if the statement declares a single name that is no array.
};

/**
 * Splits a line that contains `keyword` behind each semicolon, because VTK declares several variables per line.
 * Comments and other lines stay whole.
 */
std::vector<std::string> SplitStatements(const std::string& line, const std::string& keyword);

/**
 * Returns the declaration of a statement that begins with `keyword`, such as "uniform" or "in". Returns nothing for
 * other statements.
 */
std::optional<ShaderDeclaration> ParseDeclaration(
  const std::string& statement, const std::string& keyword);

}
#endif
