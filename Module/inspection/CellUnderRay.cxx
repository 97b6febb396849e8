#include "inspection/CellUnderRay.h"

#include "inspection/PixelRays.h"
#include "scene/Matrices.h"

#include "vtkActor.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkMapper.h"
#include "vtkNew.h"

#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{
namespace
{

/** A layer is of a cell if they are as near as this share of the part's size, and these roundings of depths. */
constexpr double NearShare = 1e-4;
constexpr double DepthRounding = 1e-6;

/** Returns the node of a flat index below `node`, whose own flat index is `at`. Counts `at` on. */
vtkDataObject* NodeOf(vtkDataObject* node, unsigned int& at, unsigned int wanted)
{
  if (at == wanted)
  {
    return node;
  }
  ++at;
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(node))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      vtkDataObject* const found = NodeOf(child, at, wanted);
      if (found || at > wanted)
      {
        return found;
      }
    }
  }
  return nullptr;
}

vtkDataSet* DataOf(vtkActor* actor, unsigned int block)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (vtkDataObject* const blocks = BlocksOf(actor))
  {
    unsigned int at = 0;
    return vtkDataSet::SafeDownCast(NodeOf(blocks, at, block));
  }
  return mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
}

/** Returns true if a segment may meet a box that is somewhat larger than `bounds`. */
bool MayMeet(const double bounds[6], const glm::dvec3& from, const glm::dvec3& to, double slack)
{
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double way = to[axis] - from[axis];
    const double low = bounds[2 * axis] - slack - from[axis];
    const double high = bounds[2 * axis + 1] + slack - from[axis];
    if (way == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return false;
      }
      continue;
    }
    first = std::max(first, std::min(low / way, high / way));
    last = std::min(last, std::max(low / way, high / way));
  }
  return first <= last;
}
}

vtkIdType CellUnderRay(const ShownPart& part, const PixelRays& rays, const glm::dvec3& inWindow)
{
  vtkActor* const actor = vtkActor::SafeDownCast(part.Prop);
  vtkDataSet* const data = actor ? DataOf(actor, part.Block) : nullptr;
  if (!data)
  {
    return -1;
  }
  const glm::dmat4 toModel = glm::inverse(MatrixOf(actor->GetMatrix()));
  const glm::dvec3 near = rays.ToWorld({ inWindow.x, inWindow.y, 0.0 });
  const glm::dvec3 far = rays.ToWorld({ inWindow.x, inWindow.y, 1.0 });
  const glm::dvec3 from(toModel * glm::dvec4(near, 1.0));
  const glm::dvec3 to(toModel * glm::dvec4(far, 1.0));
  const double slack = 1e-9 * std::max(data->GetLength(), 1e-30);
  vtkNew<vtkGenericCell> cell;
  vtkIdType nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    double bounds[6];
    data->GetCellBounds(id, bounds);
    if (!MayMeet(bounds, from, to, slack))
    {
      continue;
    }
    data->GetCell(id, cell);
    double t = 0.0, place[3], parameters[3];
    int subId = 0;
    if (cell->GetCellDimension() < 2 ||
      !cell->IntersectWithLine(&from[0], &to[0], slack, t, place, parameters, subId))
    {
      continue;
    }
    const double depth = rays.ToWindow(near + t * (far - near)).z;
    const double away = std::abs(depth - inWindow.z);
    // Caps of sections show a part where none of its cells is.
    const double beside = t + NearShare * data->GetLength() / glm::length(to - from);
    const double most =
      DepthRounding + std::abs(rays.ToWindow(near + beside * (far - near)).z - depth);
    if (away < least && away <= most)
    {
      least = away;
      nearest = id;
    }
  }
  return nearest;
}

}
