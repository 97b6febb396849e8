/**
 * What vtkAssemblyReader has read.
 */
#ifndef vtkVitrineAssemblyContent_h
#define vtkVitrineAssemblyContent_h

#include "Core/assembly/PartPattern.h"
#include "assembly/AssemblyLooks.h"
#include "assembly/AssemblyParts.h"
#include "vtkAssemblyReader.h"

#include <utility>
#include <vector>

/** The tree without its arrays, which are in the parts. */
struct vtkAssemblyReader::Content
{
  explicit Content(vitrine::Assembly assembly)
    : Source(std::move(assembly))
    , Looks(MakeAssemblyLooks(this->Source))
    , Parts(MakeAssemblyParts(this->Source))
  {
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Names.push_back({ this->Parts[i].Path, this->Looks[this->LookNumber(i)].Name });
    }
  }

  const AssemblyPart& Part(int part) const { return this->Parts[static_cast<std::size_t>(part)]; }

  /** Returns the number of a part's look. The last one is that of parts without a material. */
  std::size_t LookNumber(std::size_t part) const
  {
    const int material = this->Parts[part].Material;
    return material == vitrine::NO_INDEX ? this->Looks.size() - 1
                                         : static_cast<std::size_t>(material);
  }

  const AssemblyLook& LookOf(int part) const
  {
    return this->Looks[this->LookNumber(static_cast<std::size_t>(part))];
  }

  vitrine::Assembly Source;
  std::vector<AssemblyLook> Looks;
  std::vector<AssemblyPart> Parts;
  std::vector<vitrine::PartNames> Names; ///< by part
};

#endif
