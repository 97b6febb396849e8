#include "transparency/stencil/PixelSizedPrimitives.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkSmartPointer.h"

namespace vitrine
{
namespace
{

bool HasLinesOrPoints(vtkDataObject* data)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    return polyData->GetNumberOfLines() > 0 || polyData->GetNumberOfVerts() > 0;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return false;
  }
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    if (HasLinesOrPoints(leaves->GetCurrentDataObject()))
    {
      return true;
    }
  }
  return false;
}

bool HasLinesOrPointsAt(vtkMapper* mapper, int port)
{
  for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
  {
    if (HasLinesOrPoints(mapper->GetInputDataObject(port, i)))
    {
      return true;
    }
  }
  return false;
}

// Some mappers draw spheres, sticks or glyphs in place of points and lines. Their size is given in scene units.
bool DrawsLinesOrPoints(vtkMapper* mapper)
{
  if (mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper"))
  {
    return false;
  }
  // Port 1 has the glyph that is drawn at each point.
  const int drawn = mapper->IsA("vtkGlyph3DMapper") ? 1 : 0;
  return mapper->GetNumberOfInputPorts() > drawn && HasLinesOrPointsAt(mapper, drawn);
}

bool DrawsLinesOrPoints(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  return property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility() || (mapper && DrawsLinesOrPoints(mapper));
}

}

std::string FindPixelSizedPrimitives(const vtkRenderState* s)
{
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(s->GetPropArray()[i]);
    if (actor && actor->HasTranslucentPolygonalGeometry() && DrawsLinesOrPoints(actor))
    {
      return "translucent lines and points would be thinner in a target with several pixels for "
             "one";
    }
  }
  return {};
}

}
