#include "Core/assembly/gltf/GltfReader.h"

#include "Core/assembly/gltf/GltfDocument.h"
#include "Core/assembly/gltf/GltfMaterials.h"
#include "Core/assembly/gltf/GltfMeshes.h"
#include "Core/assembly/gltf/GltfNodes.h"
#include "Core/assembly/gltf/GltfNotes.h"
#include "Core/threads/ForEachInThreads.h"

#include <new>
#include <stdexcept>
#include <vector>

namespace vitrine
{

namespace
{
/** The alpha of a vertex by its material's mode (glTF 2.0, 3.9.4): a mask has holes, and is opaque elsewhere.
 * Between vertices of either kind it fades, where glTF has an edge. */
float ShownAlpha(const Assembly& assembly, int number, float alpha)
{
  if (number == NO_INDEX)
  {
    return 1.0f;
  }
  const AssemblyMaterial& material = assembly.Materials[static_cast<std::size_t>(number)];
  if (material.Alpha == AlphaMode::Mask)
  {
    return alpha * material.BaseColor.a >= material.AlphaCutoff ? 1.0f : 0.0f;
  }
  return material.Alpha == AlphaMode::Opaque || material.IsAlphaUniform ? 1.0f : alpha;
}

void ApplyAlphaModes(Assembly& assembly)
{
  for (AssemblyMaterial& material : assembly.Materials)
  {
    if (material.Alpha == AlphaMode::Opaque)
    {
      material.BaseColor.a = 1.0f;
    }
  }
  for (AssemblyMesh& mesh : assembly.Meshes)
  {
    for (AssemblyGeometry& geometry : mesh.Geometries)
    {
      for (glm::vec4& color : geometry.Colors)
      {
        color.a = ShownAlpha(assembly, geometry.Material, color.a);
      }
    }
  }
}

/** Returns a text of asset.extras, where converters tell of the files that they have converted. */
std::string TextOfExtras(const GltfDocument& document, const char* key)
{
  const GltfDocument::Json& extras = Member(Member(document.Root(), "asset"), "extras");
  const auto text = extras.find(key); // the end for all but objects
  return text != extras.end() && text->is_string() ? OneLine(text->get<std::string>())
                                                   : std::string();
}

Assembly Read(const std::filesystem::path& file, int scene)
{
  const GltfDocument document(file);
  Assembly assembly;
  assembly.LengthUnit = TextOfExtras(document, "lengthUnit");
  if (const std::string note = TextOfExtras(document, "note"); !note.empty())
  {
    assembly.Notes.push_back(note);
  }
  ReadGltfMaterials(document, assembly);
  const GltfScene shown = ReadGltfNodes(document, scene, assembly);
  assembly.Meshes.resize(shown.Poses.size());
  ForEachInThreads(shown.Poses.size(),
    [&](std::size_t i) { assembly.Meshes[i] = ReadGltfMesh(document, shown.Poses[i]); });
  ApplyAlphaModes(assembly);
  NoteWhatIsNotShown(document, shown, assembly);
  return assembly;
}
}

Assembly ReadGltf(const std::filesystem::path& file, int scene)
{
  try
  {
    return Read(file, scene);
  }
  catch (const nlohmann::json::exception&)
  {
    throw AssemblyError(
      "is damaged: a member of its JSON is missing or of another type than glTF says");
  }
  catch (const std::bad_alloc&)
  {
    throw AssemblyError("is damaged, or needs more memory than there is");
  }
}

}
