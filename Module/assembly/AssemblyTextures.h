/**
 * The pictures of an assembly as VTK's textures.
 */
#ifndef vtkVitrineAssemblyTextures_h
#define vtkVitrineAssemblyTextures_h

#include "Core/assembly/Assembly.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

/** Decodes the pictures that materials use, each once. */
class AssemblyTextures
{
public:
  /** Decodes pictures in parallel. Damaged ones are noted. Throws AssemblyError if they are too large together. */
  explicit AssemblyTextures(vitrine::Assembly& assembly);

  /** Returns a texture of colours, or null if there is none, or if it is damaged or in a format that is not read. */
  vtkSmartPointer<vtkTexture> Colors(const vitrine::TextureUse& use);

  /**
   * Returns a texture of colours as they are shown, of a material without light. Its alpha is as the mode says: 1, or
   * 1 and 0 of a mask.
   * @param cutoff  of a mask. A lower alpha is a hole.
   */
  vtkSmartPointer<vtkTexture> ShownColors(
    const vitrine::TextureUse& use, vitrine::AlphaMode mode, double cutoff);

  /** Returns a texture of numbers, such as normals. */
  vtkSmartPointer<vtkTexture> Numbers(const vitrine::TextureUse& use);

  /**
   * Returns the texture of occlusion, roughness and metalness that VTK reads. Occlusion is 1 where there is no such
   * texture, or where it has other coordinates.
   */
  vtkSmartPointer<vtkTexture> OcclusionRoughnessMetalness(
    const vitrine::TextureUse& roughness, const vitrine::TextureUse& occlusion);

private:
  /** Throws AssemblyError if the pictures that are used are too large together. */
  void CheckSizes(const std::set<int>& used) const;

  vtkImageData* ImageOf(const vitrine::TextureUse& use) const;
  vtkSmartPointer<vtkTexture> Make(
    const vitrine::TextureUse& use, vtkImageData* image, bool isColor) const;

  const vitrine::Assembly& Source;
  std::vector<vtkSmartPointer<vtkImageData>> Images; ///< null for those that cannot be shown
  std::map<std::pair<int, bool>, vtkSmartPointer<vtkTexture>> Made;
  std::map<std::pair<int, int>, vtkSmartPointer<vtkTexture>> Merged;
};

#endif
