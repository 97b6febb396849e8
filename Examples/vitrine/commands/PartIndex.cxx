#include "commands/PartIndex.h"

#include "Core/assembly/PartPattern.h"
#include "Errors.h"

namespace program
{

vtkSmartPointer<vtkAssemblyIndex> MakePartIndex(const Scene& scene)
{
  auto index = vtkSmartPointer<vtkAssemblyIndex>::New();
  const std::vector<std::string> paths = PartPaths(scene);
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    index->AddPart(scene.Parts[i].Geometry, scene.Parts[i].Transform, paths[i]);
  }
  return index;
}

int FindPart(const Scene& scene, const std::string& option, const std::string& text)
{
  const std::vector<std::string> paths = PartPaths(scene);
  std::vector<vitrine::PartNames> names;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (paths[i] == text)
    {
      return static_cast<int>(i);
    }
    names.push_back({ paths[i], scene.Parts[i].MaterialName });
  }
  std::vector<int> found;
  std::string miss;
  try
  {
    const vitrine::PartPattern pattern(text);
    found = pattern.Choose(names);
    miss = found.empty() ? pattern.DescribeMiss(names) : "";
  }
  catch (const vitrine::PatternError& error)
  {
    miss = error.what();
  }
  if (found.empty())
  {
    throw InputError(option, miss);
  }
  if (found.size() > 1)
  {
    throw InputError(option,
      "'" + text + "' chooses " + std::to_string(found.size()) + " parts, such as '" +
        paths[static_cast<std::size_t>(found[0])] + "' and '" +
        paths[static_cast<std::size_t>(found[1])] + "'; name one");
  }
  return found[0];
}

}
