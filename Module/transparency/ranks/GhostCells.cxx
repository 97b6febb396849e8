#include "transparency/ranks/GhostCells.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArrayRange.h"
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

bool HasDuplicates(vtkPolyData* data)
{
  vtkUnsignedCharArray* const types = data ? data->GetCellGhostArray() : nullptr;
  if (!types)
  {
    return false;
  }
  const auto cells = vtk::DataArrayValueRange<1>(types);
  return std::any_of(cells.begin(), cells.end(),
    [](unsigned char type) { return (type & vtkDataSetAttributes::DUPLICATECELL) != 0; });
}

bool HasDuplicates(vtkCompositeDataSet* blocks)
{
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(blocks->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    if (HasDuplicates(vtkPolyData::SafeDownCast(at->GetCurrentDataObject())))
    {
      return true;
    }
  }
  return false;
}

// Copies the settings of a mapper, but not its input. The copy of VTK's OpenGL mapper calls deprecated functions and
// leaves out the method of shifting coordinates.
void CopySettings(vtkMapper* from, vtkMapper* to)
{
  auto* const toPolyData = vtkOpenGLPolyDataMapper::SafeDownCast(to);
  auto* const fromPolyData = vtkOpenGLPolyDataMapper::SafeDownCast(from);
  const vtkSmartPointer<vtkDataObject> input = to->GetInputDataObject(0, 0);
  if (toPolyData && fromPolyData)
  {
    toPolyData->vtkPolyDataMapper::ShallowCopy(from);
    toPolyData->SetVBOShiftScaleMethod(fromPolyData->GetVBOShiftScaleMethod());
  }
  else
  {
    to->ShallowCopy(from);
  }
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

std::vector<vtkProp*> GhostCells::WithoutThem(const vtkRenderState* s)
{
  this->WhyKept.clear();
  this->Former = std::exchange(this->StandIns, {});
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  for (vtkProp*& prop : props)
  {
    auto* const actor = vtkActor::SafeDownCast(prop);
    prop = actor && actor->GetMapper() ? this->StandInOf(actor) : prop;
  }
  this->Former.clear();
  return props;
}

vtkProp* GhostCells::StandInOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) > 0)
  {
    mapper->Update();
  }
  vtkDataObject* const input = mapper->GetInputDataObject(0, 0);
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (blocks && HasDuplicates(blocks))
  {
    this->WhyKept = "some blocks have ghost cells, which several ranks would draw; call "
                    "vtkPolyData::RemoveGhostCells() of each block";
  }
  auto* const data = vtkPolyData::SafeDownCast(input);
  if (!data || !HasDuplicates(data))
  {
    return actor;
  }
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
    standIn.LookTime = lookTime;
  }
  return standIn.Actor;
}

}
