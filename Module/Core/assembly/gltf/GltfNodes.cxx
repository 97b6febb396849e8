#include "Core/assembly/gltf/GltfNodes.h"

#include "Core/assembly/gltf/GltfAccessors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

namespace vitrine
{

namespace
{
// CAD systems nest some 20 levels.
constexpr std::size_t MOST_NODES_OF_A_PATH = 1000;

using Json = GltfDocument::Json;

constexpr std::size_t MOST_INSTANCES = 10'000'000; // of a node

std::vector<double> Numbers(const Json& node, const char* key, std::size_t count)
{
  const Json& json = Member(node, key);
  std::vector<double> numbers;
  for (const Json& number : json)
  {
    numbers.push_back(number.get<double>());
  }
  if (!numbers.empty() && numbers.size() != count)
  {
    throw AssemblyError(std::string("is damaged: a ") + key + " of a node has " +
      std::to_string(numbers.size()) + " numbers");
  }
  return numbers;
}

glm::dmat4 Place(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale)
{
  const double length = glm::length(rotation);
  const glm::dquat unit = length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
  return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(unit) *
    glm::scale(glm::dmat4(1.0), scale);
}

glm::dmat4 TransformOf(const Json& node)
{
  const std::vector<double> matrix = Numbers(node, "matrix", 16);
  if (!matrix.empty())
  {
    glm::dmat4 transform;
    std::copy(matrix.begin(), matrix.end(), &transform[0][0]);
    return glm::dmat4(
      glm::dmat4x3(transform)); // The last row of an affine transform is 0, 0, 0, 1.
  }
  const std::vector<double> t = Numbers(node, "translation", 3);
  const std::vector<double> r = Numbers(node, "rotation", 4);
  const std::vector<double> s = Numbers(node, "scale", 3);
  return Place(t.empty() ? glm::dvec3(0.0) : glm::dvec3(t[0], t[1], t[2]),
    r.empty() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : glm::dquat(r[3], r[0], r[1], r[2]),
    s.empty() ? glm::dvec3(1.0) : glm::dvec3(s[0], s[1], s[2]));
}

bool IsFinite(const glm::dmat4& matrix)
{
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum += glm::dot(matrix[i], glm::dvec4(0.0));
  }
  return std::isfinite(sum);
}

template <class Element>
std::vector<Element> InstanceElements(
  const GltfDocument& document, const Json& attributes, const char* name)
{
  return attributes.is_object() && attributes.contains(name)
    ? ReadGltfElements<Element>(document, attributes.at(name).get<std::size_t>())
    : std::vector<Element>();
}

/** EXT_mesh_gpu_instancing: one place of the mesh for each element. */
std::vector<glm::dmat4> InstancesOf(const GltfDocument& document, const Json& node)
{
  const Json* const extension = Extension(node, "EXT_mesh_gpu_instancing");
  if (!extension)
  {
    return {};
  }
  const Json& attributes = Member(*extension, "attributes");
  const auto t = InstanceElements<glm::vec3>(document, attributes, "TRANSLATION");
  const auto r = InstanceElements<glm::vec4>(document, attributes, "ROTATION");
  const auto s = InstanceElements<glm::vec3>(document, attributes, "SCALE");
  const std::size_t count = std::max({ t.size(), r.size(), s.size() });
  if (count > MOST_INSTANCES)
  {
    throw AssemblyError("has " + std::to_string(count) + " instances in a node; at most " +
      std::to_string(MOST_INSTANCES) + " are drawn");
  }
  for (const std::size_t size : { t.size(), r.size(), s.size() })
  {
    if (size != 0 && size != count)
    {
      throw AssemblyError("is damaged: attributes of instances have different lengths");
    }
  }
  document.Spend(count * sizeof(glm::dmat4));
  std::vector<glm::dmat4> places(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    places[i] = Place(t.empty() ? glm::dvec3(0.0) : glm::dvec3(t[i]),
      r.empty() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : glm::dquat(r[i].w, r[i].x, r[i].y, r[i].z),
      s.empty() ? glm::dvec3(1.0) : glm::dvec3(s[i]));
  }
  if (!std::all_of(places.begin(), places.end(), IsFinite))
  {
    throw AssemblyError("is damaged: the place of an instance is not made of finite numbers");
  }
  return places;
}

/** Goes through the tree, and finds the place in the world of each node. */
class TreeWalk
{
public:
  TreeWalk(const GltfDocument& document, Assembly& assembly)
    : Document(document)
    , Result(assembly)
    , Worlds(document.Objects("nodes").size(), glm::dmat4(1.0))
    , Paths(document.Objects("nodes").size())
    , Numbers(document.Objects("nodes").size(), NO_INDEX)
  {
  }

