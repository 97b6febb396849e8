#include "Core/assembly/gltf/GltfMeshes.h"

#include "Core/assembly/NormalMatrix.h"
#include "Core/assembly/gltf/DracoPrimitive.h"
#include "Core/assembly/gltf/GltfAccessors.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

namespace vitrine
{

namespace
{
using Json = GltfDocument::Json;

enum GltfMode
{
  GLTF_POINTS,
  GLTF_LINES,
  GLTF_LINE_LOOP,
  GLTF_LINE_STRIP,
  GLTF_TRIANGLES,
  GLTF_TRIANGLE_STRIP,
  GLTF_TRIANGLE_FAN
};

/** A primitive that is being read, with its data if that was compressed. */
class Primitive
{
public:
  Primitive(const GltfDocument& document, const Json& json, std::string name)
    : Document(document)
    , Description(json)
    , Name(std::move(name))
  {
    if (Extension(json, "KHR_draco_mesh_compression"))
    {
      this->Compressed = DecompressDracoPrimitive(document, json);
    }
  }

  bool Has(const char* attribute) const
  {
    return Member(this->Description, "attributes").contains(attribute);
  }

  /** Returns the number of vertices in its accessors, of which some may be in no cell. */
  std::size_t VertexCount() const
  {
    return DescribeGltfAccessor(this->Document, this->PositionAccessor()).Count;
  }

  /** Has attributes read of some vertices alone. */
  void Choose(std::vector<std::uint32_t> vertices) { this->Chosen = std::move(vertices); }

  /** Returns the elements of an attribute, or none if the primitive does not have it. */
  template <class Element>
  std::vector<Element> Read(const char* attribute) const
  {
    if (!this->Has(attribute))
    {
      return {};
    }
    const std::optional<ByteView> packed = this->Packed(attribute);
    return this->ReadAccessor<Element>(
      Member(this->Description, "attributes"), attribute, packed ? &*packed : nullptr);
  }

  /** Returns the elements of a morph target's attribute, which it has. */
  std::vector<glm::vec3> ReadTarget(const Json& target, const char* attribute) const
  {
    return this->ReadAccessor<glm::vec3>(target, attribute, nullptr);
  }

  /** Returns four numbers to a vertex. */
  std::vector<std::uint32_t> ReadJoints(const char* attribute) const
  {
    const std::optional<ByteView> packed = this->Packed(attribute);
    const auto accessor = this->Description.at("attributes").at(attribute).get<std::size_t>();
    this->CheckAccessor(accessor, attribute, 4);
    return ReadGltfIntegers(
      this->Document, accessor, packed ? &*packed : nullptr, this->ChosenOrAll());
  }

  /** Returns the vertices of the primitive in the order in which its mode takes them. */
  std::vector<std::uint32_t> ReadOrder() const
  {
    const std::size_t vertices = this->VertexCount();
    std::vector<std::uint32_t> order;
    if (this->Compressed)
    {
      order = this->Compressed->Indices;
    }
    else if (this->Description.contains("indices"))
    {
      order = ReadGltfIntegers(this->Document, this->Description.at("indices").get<std::size_t>());
    }
    else
    {
      order.resize(CountGltfElements(this->Document, this->PositionAccessor()));
      std::generate(order.begin(), order.end(), [i = 0u]() mutable { return i++; });
    }
    if (std::any_of(
          order.begin(), order.end(), [vertices](std::uint32_t i) { return i >= vertices; }))
    {
      throw AssemblyError("is damaged: " + this->Name + " has an index beyond its " +
        std::to_string(vertices) + " vertices");
    }
    return order;
  }

  bool IsCompressed() const { return this->Compressed.has_value(); }
  const Json& Text() const { return this->Description; }
  const GltfDocument& File() const { return this->Document; }
  const std::string& Called() const { return this->Name; }

private:
  std::size_t PositionAccessor() const
  {
    return Member(this->Description, "attributes").at("POSITION").get<std::size_t>();
  }

  template <class Element>
  std::vector<Element> ReadAccessor(
    const Json& attributes, const char* attribute, const ByteView* packed) const
  {
    const auto accessor = attributes.at(attribute).get<std::size_t>();
    this->CheckAccessor(accessor, attribute, 0);
    return ReadGltfElements<Element>(this->Document, accessor, packed, this->ChosenOrAll());
  }

