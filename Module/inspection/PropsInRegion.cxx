#include "inspection/PropsInRegion.h"

#include "inspection/PixelRays.h"
#include "scene/ActorRules.h"
#include "scene/Matrices.h"
#include "scene/PartNumbers.h"
#include "vtkCulledCompositePolyDataMapper.h" // the base of composite mappers

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace vitrine
{
namespace
{

/** Pixels by which lines and points of usual width, and rounding, may reach beyond the bounds of a prop. */
constexpr double Margin = 3.0;

/** Returns by how many pixels an actor's lines and points reach beyond its bounds. */
double MarginOf(vtkActor* actor)
{
  vtkProperty* const property = actor->GetProperty();
  return Margin +
    std::max<double>(std::max(property->GetLineWidth(), property->GetPointSize()), 0.0);
}

/** Returns the latest time of data and all that is below them. */
vtkMTimeType TimeOf(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      time = std::max(time, TimeOf(child));
    }
  }
  return time;
}

/** Adds the bounds of all points in data, hidden blocks included. */
void AddBounds(vtkDataObject* data, vtkBoundingBox& box)
{
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      AddBounds(child, box);
    }
  }
  else if (auto* const points = vtkDataSet::SafeDownCast(data))
  {
    if (points->GetNumberOfPoints() > 0)
    {
      box.AddBounds(points->GetBounds());
    }
  }
}

/**
 * Returns true if a node or one below it may be opaque. The innermost visibility and opacity count, as in VTK.
 * @param opacity  what the node inherits
 */
bool MayHaveOpaqueBlocks(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* node,
  double opacity, bool isVisible)
{
  opacity = attributes->HasBlockOpacity(node) ? attributes->GetBlockOpacity(node) : opacity;
  isVisible =
    attributes->HasBlockVisibility(node) ? attributes->GetBlockVisibility(node) : isVisible;
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(node))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      if (MayHaveOpaqueBlocks(attributes, child, opacity, isVisible))
      {
        return true;
      }
    }
    return false;
  }
  return isVisible && !(opacity < 1.0);
}

/** Returns true if an actor may have opaque geometry. VTK looks at the property alone, not at those of blocks. */
bool MayHaveOpaque(vtkActor* actor)
{
  auto* const mapper = dynamic_cast<VITRINE_COMPOSITE_MAPPER*>(actor->GetMapper());
  vtkDataObject* const blocks = mapper ? BlocksOf(actor) : nullptr;
  auto* const attributes = mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
  const bool isOfBlocks = blocks && attributes && !actor->GetForceOpaque();
  return actor->HasOpaqueGeometry() != 0 &&
    (!isOfBlocks ||
      MayHaveOpaqueBlocks(attributes, blocks, actor->GetProperty()->GetOpacity(), true));
}

/** Returns the box around data where an actor draws them. It is absent if there are no points. */
std::optional<Box> BoxInWorld(vtkActor* actor, vtkDataObject* data)
{
  vtkBoundingBox inModel;
  AddBounds(data, inModel);
  if (!inModel.IsValid())
  {
    return std::nullopt;
  }
  const glm::dmat4 toWorld = MatrixOf(actor->GetMatrix());
  glm::dvec3 least(std::numeric_limits<double>::infinity()), most = -least;
  for (int corner = 0; corner < 8; ++corner)
  {
    double place[3];
    inModel.GetCorner(corner, place);
    const glm::dvec4 at = toWorld * glm::dvec4(place[0], place[1], place[2], 1.0);
    least = glm::min(least, glm::dvec3(at) / at.w);
    most = glm::max(most, glm::dvec3(at) / at.w);
  }
  return Box::Around(least, most);
}

/** A pyramid of pixels, as four planes in clip coordinates. */
class Pyramid
{
public:
  Pyramid(const PixelRays& rays, const PixelRegion& region)
    : ToClip(rays.ToClip())
    , Least(rays.ToDevice({ double(region.X), double(region.Y), 0.0 }))
    , Most(
        rays.ToDevice({ double(region.X) + region.Width, double(region.Y) + region.Height, 0.0 }))
    , Pixel(rays.ToDevice({ 1.0, 1.0, 0.0 }) - rays.ToDevice({ 0.0, 0.0, 0.0 }))
  {
  }