  /** Adds a tree, without recursion. */
  void AddTree(std::size_t root)
  {
    this->Result.Roots.push_back(this->AddNode(root, glm::dmat4(1.0), {}));
    std::vector<std::size_t> open{ root };
    while (!open.empty())
    {
      const std::size_t node = open.back();
      open.pop_back();
      for (const Json& child : Member(this->Document.Object("nodes", node), "children"))
      {
        const std::size_t number = child.get<std::size_t>();
        const int added = this->AddNode(number, this->Worlds[node], this->Paths[node]);
        this->Result.Nodes[static_cast<std::size_t>(this->Numbers[node])].Children.push_back(added);
        open.push_back(number);
      }
    }
  }

  std::vector<std::size_t> Nodes() const
  {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      if (this->Has(i))
      {
        nodes.push_back(i);
      }
    }
    return nodes;
  }

  bool Has(std::size_t node) const { return this->Numbers[node] != NO_INDEX; }
  int NumberOf(std::size_t node) const { return this->Numbers[node]; }
  const glm::dmat4& WorldOf(std::size_t node) const { return this->Worlds[node]; }

private:
  /** Of the names from the root to a node. */
  struct PathSize
  {
    std::size_t Nodes = 0;
    std::size_t Bytes = 0;
  };

  int AddNode(std::size_t number, const glm::dmat4& parent, const PathSize& path)
  {
    if (this->Has(number))
    {
      throw AssemblyError("is damaged: its nodes form no tree");
    }
    const Json& json = this->Document.Object("nodes", number);
    AssemblyNode node;
    node.Name = NameOf(json);
    node.Transform = TransformOf(json);
    node.Instances = InstancesOf(this->Document, json);
    this->Paths[number] = { path.Nodes + 1, path.Bytes + node.Name.size() + 1 };
    this->CheckPath(this->Paths[number], node.Instances.size());
    this->Worlds[number] = parent * node.Transform;
    if (!IsFinite(this->Worlds[number]))
    {
      throw AssemblyError("is damaged: the place of node " + std::to_string(number) +
        " is not made of finite numbers");
    }
    this->Numbers[number] = static_cast<int>(this->Result.Nodes.size());
    this->Result.Nodes.push_back(std::move(node));
    return this->Numbers[number];
  }

  /** Each node and each instance has its whole path as its name. */
  void CheckPath(const PathSize& path, std::size_t instances) const
  {
    if (path.Nodes > MOST_NODES_OF_A_PATH)
    {
      throw AssemblyError("has a tree of nodes that is deeper than " +
        std::to_string(MOST_NODES_OF_A_PATH) + "; deeper ones are not read");
    }
    this->Document.Spend((1 + instances) * path.Bytes);
  }

  const GltfDocument& Document;
  Assembly& Result;
  std::vector<glm::dmat4> Worlds;
  std::vector<PathSize> Paths;
  std::vector<int> Numbers; // in the assembly, by number in the document
};

std::vector<std::size_t> NodesWithoutParent(const GltfDocument& document)
{
  const Json& nodes = document.Objects("nodes");
  std::vector<bool> isChild(nodes.size(), false);
  for (const Json& node : nodes)
  {
    for (const Json& child : Member(node, "children"))
    {
      isChild[child.get<std::size_t>()] = true;
    }
  }
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (!isChild[i])
    {
      roots.push_back(i);
    }
  }
  if (roots.empty() && !nodes.empty())
  {
    throw AssemblyError("is damaged: its nodes form no tree");
  }
  return roots;
}

std::vector<std::size_t> RootsOf(const GltfDocument& document, int scene, Assembly& assembly)
{
  const Json& scenes = document.Objects("scenes");
  const bool isChosen = scene != NO_INDEX;
  const std::size_t number =
    isChosen ? static_cast<std::size_t>(scene) : Number(document.Root(), "scene", 0);
  if (scenes.empty() && !isChosen)
  {
    return NodesWithoutParent(document);
  }
  if (number >= scenes.size())
  {
    throw AssemblyError("has no scene " +
      (isChosen ? std::to_string(scene) : std::to_string(number)) + "; there are " +
      std::to_string(scenes.size()));
  }
  if (scenes.size() > 1 && !isChosen)
  {
    assembly.Notes.push_back("has " + std::to_string(scenes.size()) + " scenes; scene " +
      std::to_string(number) + " is shown");
  }
  assembly.Name = NameOf(scenes[number]);
  std::vector<std::size_t> roots;
  for (const Json& root : Member(scenes[number], "nodes"))
  {
    roots.push_back(root.get<std::size_t>());
  }
  return roots;
}