  /** Checks that there is an element for each vertex. @param components  of an element; 0 for any */
  void CheckAccessor(
    std::size_t accessor, const std::string& attribute, std::size_t components) const
  {
    const GltfAccessor described = DescribeGltfAccessor(this->Document, accessor);
    const std::size_t vertices = this->VertexCount();
    if (described.Count != vertices || (components != 0 && described.Components != components))
    {
      throw AssemblyError("is damaged: " + this->Name + " has " + std::to_string(vertices) +
        " vertices and " + std::to_string(described.Count) + " of " + attribute);
    }
  }

  GltfChoice ChosenOrAll() const { return this->Chosen ? &*this->Chosen : nullptr; }

  std::optional<ByteView> Packed(const char* attribute) const
  {
    if (this->Compressed)
    {
      const auto found = this->Compressed->Attributes.find(attribute);
      if (found != this->Compressed->Attributes.end())
      {
        return ByteView{ found->second.data(), found->second.size() };
      }
    }
    return std::nullopt;
  }

  const GltfDocument& Document;
  const Json& Description;
  std::string Name;
  std::optional<DracoPrimitive> Compressed;
  std::optional<std::vector<std::uint32_t>> Chosen; ///< vertices; all without
};

/** Two to a line: of pairs, of a strip or of a loop. */
std::vector<std::uint32_t> LinesOf(const std::vector<std::uint32_t>& order, int mode)
{
  if (mode == GLTF_LINES)
  {
    return { order.begin(), order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2 * 2) };
  }
  std::vector<std::uint32_t> lines;
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    lines.insert(lines.end(), { order[i - 1], order[i] });
  }
  if (mode == GLTF_LINE_LOOP && order.size() > 2)
  {
    lines.insert(lines.end(), { order.back(), order.front() });
  }
  return lines;
}

/** Three to a triangle, counter-clockwise as glTF 2.0, 3.7.2.1 says. */
std::vector<std::uint32_t> TrianglesOf(const std::vector<std::uint32_t>& order, int mode)
{
  if (mode == GLTF_TRIANGLES)
  {
    return { order.begin(), order.begin() + static_cast<std::ptrdiff_t>(order.size() / 3 * 3) };
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < order.size(); ++i)
  {
    const bool isFan = mode == GLTF_TRIANGLE_FAN;
    const std::size_t odd = i % 2;
    const std::uint32_t corners[3] = { isFan ? order[0] : order[i],
      order[isFan ? i + 1 : i + 1 + odd], order[isFan ? i + 2 : i + 2 - odd] };
    triangles.insert(triangles.end(), std::begin(corners), std::end(corners));
  }
  return triangles;
}

void ReadCells(const Primitive& primitive, AssemblyGeometry& geometry)
{
  const int mode = primitive.Text().value("mode", static_cast<int>(GLTF_TRIANGLES));
  if (mode < GLTF_POINTS || mode > GLTF_TRIANGLE_FAN ||
    (primitive.IsCompressed() && mode < GLTF_TRIANGLES))
  {
    throw AssemblyError("is damaged: " + primitive.Called() + " is of no kind that there is");
  }
  std::vector<std::uint32_t> order = primitive.ReadOrder();
  if (mode == GLTF_POINTS)
  {
    geometry.Kind = CellKind::Points;
    geometry.Indices = std::move(order);
  }
  else if (mode < GLTF_TRIANGLES)
  {
    geometry.Kind = CellKind::Lines;
    geometry.Indices = LinesOf(order, mode);
  }
  else
  {
    // Draco stores single triangles, of strips too.
    geometry.Indices =
      TrianglesOf(order, primitive.IsCompressed() ? static_cast<int>(GLTF_TRIANGLES) : mode);
  }
}

void AddTarget(const Primitive& primitive, const Json& target, const char* attribute, float weight,
  std::vector<glm::vec3>& vectors)
{
  if (target.contains(attribute) && !vectors.empty())
  {
    const std::vector<glm::vec3> moved = primitive.ReadTarget(target, attribute);
    for (std::size_t i = 0; i < vectors.size(); ++i)
    {
      vectors[i] += weight * moved[i];
    }
  }
}

