#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MESHES_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MESHES_H

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/GltfDocument.h"

#include <glm/mat4x4.hpp>

#include <vector>

namespace vitrine
{

/** A mesh of a glTF in a pose. Nodes of equal pose share it. */
struct GltfPose
{
  std::size_t Mesh = 0;
  std::vector<float> Weights; ///< of morph targets; those of the mesh if empty
  /** From the mesh's coordinates to those of the world. They are none without a skin. */
  std::vector<glm::dmat4> Joints;

  bool operator<(const GltfPose& other) const;
};

/**
 * Reads a mesh in a pose. Strips, fans and loops become triangles and lines. Primitives without geometry are left out,
 * and so are vertices of which most are not used. Normals and tangents are left out where one is no finite number.
 * Several threads may call this.
 * @throws  AssemblyError if an index is beyond the vertices, or arrays have other lengths than the positions
 */
AssemblyMesh ReadGltfMesh(const GltfDocument& document, const GltfPose& pose);

}

#endif
