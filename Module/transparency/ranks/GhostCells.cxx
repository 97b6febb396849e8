#include "transparency/ranks/GhostCells.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkMapper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

namespace vitrine
{
namespace
{

// Returns true if a data set, or a block, has cells that are marked as duplicates.
bool HasDuplicates(vtkDataObject* data)
{
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> at;
    at.TakeReference(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      if (HasDuplicates(at->GetCurrentDataObject()))
      {
        return true;
      }
    }
    return false;
  }
  auto* const cellular = vtkDataSet::SafeDownCast(data);
  vtkUnsignedCharArray* const types = cellular ? cellular->GetCellGhostArray() : nullptr;
  if (!types)
  {
    return false;
  }
  const auto cells = vtk::DataArrayValueRange<1>(types);
  return std::any_of(cells.begin(), cells.end(),
    [](unsigned char type) { return (type & vtkDataSetAttributes::DUPLICATECELL) != 0; });
}

// Returns the data that an actor draws, as they are now.
vtkDataObject* InputOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
  }
  return mapper->GetInputDataObject(0, 0);
}

// Returns true if a mapper draws polygons with no more settings than those that are copied.
bool IsPlain(vtkMapper* mapper)
{
  return std::string(mapper->GetClassName()) == "vtkOpenGLPolyDataMapper";
}

// Copies the settings of a plain mapper, but not its input. The copy of VTK's OpenGL mapper calls deprecated functions
// and leaves out the method of shifting coordinates.
void CopySettings(vtkMapper* from, vtkMapper* to)
{
  auto* const toPlain = vtkOpenGLPolyDataMapper::SafeDownCast(to);
  const vtkSmartPointer<vtkDataObject> input = to->GetInputDataObject(0, 0);
  toPlain->vtkPolyDataMapper::ShallowCopy(from);
  toPlain->SetVBOShiftScaleMethod(
    vtkOpenGLPolyDataMapper::SafeDownCast(from)->GetVBOShiftScaleMethod());
  to->SetInputDataObject(input);
}

}

struct GhostCells::StandIn
{
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkMapper> Mapper;
  vtkMTimeType DataTime = 0;
  vtkMTimeType LookTime = 0; // of the user's actor and its mapper
};

GhostCells::GhostCells() = default;
GhostCells::~GhostCells() = default;
GhostCells::GhostCells(GhostCells&&) noexcept = default;
GhostCells& GhostCells::operator=(GhostCells&&) noexcept = default;

std::vector<vtkSmartPointer<vtkProp>> GhostCells::WithoutThem(const vtkRenderState* s)
{
  this->WhyKept.clear();
  this->Former = std::exchange(this->StandIns, {});
  std::vector<vtkSmartPointer<vtkProp>> props(
    s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  for (vtkSmartPointer<vtkProp>& prop : props)
  {
    prop = this->WithoutThem(prop);
  }
  this->Former.clear();
  return props;
}

vtkProp* GhostCells::WithoutThem(vtkProp* prop)
{
  if (!prop->GetVisibility() || !prop->HasTranslucentPolygonalGeometry())
  {
    return prop;
  }
  vtkProp* drawn = prop;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* const path = prop->GetNextPath())
  {
    auto* const actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
    if (!actor || !actor->GetMapper() || !HasDuplicates(InputOf(actor)))
    {
      continue;
    }
    if (actor == prop && IsPlain(actor->GetMapper()))
    {
      drawn = this->StandInOf(actor);
    }
    else
    {
      this->WhyKept = std::string("data of a ") + actor->GetMapper()->GetClassName() +
        " have ghost cells, which several ranks would draw; call vtkPolyData::RemoveGhostCells(), "
        "or draw their faces by a vtkPolyDataMapper of an actor of its own";
    }
  }
  return drawn;
}

vtkProp* GhostCells::StandInOf(vtkActor* actor)
{
  auto* const data = vtkPolyData::SafeDownCast(InputOf(actor));
  vtkMapper* const mapper = actor->GetMapper();
  StandIn& standIn = this->StandIns[actor];
  const auto found = this->Former.find(actor);
  if (found != this->Former.end())
  {
    standIn = found->second;
  }
  if (!standIn.Actor || standIn.DataTime != data->GetMTime())
  {
    vtkSmartPointer<vtkPolyData> clean = vtkSmartPointer<vtkPolyData>::New();
    clean->DeepCopy(data);
    clean->RemoveGhostCells();
    standIn.Mapper.TakeReference(mapper->NewInstance());
    standIn.Mapper->SetInputDataObject(clean);
    standIn.Actor.TakeReference(actor->NewInstance());
    standIn.DataTime = data->GetMTime();
    standIn.LookTime = 0;
  }
  const vtkMTimeType lookTime = std::max(actor->GetMTime(), mapper->GetMTime());
  if (standIn.LookTime != lookTime)
  {
    CopySettings(mapper, standIn.Mapper);
    standIn.Actor->ShallowCopy(actor);
    standIn.Actor->SetMapper(standIn.Mapper);
    standIn.Actor->SetForceOpaque(actor->GetForceOpaque());
    standIn.Actor->SetForceTranslucent(actor->GetForceTranslucent());
    standIn.LookTime = lookTime;
  }
  return standIn.Actor;
}

}