/** The places of a skin's joints at rest, times the inverse of their places when the mesh was bound to them. */
std::vector<glm::dmat4> JointsOf(
  const GltfDocument& document, const TreeWalk& walk, std::size_t number)
{
  const Json& skin = document.Object("skins", number);
  const Json& joints = Member(skin, "joints");
  document.Spend(joints.size() * sizeof(glm::dmat4));
  std::vector<glm::mat4> inverse(joints.size(), glm::mat4(1.0f));
  if (skin.contains("inverseBindMatrices"))
  {
    const auto matrices =
      ReadGltfElements<glm::mat4>(document, skin.at("inverseBindMatrices").get<std::size_t>());
    std::copy_n(matrices.begin(), std::min(matrices.size(), inverse.size()), inverse.begin());
  }
  std::vector<glm::dmat4> places;
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const std::size_t joint = joints[i].get<std::size_t>();
    if (!walk.Has(joint))
    {
      throw AssemblyError("is damaged: a skin has a joint that is not in the scene");
    }
    places.push_back(walk.WorldOf(joint) * glm::dmat4(inverse[i]));
    if (!IsFinite(places.back()))
    {
      throw AssemblyError("is damaged: the place of a joint is not made of finite numbers");
    }
  }
  return places;
}

/** Finds for each mesh the first one that is the same. OpenCASCADE writes one for each instance. */
class MeshTwins
{
public:
  explicit MeshTwins(const Json& meshes)
  {
    std::unordered_map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      this->Firsts.push_back(
        known.emplace(meshes[i].dump(-1, ' ', false, IGNORE), i).first->second);
    }
  }

  std::size_t FirstOf(std::size_t mesh) const { return this->Firsts[mesh]; }

private:
  static constexpr auto IGNORE = Json::error_handler_t::ignore; // of bytes that are no UTF-8
  std::vector<std::size_t> Firsts;
};

GltfPose PoseOf(
  const GltfDocument& document, const MeshTwins& twins, const TreeWalk& walk, const Json& node)
{
  GltfPose pose;
  pose.Mesh = twins.FirstOf(node.at("mesh").get<std::size_t>());
  for (const Json& weight : Member(node, "weights"))
  {
    pose.Weights.push_back(weight.get<float>());
  }
  if (node.contains("skin"))
  {
    pose.Joints = JointsOf(document, walk, node.at("skin").get<std::size_t>());
  }
  return pose;
}

/** Numbers poses in the order in which they come. */
class PoseNumbers
{
public:
  int NumberOf(GltfPose pose)
  {
    const auto [place, isNew] =
      this->Numbers.emplace(std::move(pose), static_cast<int>(this->Numbers.size()));
    return place->second;
  }

  std::vector<GltfPose> Poses() const
  {
    std::vector<GltfPose> poses(this->Numbers.size());
    for (const auto& [pose, number] : this->Numbers)
    {
      poses[static_cast<std::size_t>(number)] = pose;
    }
    return poses;
  }

private:
  std::map<GltfPose, int> Numbers;
};

/** A skinned mesh is placed by its joints alone. Returns false if the place of its node cannot be undone. */
bool UndoPlace(const glm::dmat4& world, AssemblyNode& node)
{
  node.Instances = { glm::inverse(world) };
  return glm::determinant(world) != 0.0 && IsFinite(node.Instances.front());
}

std::vector<GltfPose> AssignPoses(
  const GltfDocument& document, const TreeWalk& walk, Assembly& assembly)
{
  const Json& nodes = document.Objects("nodes");
  const MeshTwins twins(document.Objects("meshes"));
  PoseNumbers numbers;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (walk.Has(i) && nodes[i].contains("mesh"))
    {
      AssemblyNode& node = assembly.Nodes[static_cast<std::size_t>(walk.NumberOf(i))];
      GltfPose pose = PoseOf(document, twins, walk, nodes[i]);
      if (!pose.Joints.empty() && !UndoPlace(walk.WorldOf(i), node))
      {
        assembly.Notes.push_back(
          "the skinned mesh of node '" + node.Name + "' is left out: its node is scaled to 0");
        node.Instances.clear();
        continue;
      }
      node.Mesh = numbers.NumberOf(std::move(pose));
    }
  }
  return numbers.Poses();
}
}

GltfScene ReadGltfNodes(const GltfDocument& document, int scene, Assembly& assembly)
{
  TreeWalk walk(document, assembly);
  for (const std::size_t root : RootsOf(document, scene, assembly))
  {
    walk.AddTree(root);
  }
  return { AssignPoses(document, walk, assembly), walk.Nodes() };
}

}
