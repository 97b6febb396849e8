#ifndef VITRINE_CORE_ASSEMBLY_ASSEMBLY_H
#define VITRINE_CORE_ASSEMBLY_ASSEMBLY_H

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vitrine
{

/** A file that cannot be read. what() says why in one line, without the file's name. */
class AssemblyError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The number of a mesh, a material, a texture or a node that is not there. */
constexpr int NO_INDEX = -1;

/** An encoded picture, as it was found in the file. */
struct AssemblyImage
{
  std::string Name;
  std::string MimeType; ///< "image/png" or "image/jpeg", by its first bytes; empty for all others
  std::vector<std::uint8_t> Bytes;
};

struct AssemblyTexture
{
  int Image = NO_INDEX;
  bool IsSmooth = true; ///< Texels are interpolated.
  bool HasMipmaps = true;
  bool Repeats = true; ///< Else texels of the edge are continued.
};

/** A texture of a material: which one, by which coordinates, and their affine transform (KHR_texture_transform). */
struct TextureUse
{
  int Texture = NO_INDEX;
  int Coordinates =
    0; ///< 0 or 1: AssemblyGeometry::TexCoords; 2 for further ones, which are not read
  glm::vec2 Offset{ 0.0f };
  glm::vec2 Scale{ 1.0f };
  float Rotation = 0.0f; ///< radians, counter-clockwise
};

/** How a material's alpha is meant. */
enum class AlphaMode
{
  Opaque, ///< Alpha is ignored.
  Mask,   ///< Alpha below the cutoff is a hole, and the rest is opaque.
  Blend
};

/** A material of glTF's metallic-roughness model. Colours are linear, in [0, 1]. */
struct AssemblyMaterial
{
  std::string Name;
  glm::vec4 BaseColor{ 1.0f }; ///< with alpha
  float Metallic = 1.0f;       ///< [0, 1]
  float Roughness = 1.0f;      ///< [0, 1]
  glm::vec3 Emission{ 0.0f };  ///< at least 0; times KHR_materials_emissive_strength
  AlphaMode Alpha = AlphaMode::Opaque;
  float AlphaCutoff = 0.0f; ///< Alpha below it is a hole, in the modes Mask and Blend.
  bool IsAlphaUniform =
    false; ///< Alpha is that of BaseColor; that of textures is ignored, in the mode Blend too.
  bool IsDoubleSided = false;
  bool IsUnlit = false;
  float IndexOfRefraction = 1.5f;
  float Specular = 1.0f; ///< strength of reflection at the surface, KHR_materials_specular
  TextureUse BaseColorTexture;
  TextureUse MetallicRoughnessTexture;
  TextureUse NormalTexture;
  TextureUse OcclusionTexture;
  TextureUse EmissionTexture;
  float NormalScale = 1.0f;
  float OcclusionStrength = 1.0f;
};

enum class CellKind
{
  Points = 1,
  Lines = 2,
  Triangles = 3
};

/** Cells of one kind and one material. Arrays beside the positions are empty or as long as these. */
struct AssemblyGeometry
{
  CellKind Kind = CellKind::Triangles;
  int Material = NO_INDEX;
  std::vector<glm::vec3> Positions; ///< model coordinates of the mesh
  std::vector<glm::vec3> Normals;
  std::vector<glm::vec4> Tangents;
  std::vector<glm::vec4> Colors; ///< linear RGBA in [0, 1]
  std::array<std::vector<glm::vec2>, 2> TexCoords;
  std::vector<std::uint32_t> Indices; ///< as many to a cell as its kind says

  std::size_t CellCount() const
  {
    return this->Indices.size() / static_cast<std::size_t>(this->Kind);
  }
};

/** Geometry that nodes share. */
struct AssemblyMesh
{
  std::string Name;
  std::vector<AssemblyGeometry> Geometries;
};

/** A node of the tree. */
struct AssemblyNode
{
  std::string Name;
  glm::dmat4 Transform{ 1.0 }; ///< coordinates of this node to those of its parent
  int Mesh = NO_INDEX;
  /** Places of the mesh in the node's coordinates. There is one at the origin if this is empty. */
  std::vector<glm::dmat4> Instances;
  std::vector<int> Children;
};

/** What a file of an assembly holds: a forest of nodes, of which each stands before its children. */
struct Assembly
{
  std::string Name;
  std::vector<int> Roots; ///< nodes
  std::vector<AssemblyNode> Nodes;
  std::vector<AssemblyMesh> Meshes;
  std::vector<AssemblyMaterial> Materials;
  std::vector<AssemblyTexture> Textures;
  std::vector<AssemblyImage> Images;
  std::string LengthUnit;         ///< of a file before its conversion, such as "inch"; may be empty
  std::vector<std::string> Notes; ///< what is shown otherwise than the file says, once each
};

}

#endif
