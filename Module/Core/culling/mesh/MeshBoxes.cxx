#include "Core/culling/mesh/MeshBoxes.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vitrine
{

namespace
{

// Fewer faces are not divided between boxes: testing a box takes as long as projecting this many points.
const std::size_t LeastFacesOfABox = 8;

// A box with at most this many faces gets no child boxes.
const std::size_t FewFaces = 4 * LeastFacesOfABox;

int LongestAxis(const Box& box)
{
  const glm::vec3 size = box.Max - box.Min;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}
}

/** Builds the tree of boxes over the faces of a mesh. */
class MeshBoxes::Builder
{
public:
  Builder(const OccluderMesh& mesh, std::vector<Node>& tree)
    : Order(mesh.Faces().size())
    , Tree(tree)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0u);
    this->Boxes.reserve(this->Order.size());
    for (const MeshFace& face : mesh.Faces())
    {
      Box box;
      for (const std::uint32_t point : face)
      {
        const glm::vec3 place(
          mesh.Coordinates(0)[point], mesh.Coordinates(1)[point], mesh.Coordinates(2)[point]);
        box.Add({ place, place });
      }
      this->Boxes.push_back(box);
    }
  }

  void Build()
  {
    const Ends ends = this->AddNode(0, this->Order.size());
    for (int lane = 0; lane < this->Tree[0].Count; ++lane)
    {
      if (ends[lane + 1] - ends[lane] > FewFaces)
      {
        this->Tree[0].Nodes[lane] = static_cast<std::uint32_t>(this->Tree.size());
        this->AddNode(ends[lane], ends[lane + 1]);
      }
    }
  }

private:
  using Ends = std::array<std::size_t, LaneCount + 1>;

  /** Adds a node for a range of faces. Returns the ends of the ranges in its boxes. */
  Ends AddNode(std::size_t first, std::size_t end)
  {
    Node node;
    std::fill(std::begin(node.Nodes), std::end(node.Nodes), NoNode);
    Ends ends{ first, end };
    node.Count = 1;
    for (int count = 1; count < LaneCount; count *= 2)
    {
      node.Count = this->HalveAll(ends, node.Count);
    }
    for (int lane = 0; lane < node.Count; ++lane)
    {
      node.Boxes.Set(lane, this->BoxAround(ends[lane], ends[lane + 1]));
    }
    this->Tree.push_back(node);
    return ends;
  }

  /** Halves each of `count` ranges of faces that is long enough. Returns the new number of ranges. */
  int HalveAll(Ends& ends, int count)
  {
    const Ends before = ends;
    int made = 0;
    for (int i = 0; i < count; ++i)
    {
      const std::size_t size = before[i + 1] - before[i];
      if (size >= 2 * LeastFacesOfABox)
      {
        ends[++made] = before[i] + size / 2;
        this->Partition(before[i], ends[made], before[i + 1]);
      }
      ends[++made] = before[i + 1];
    }
    return made;
  }

  void Partition(std::size_t first, std::size_t middle, std::size_t end)
  {
    Box centres;
    for (std::size_t i = first; i < end; ++i)
    {
      const glm::vec3 centre = this->CentreOf(this->Order[i]);
      centres.Add({ centre, centre });
    }
    const int axis = LongestAxis(centres);
    const auto place = [this](std::size_t i)
    { return this->Order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(first), place(middle), place(end),
      [&](std::uint32_t a, std::uint32_t b)
      {
        const float centreOfA = this->CentreOf(a)[axis], centreOfB = this->CentreOf(b)[axis];
        return centreOfA != centreOfB ? centreOfA < centreOfB : a < b;
      });
  }

  glm::vec3 CentreOf(std::uint32_t face) const
  {
    return 0.5f * this->Boxes[face].Min + 0.5f * this->Boxes[face].Max;
  }

  Box BoxAround(std::size_t first, std::size_t end) const
  {
    Box box;
    for (std::size_t i = first; i < end; ++i)
    {
      box.Add(this->Boxes[this->Order[i]]);
    }
    return box;
  }

  std::vector<std::uint32_t> Order; ///< Order of the faces.
  std::vector<Box> Boxes;           ///< Boxes of the faces.
  std::vector<Node>& Tree;
};

MeshBoxes::MeshBoxes(const OccluderMesh& mesh)
  : MeshOrigin(mesh.Origin())
{
  if (!mesh.Faces().empty())
  {
    Builder(mesh, this->Tree).Build();
  }
}

}
