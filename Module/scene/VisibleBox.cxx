#include "scene/VisibleBox.h"

#include "Core/geometry/Lanes.h"
#include "scene/ActorRules.h"
#include "scene/ClassName.h"
#include "scene/DrawingMapper.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkDataObject.h"
#include "vtkDataSetMapper.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace vitrine
{

namespace
{

/** The number of props that are looked at while the objects of one come from memory. */
const std::size_t PropsAhead = 12;

/** Prefetches the first cache lines of an object, which need not exist any more. */
template <std::size_t Lines>
void PrefetchLines(const void* object)
{
  const std::size_t lineBytes = 64;
  for (std::size_t i = 0; i < Lines; ++i)
  {
    vitrine::Prefetch(static_cast<const char*>(object) + i * lineBytes);
  }
}

/** Returns true if the mapper draws one data object, whose modification time tells of all changes of its bounds. */
bool DrawsOneDataSet(vtkMapper* mapper)
{
  return !mapper->IsA("vtkCompositePolyDataMapper2") &&
    !mapper->IsA("vtkCompositePolyDataMapper") && mapper->GetNumberOfInputConnections(0) == 1;
}
}

std::optional<Box> BoxAround(vtkProp* prop)
{
  const double* const bounds = prop->GetBounds();
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return std::nullopt;
  }
  return Box::Around({ bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] });
}

std::optional<Box> VisibleBox::Find(vtkRenderer* renderer)
{
  this->PutInOrder(renderer);
  Box all;
  for (std::size_t i = 0; i < this->All.size(); ++i)
  {
    this->Prefetch(std::min(i + PropsAhead, this->All.size() - 1));
    Known& known = this->All[i];
    if (!known.Prop->GetVisibility())
    {
      continue;
    }
    if (!IsUnchanged(known) && !Read(known))
    {
      return std::nullopt;
    }
    if (known.InWorld)
    {
      all.Add(*known.InWorld);
    }
  }
  return all;
}

/** Brings what is known into the order of the renderer's props. It is quick if these are those of the last frame. */
void VisibleBox::PutInOrder(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  const auto count = static_cast<std::size_t>(props->GetNumberOfItems());
  std::size_t same = 0;
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  vtkProp* prop = props->GetNextProp(place);
  while (prop && same < this->All.size() && this->All[same].Prop == prop)
  {
    ++same;
    prop = props->GetNextProp(place);
  }
  std::unordered_map<vtkProp*, Known> others;
  for (std::size_t i = same; i < this->All.size(); ++i)
  {
    others.emplace(this->All[i].Prop, this->All[i]);
  }
  this->All.resize(same);
  this->All.reserve(count);
  for (; prop; prop = props->GetNextProp(place))
  {
    const auto found = others.find(prop);
    this->All.push_back(found == others.end() ? Known() : found->second);
    this->All.back().Prop = prop;
  }
}

/** Returns true if a prop has not changed. The tests come in an order in which each object is known to exist. */
bool VisibleBox::IsUnchanged(const Known& known)
{
  // VTK counts times up: a prop at the address of a deleted one has a later time.
  return known.PropTime != 0 && known.Prop->GetMTime() == known.PropTime &&
    ShaderPropertyOf(known.Prop) == known.Shader &&
    (!known.Shader || known.Shader->GetMTime() == known.ShaderTime) &&
    known.Mapper->GetMTime() == known.MapperTime &&
    !MaySetUniforms(
      known.SurfaceMapper ? known.SurfaceMapper->GetPolyDataMapper() : known.Mapper) &&
    AreDataUnchanged(known);
}

bool VisibleBox::AreDataUnchanged(const Known& known)
{
  const bool areSame = known.Producer
    ? known.Producer->vtkObject::GetMTime() == known.ProducerTime
    : known.Pipeline.IsCurrent(static_cast<vtkPolyDataMapper*>(known.Mapper)) &&
      known.Mapper->GetInputDataObject(0, 0) == known.Data;
  return areSame && known.Data->GetMTime() == known.DataTime;
}

/** Reads the box of a prop anew. Returns false if the prop may be drawn outside its bounds. */
bool VisibleBox::Read(Known& known)
{
  known.PropTime = 0;
  if (vtkActor2D::SafeDownCast(known.Prop)) // lights do not shine on it
  {
    known.InWorld.reset();
    return true;
  }
  vtkActor* const actor = AsHideable(known.Prop);
  if (!actor)
  {
    return false;
  }
  known.Mapper = actor->GetMapper();
  const bool hasInput = DrawsOneDataSet(known.Mapper);
  known.Producer =
    hasInput ? vtkTrivialProducer::SafeDownCast(known.Mapper->GetInputAlgorithm()) : nullptr;
  const bool hasPipeline =
    hasInput && !known.Producer && IsExactly<vtkOpenGLPolyDataMapper>(known.Mapper);
  known.Pipeline =
    hasPipeline ? PipelineState(static_cast<vtkPolyDataMapper*>(known.Mapper)) : PipelineState();
  known.InWorld = BoxAround(actor);
  known.Data = known.Producer || hasPipeline ? known.Mapper->GetInputDataObject(0, 0) : nullptr;
  if (known.Data)
  {
    NoteTimes(known, actor);
  }
  return true;
}

/** Notes the times by which changes of an actor are noticed. */
void VisibleBox::NoteTimes(Known& known, vtkActor* actor)
{
  known.SurfaceMapper = SurfaceMapperOf(actor);
  known.ProducerTime = known.Producer ? known.Producer->vtkObject::GetMTime() : 0;
  known.DataTime = known.Data->GetMTime();
  known.MapperTime = known.Mapper->GetMTime();
  known.Shader = ShaderPropertyOf(actor);
  known.ShaderTime = known.Shader ? known.Shader->GetMTime() : 0;
  known.PropTime = actor->GetMTime();
}

/** Prefetches what IsUnchanged() reads of objects of VTK, which lie all over memory. They need not exist any more. */
void VisibleBox::Prefetch(std::size_t i) const
{
  const Known& known = this->All[i];
  PrefetchLines<8>(known.Prop);
  PrefetchLines<8>(known.Mapper);
  PrefetchLines<8>(known.Data);
  PrefetchLines<1>(known.Producer);
}

}
