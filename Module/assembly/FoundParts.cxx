#include "assembly/FoundParts.h"

#include "vtkIdList.h"

namespace vitrine
{

std::string FindParts(
  const std::vector<PartNames>& names, const std::string& pattern, vtkIdList* parts)
{
  if (!parts)
  {
    return "a list of numbers is needed for the parts";
  }
  parts->Reset();
  try
  {
    const PartPattern choice(pattern);
    for (const int part : choice.Choose(names))
    {
      parts->InsertNextId(part);
    }
    return parts->GetNumberOfIds() > 0 ? std::string() : choice.DescribeMiss(names);
  }
  catch (const PatternError& error)
  {
    return error.what();
  }
}

}