  /** Returns false only if no point of the box is within `margin` pixels. */
  bool MayMeet(const Box& box, double margin) const
  {
    const glm::dvec3 low(box.Min), high(box.Max);
    const glm::dvec3 least = this->Least - margin * this->Pixel;
    const glm::dvec3 most = this->Most + margin * this->Pixel;
    std::array<int, 4> outside{};
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec4 at = this->ToClip *
        glm::dvec4((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
          (corner & 4) != 0 ? high.z : low.z, 1.0);
      outside[0] += at.x < least.x * at.w ? 1 : 0;
      outside[1] += at.x > most.x * at.w ? 1 : 0;
      outside[2] += at.y < least.y * at.w ? 1 : 0;
      outside[3] += at.y > most.y * at.w ? 1 : 0;
    }
    return std::none_of(outside.begin(), outside.end(), [](int count) { return count == 8; });
  }

private:
  glm::dmat4 ToClip;
  glm::dvec3 Least;
  glm::dvec3 Most;
  glm::dvec3 Pixel; ///< size of a pixel in device coordinates
};
}

bool PropsInRegion::Known::operator==(const Known& other) const
{
  return this->ActorTime == other.ActorTime && this->Mapper == other.Mapper &&
    this->MapperTime == other.MapperTime && this->Shader == other.Shader &&
    this->ShaderTime == other.ShaderTime && this->Data == other.Data &&
    this->DataTime == other.DataTime;
}

std::vector<vtkProp*> PropsInRegion::Find(
  vtkRenderer* renderer, const PixelRegion& region, bool onlyOpaque)
{
  const PixelRays rays(renderer);
  std::vector<vtkProp*> found;
  vtkPropCollection* const props = renderer->GetViewProps();
  const auto count = static_cast<std::size_t>(props->GetNumberOfItems());
  if (this->Boxes.size() > 2 * count + 64)
  {
    this->Boxes.clear(); // Most of them are gone.
  }
  this->Watch(renderer);
  const Pyramid pyramid(rays, region);
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    if (!prop->GetVisibility() || vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
    {
      continue;
    }
    vtkActor* const actor = vtkActor::SafeDownCast(prop);
    if (!actor || !actor->GetMapper())
    {
      found.push_back(prop);
      continue;
    }
    const Known& known = this->Look(actor);
    if (onlyOpaque && !known.HasOpaque)
    {
      continue;
    }
    if (known.IsAnywhere || MaySetUniforms(actor->GetMapper()) ||
      (known.InWorld && pyramid.MayMeet(*known.InWorld, MarginOf(actor))))
    {
      found.push_back(prop);
    }
  }
  return found;
}

/** Counts the frames of a renderer from now on. */
void PropsInRegion::Watch(vtkRenderer* renderer)
{
  if (this->Watched == renderer)
  {
    return;
  }
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->Observer);
  }
  ++this->Frame;
  this->Watched = renderer;
  this->Observer =
    renderer ? renderer->AddObserver(vtkCommand::EndEvent, this, &PropsInRegion::NoteFrame) : 0;
}

/** Returns what is known of an actor, after reading it anew if it has changed. */
const PropsInRegion::Known& PropsInRegion::Look(vtkActor* actor)
{
  Known now;
  now.ActorTime = actor->GetMTime();
  now.Mapper = actor->GetMapper();
  now.MapperTime = now.Mapper->GetMTime();
  now.Shader = ShaderPropertyOf(actor);
  now.ShaderTime = now.Shader ? now.Shader->GetMTime() : 0;
  now.Data =
    now.Mapper->GetNumberOfInputConnections(0) > 0 ? now.Mapper->GetInputDataObject(0, 0) : nullptr;
  Known& known = this->Boxes[actor];
  const bool isRead = known.Data == now.Data && known.Frame == this->Frame;
  now.DataTime = isRead ? known.DataTime : now.Data ? TimeOf(now.Data) : 0;
  known.Frame = now.Frame = this->Frame;
  const bool isSame = now == known;
  if (!isSame || !isRead)
  {
    known.HasOpaque = now.HasOpaque = MayHaveOpaque(actor);
  }
  if (!isSame)
  {
    now.IsAnywhere = !AsHideable(actor) || !now.Data;
    now.InWorld = now.IsAnywhere ? std::nullopt : BoxInWorld(actor, now.Data);
    known = now;
  }
  return known;
}

}