/** glTF 2.0, 3.7.2.2 */
void Morph(
  const Primitive& primitive, const std::vector<float>& weights, AssemblyGeometry& geometry)
{
  const Json& targets = Member(primitive.Text(), "targets");
  for (std::size_t i = 0; i < std::min(targets.size(), weights.size()); ++i)
  {
    if (weights[i] != 0.0f)
    {
      AddTarget(primitive, targets[i], "POSITION", weights[i], geometry.Positions);
      AddTarget(primitive, targets[i], "NORMAL", weights[i], geometry.Normals);
    }
  }
}

/** Adds up the weighted joints of each vertex that a set of attributes, "_0" or "_1", names. */
void AddJoints(const Primitive& primitive, const std::vector<glm::dmat4>& joints,
  const std::string& set, std::vector<glm::dmat4>& sums, std::vector<double>& weightSums)
{
  const std::vector<std::uint32_t> numbers = primitive.ReadJoints(("JOINTS" + set).c_str());
  const std::vector<glm::vec4> weights = primitive.Read<glm::vec4>(("WEIGHTS" + set).c_str());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const std::uint32_t joint = numbers[4 * i + static_cast<std::size_t>(j)];
      const double weight = static_cast<double>(weights[i][j]);
      if (joint >= joints.size())
      {
        throw AssemblyError(
          "is damaged: " + primitive.Called() + " has a joint that its skin does not have");
      }
      sums[i] += weight * joints[joint];
      weightSums[i] += weight;
    }
  }
}

glm::vec3 Turned(const glm::dmat3& matrix, const glm::vec3& direction)
{
  const glm::dvec3 turned = matrix * glm::dvec3(direction);
  const double length = glm::length(turned);
  return length > 0.0 ? glm::vec3(turned / length) : direction;
}

void MoveVertex(const glm::dmat4& place, std::size_t vertex, AssemblyGeometry& geometry)
{
  glm::vec3& position = geometry.Positions[vertex];
  position = glm::vec3(place * glm::dvec4(glm::dvec3(position), 1.0));
  if (!geometry.Normals.empty())
  {
    geometry.Normals[vertex] = Turned(NormalMatrix(glm::dmat3(place)), geometry.Normals[vertex]);
  }
  if (!geometry.Tangents.empty())
  {
    glm::vec4& tangent = geometry.Tangents[vertex];
    tangent = glm::vec4(Turned(glm::dmat3(place), glm::vec3(tangent)), tangent.w);
  }
}

/** glTF 2.0, 3.7.3: each vertex moves with the mean of its joints. Without a weight it stays. */
void Skin(
  const Primitive& primitive, const std::vector<glm::dmat4>& joints, AssemblyGeometry& geometry)
{
  std::vector<glm::dmat4> sums(geometry.Positions.size(), glm::dmat4(0.0));
  std::vector<double> weightSums(geometry.Positions.size(), 0.0);
  for (const std::string set : { "_0", "_1" })
  {
    if (primitive.Has(("JOINTS" + set).c_str()) && primitive.Has(("WEIGHTS" + set).c_str()))
    {
      AddJoints(primitive, joints, set, sums, weightSums);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    if (weightSums[i] > 0.0)
    {
      MoveVertex(sums[i] / weightSums[i], i, geometry);
    }
  }
}

template <class Vector>
bool HasFiniteNumbers(const Vector& vector)
{
  for (int i = 0; i < vector.length(); ++i)
  {
    if (!std::isfinite(vector[i]))
    {
      return false;
    }
  }
  return true;
}

template <class Vector>
bool AreFinite(const std::vector<Vector>& vectors)
{
  return std::all_of(vectors.begin(), vectors.end(), HasFiniteNumbers<Vector>);
}

/** Positions must be finite. Directions can be left out, and the rest set to 0. */
void KeepFinite(const Primitive& primitive, AssemblyGeometry& geometry)
{
  if (!AreFinite(geometry.Positions))
  {
    throw AssemblyError(
      "is damaged: " + primitive.Called() + " has coordinates that are not finite numbers");
  }
  if (!AreFinite(geometry.Normals))
  {
    geometry.Normals.clear();
  }
  if (!AreFinite(geometry.Tangents))
  {
    geometry.Tangents.clear();
  }
  for (std::vector<glm::vec2>& coordinates : geometry.TexCoords)
  {
    std::replace_if(
      coordinates.begin(), coordinates.end(),
      [](const glm::vec2& uv) { return !HasFiniteNumbers(uv); }, glm::vec2(0.0f));
  }
  for (glm::vec4& color : geometry.Colors)
  {
    for (int i = 0; i < 4; ++i)
    {
      color[i] = color[i] > 0.0f ? std::min(color[i], 1.0f) : 0.0f;
    }
  }
}

/** Leaves out vertices without a cell where there are many, as of primitives that share one buffer of vertices. */
void ChooseUsedVertices(Primitive& primitive, std::vector<std::uint32_t>& indices)
{
  if (indices.size() >= primitive.VertexCount())
  {
    return;
  }
  std::vector<std::uint32_t> used = indices;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& index : indices)
  {
    index =
      static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), index) - used.begin());
  }
  primitive.Choose(std::move(used));
}

