#ifndef VITRINE_CORE_ASSEMBLY_UNIQUE_NAMES_H
#define VITRINE_CORE_ASSEMBLY_UNIQUE_NAMES_H

#include <string>
#include <unordered_map>

namespace vitrine
{

/** Names tell things apart: the second "bolt" becomes "bolt (2)", unless that name is taken too. */
class UniqueNames
{
public:
  std::string Make(const std::string& name)
  {
    const int count = ++this->Seen[name];
    return count == 1 ? name : this->Make(name + " (" + std::to_string(count) + ")");
  }

private:
  std::unordered_map<std::string, int> Seen;
};

}

#endif
