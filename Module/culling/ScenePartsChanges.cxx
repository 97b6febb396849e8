// Finds the parts that have not changed since they were last looked at.

#include "culling/SceneParts.h"

#include "culling/PartChunks.h"
#include "culling/PropPolicy.h"
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
// The number of parts that are looked at while the objects of one come from memory.
const std::size_t PartsAhead = 12;

/** Prefetches the first cache lines of an object. */
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

/** Finds the parts of props, and notes that the frame has them. */
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

/**
 * Returns the part of a prop. It is quick if props come in the order of the last frame, though some may be left out.
 */
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

/** Adds a part for a prop, or for a piece if `prop` is null. Returns its number. */
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

/** Notes which parts surely have not changed. This only reads objects of VTK, so several threads do it. */
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
 * Returns true if drawing makes no images of textures. Pipelines that make images may make anything else, too, and VTK
 * runs them as it draws one actor after another. So only drawing tells what is drawn with the new data, and what with
 * the old.
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

/**
 * Prefetches what IsUnchanged() reads of a part and of objects of VTK, which lie all over memory. The objects need not
 * exist any more.
 */
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

/** Returns true if there is nothing to do for the part in each frame but to look whether it has changed. */
bool SceneParts::IsPlain(std::uint32_t i) const
{
  const Part& part = this->Parts[i];
  return part.Actor && !part.Divided && !part.HasTextures;
}

/** Returns true if filters make the data of the part. Then only one thread may look whether it has changed. */
bool SceneParts::HasPipeline(std::uint32_t i) const
{
  return !this->Parts[i].Producer && !this->Parts[i].Input;
}

/**
 * Returns true if no filter would make other data. The data may stand alone. The filter of a vtkDataSetMapper may have
 * made a surface of its current input. All filters may be as they were. Or the mapper draws whatever data there are.
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

/** Returns true if a part has not changed. The tests come in an order in which each object is known to exist. */
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
  return (!part.HasLevels || part.Actor->GetMapper() == part.OfActor) &&
    ShaderPropertyOf(prop) == part.Shader &&
    (!part.Shader || part.Shader->GetMTime() == part.ShaderTime) &&
    (!part.HasSurfaceMapper || part.SurfaceMapper->GetMTime() == part.SurfaceMapperTime) &&
    part.Mapper->GetMTime() == part.MapperTime && !MaySetUniforms(part.Mapper) &&
    DrawsSelection(part.Mapper) == part.HasSelection && AreDataMadeAlready(part) &&
    (!part.Divided || part.Divided->PartsFor(part.Actor, this->Looks) == part.Division) &&
    (part.Division || part.Geometry->TimeOf(part.Data, this->Looks) == part.DataTime);
}

}