template <class Element>
std::size_t BytesOf(const std::vector<Element>& elements)
{
  return elements.size() * sizeof(Element);
}

std::size_t BytesOf(const AssemblyGeometry& geometry)
{
  return BytesOf(geometry.Positions) + BytesOf(geometry.Normals) + BytesOf(geometry.Tangents) +
    BytesOf(geometry.Colors) + BytesOf(geometry.TexCoords[0]) + BytesOf(geometry.TexCoords[1]) +
    BytesOf(geometry.Indices);
}

AssemblyGeometry ReadGeometry(
  Primitive& primitive, const GltfPose& pose, const std::vector<float>& weights)
{
  AssemblyGeometry geometry;
  geometry.Material = primitive.Text().value("material", NO_INDEX);
  ReadCells(primitive, geometry);
  ChooseUsedVertices(primitive, geometry.Indices);
  geometry.Positions = primitive.Read<glm::vec3>("POSITION");
  geometry.Normals = primitive.Read<glm::vec3>("NORMAL");
  geometry.Tangents = primitive.Read<glm::vec4>("TANGENT");
  geometry.Colors = primitive.Read<glm::vec4>("COLOR_0");
  geometry.TexCoords[0] = primitive.Read<glm::vec2>("TEXCOORD_0");
  geometry.TexCoords[1] = primitive.Read<glm::vec2>("TEXCOORD_1");
  Morph(primitive, weights, geometry);
  if (!pose.Joints.empty())
  {
    Skin(primitive, pose.Joints, geometry);
  }
  KeepFinite(primitive, geometry);
  primitive.File().Spend(BytesOf(geometry));
  return geometry;
}

std::vector<float> WeightsOf(const Json& mesh, const GltfPose& pose)
{
  if (!pose.Weights.empty())
  {
    return pose.Weights;
  }
  std::vector<float> weights;
  for (const Json& weight : Member(mesh, "weights"))
  {
    weights.push_back(weight.get<float>());
  }
  return weights;
}

const double* Numbers(const std::vector<glm::dmat4>& matrices)
{
  return matrices.empty() ? nullptr : glm::value_ptr(matrices.front());
}
}

bool GltfPose::operator<(const GltfPose& other) const
{
  if (std::tie(this->Mesh, this->Weights) != std::tie(other.Mesh, other.Weights))
  {
    return std::tie(this->Mesh, this->Weights) < std::tie(other.Mesh, other.Weights);
  }
  const double* const mine = Numbers(this->Joints);
  const double* const others = Numbers(other.Joints);
  return std::lexicographical_compare(
    mine, mine + 16 * this->Joints.size(), others, others + 16 * other.Joints.size());
}

AssemblyMesh ReadGltfMesh(const GltfDocument& document, const GltfPose& pose)
{
  const Json& json = document.Object("meshes", pose.Mesh);
  const std::vector<float> weights = WeightsOf(json, pose);
  AssemblyMesh mesh;
  mesh.Name = NameOf(json);
  const Json& primitives = Member(json, "primitives");
  for (std::size_t i = 0; i < primitives.size(); ++i)
  {
    Primitive primitive(document, primitives[i],
      "primitive " + std::to_string(i) + " of mesh " + std::to_string(pose.Mesh));
    if (primitive.Has("POSITION"))
    {
      mesh.Geometries.push_back(ReadGeometry(primitive, pose, weights));
    }
  }
  return mesh;
}

}
