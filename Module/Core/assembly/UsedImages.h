#ifndef VITRINE_CORE_ASSEMBLY_USED_IMAGES_H
#define VITRINE_CORE_ASSEMBLY_USED_IMAGES_H

#include "Core/assembly/Assembly.h"

#include <set>

namespace vitrine
{

/** Returns the numbers of a material's textures. NO_INDEX is among them where it lacks one. */
inline std::set<int> TexturesOf(const AssemblyMaterial& material)
{
  return { material.BaseColorTexture.Texture, material.MetallicRoughnessTexture.Texture,
    material.NormalTexture.Texture, material.OcclusionTexture.Texture,
    material.EmissionTexture.Texture };
}

/** Returns the numbers of the images that materials use. Those in KTX2 or WebP are none. */
inline std::set<int> UsedImages(const Assembly& assembly)
{
  std::set<int> used;
  for (const AssemblyMaterial& material : assembly.Materials)
  {
    for (const int texture : TexturesOf(material))
    {
      used.insert(texture == NO_INDEX ? NO_INDEX
                                      : assembly.Textures[static_cast<std::size_t>(texture)].Image);
    }
  }
  used.erase(NO_INDEX);
  return used;
}

}

#endif
