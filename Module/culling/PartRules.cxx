#include "culling/PartRules.h"

#include "culling/PartGeometry.h"
#include "culling/vtkHierarchicalSBufferCuller.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// How far antialiased and snapped lines and points reach beyond their width, in pixels.
const float BesidesWidth = 1.5f;

/** Returns the width of lines or points in pixels. */
float WidthOf(vtkActor* actor)
{
  return std::max(actor->GetProperty()->GetLineWidth(), actor->GetProperty()->GetPointSize());
}

/** Returns true if a device has points relative to the origin, whatever the mapper was told since. */
bool HasUnshiftedPoints(vtkOpenGLPolyDataMapper* mapper)
{
  vtkOpenGLVertexBufferObject* points = mapper->GetVBOs()->GetVBO("vertexMC");
  return points && points->GetUploadTime() > 0 && !points->GetCoordShiftAndScaleEnabled();
}
}

bool IsShiftKnown(vtkPolyDataMapper* mapper)
{
  const int method = static_cast<vtkOpenGLPolyDataMapper*>(mapper)->GetVBOShiftScaleMethod();
  return method == vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE ||
    method == vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE ||
    method == vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE;
}

bool IsSmallOrFarOff(const PartGeometry& geometry)
{
  const glm::dvec3 size = geometry.Greatest() - geometry.Least();
  const glm::dvec3 middle = 0.5 * (geometry.Greatest() + geometry.Least());
  // The limits of VTK are 1e6 and 3. Between these and ours VTK is taken not to shift, which is never the better case.
  return glm::dot(size, size) > 0.0 &&
    (glm::dot(middle, middle) / glm::dot(size, size) > 1.001e6 ||
      std::abs(std::log10(glm::dot(size, size))) > 3.001);
}

bool IsDrawnAboutMiddle(vtkPolyDataMapper* mapper, const PartGeometry& geometry)
{
  auto* drawing = static_cast<vtkOpenGLPolyDataMapper*>(mapper);
  const bool isUsual = !drawing->GetPauseShiftScale() &&
    drawing->GetVBOShiftScaleMethod() == vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE &&
    vtkOpenGLVertexBufferObject::GetGlobalCoordShiftAndScaleEnabled();
  return isUsual && IsSmallOrFarOff(geometry) && !HasUnshiftedPoints(drawing);
}

float GrowthOf(vtkActor* actor, const PartGeometry& geometry)
{
  const bool isThin =
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE || geometry.HasThinCells();
  return isThin ? WidthOf(actor) + BesidesWidth : 0.0f;
}

float MostGrowthOf(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  return BesidesWidth +
    std::max(
      { WidthOf(actor), property->GetSelectionLineWidth(), property->GetSelectionPointSize() });
}

bool IsNonOccluding(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  return keys && keys->Get(vtkHierarchicalSBufferCuller::NON_OCCLUDING()) != 0;
}

bool IsWireframe(vtkActor* actor)
{
  return actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME;
}

}
