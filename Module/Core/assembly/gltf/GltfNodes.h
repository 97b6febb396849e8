#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_NODES_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_NODES_H

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/GltfDocument.h"
#include "Core/assembly/gltf/GltfMeshes.h"

#include <vector>

namespace vitrine
{

/** What a scene shows. */
struct GltfScene
{
  std::vector<GltfPose> Poses;    ///< each pose that nodes show, once
  std::vector<std::size_t> Nodes; ///< numbers in the document
};

/**
 * Reads the nodes of a scene into an assembly, with their places at rest. Nodes refer to meshes by numbers of the
 * returned poses.
 * @param scene  number of the scene; that of the file, or else all nodes without a parent, if NO_INDEX
 * @throws       AssemblyError if the nodes form no tree, or the scene is not there
 */
GltfScene ReadGltfNodes(const GltfDocument& document, int scene, Assembly& assembly);

}

#endif
