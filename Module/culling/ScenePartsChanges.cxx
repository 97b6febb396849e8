// Which parts are as they were when they were last looked at.

#include "culling/SceneParts.h"

#include "culling/PartChunks.h"
#include "scene/ActorRules.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"
#include "vtkTrivialProducer.h"

#include <algorithm>

namespace vitrine
{

namespace
{
// So many parts are looked at while the objects of one come from memory.
const std::size_t PartsAhead = 12;

/** Begins to load the first of the lines of a cache that an object fills. */
template <int Count>
void PrefetchLines(const void* object)
{
  const std::size_t lineBytes = 64;
  for (std::size_t i = 0; i < Count; ++i)
  {
    Prefetch(static_cast<const char*>(object) + i * lineBytes);
  }
}
}

/** Finds the parts of props, and notes that they are there. */
void SceneParts::FindAll(vtkProp* const* props, int count)
{
  this->Drawn.resize(static_cast<std::size_t>(count));
  this->Cursor = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t part = this->Find(props[i]);
    this->Drawn[static_cast<std::size_t>(i)] = part;
    this->SeenIn[part] = this->Frame;
  }
}

/** Props come in the same order from frame to frame, though some may be left out. */
std::uint32_t SceneParts::Find(vtkProp* prop)
{
  if (this->Cursor < this->PropOf.size() && this->PropOf[this->Cursor] == prop)
  {
    return this->Cursor++;
  }
  const auto [place, isNew] =
    this->Index.try_emplace(prop, static_cast<std::uint32_t>(this->Parts.size()));
  if (isNew)
  {
    this->AddPart(prop);
  }
  this->Cursor = place->second + 1;
  return place->second;
}

/** Of a prop, or of none. Returns its number. */
std::uint32_t SceneParts::AddPart(vtkProp* prop)
{
  this->Parts.emplace_back();
  this->PropOf.push_back(prop);
  this->Living.emplace_back();
  this->SeenIn.push_back(0);
  this->BoxOf.emplace_back();
  this->HasPieces.push_back(0);
  this->Blends.emplace_back();
  return static_cast<std::uint32_t>(this->Parts.size() - 1);
}

/** Notes which parts are surely as they were. VTK's objects are read alone for that, by as many threads as there are. */
void SceneParts::FindUnchanged()
{
  this->AreSame.resize(this->Drawn.size());
  PartChunks(this->Drawn.size())
    .ForEach(
      [&](std::size_t, std::size_t first, std::size_t end)
      {
        for (std::size_t i = first; i < end; ++i)
        {
          this->PrefetchOccluder(this->Drawn[std::min(i + 2 * PartsAhead, end - 1)]);
          this->PrefetchObjects(this->Drawn[std::min(i + PartsAhead, end - 1)]);
          const std::uint32_t part = this->Drawn[i];
          this->AreSame[i] =
            this->IsPlain(part) && !this->HasPipeline(part) && this->IsUnchanged(part);
        }
      });
}

/**
 * Whether drawing makes no images of textures. Whatever is made along with those may be anything, and VTK makes them as it draws one actor after another; so what is drawn with them, or of what was
 * there before, only drawing all of them tells.
 */
bool SceneParts::AreImagesMade() const
{
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    vtkActor* const actor =
      this->AreSame[i] ? nullptr : vtkActor::SafeDownCast(this->PropOf[this->Drawn[i]]);
    if (actor && !AreTexturesMade(actor))
    {
      return false;
    }
  }
  return true;
}

/** What is read of the part and of VTK's objects to see whether it is unchanged, which lie all over memory. They need not be there any more. */
void SceneParts::PrefetchObjects(std::uint32_t i) const
{
  const Part& part = this->Parts[i];
  PrefetchLines<8>(part.Actor);
  PrefetchLines<8>(part.Mapper);
  if (part.HasSurfaceMapper)
  {
    PrefetchLines<8>(part.SurfaceMapper);
    PrefetchLines<8>(part.Input);
    PrefetchLines<2>(part.Filter);
  }
  PrefetchLines<8>(part.Data);
  PrefetchLines<2>(part.Geometry.get());
  PrefetchLines<1>(part.Producer);
  PrefetchLines<1>(part.Shader);
}

/** Whether nothing else has to be done with it in each frame than to look whether it is unchanged. */
bool SceneParts::IsPlain(std::uint32_t i) const
{
  const Part& part = this->Parts[i];
  return part.Actor && !part.Divided && !part.HasTextures;
}

/** Whether filters make its data, so that one thread alone can look whether it is unchanged. */
bool SceneParts::HasPipeline(std::uint32_t i) const
{
  return !this->Parts[i].Producer && !this->Parts[i].Input;
}

/**
 * Whether no filter would make other data: not where the data stand by themselves, nor where a vtkDataSetMapper's own filter has made a surface of what is its input as it is now, nor where all filters
 * are as they were, nor for a mapper that draws what is there.
 */
bool SceneParts::AreDataMadeAlready(const Part& part)
{
  if (part.Producer)
  {
    return part.Producer->vtkObject::GetMTime() == part.ProducerTime;
  }
  if (part.Input)
  {
    return part.SurfaceMapper->GetInput() == part.Input &&
      part.Input->GetMTime() == part.InputTime && part.Filter->GetMTime() == part.FilterTime;
  }
  return part.Mapper->GetStatic() ? part.Mapper->GetInput() == part.Data
                                  : part.Pipeline.IsCurrent(part.Mapper);
}

/** Whether a part is as it was; in the order in which what holds the next is known to be there. */
bool SceneParts::IsUnchanged(std::uint32_t i) const
{
  const Part& part = this->Parts[i];
  vtkProp* const prop = this->PropOf[i];
  if (prop->GetMTime() != part.PropTime)
  {
    return false;
  }
  if (!part.Actor)
  {
    return true;
  }
  return ShaderPropertyOf(prop) == part.Shader &&
    (!part.Shader || part.Shader->GetMTime() == part.ShaderTime) &&
    (!part.HasSurfaceMapper || part.SurfaceMapper->GetMTime() == part.SurfaceMapperTime) &&
    part.Mapper->GetMTime() == part.MapperTime && !MaySetUniforms(part.Mapper) &&
    AreDataMadeAlready(part) &&
    (!part.Divided || part.Divided->PartsFor(part.Actor, this->Looks) == part.Division) &&
    (part.Division || part.Geometry->TimeOf(part.Data, this->Looks) == part.DataTime);
}

}
