#ifndef VITRINE_CULLING_MAPPERS_DIVIDED_MAPPER_H
#define VITRINE_CULLING_MAPPERS_DIVIDED_MAPPER_H

#include "scene/ViewMatrices.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;

namespace vitrine
{

class PartGeometry;

/** One of the parts that a mapper draws one by one. */
struct MapperPart
{
  vtkPolyData* Data; ///< the data that have its points
  std::shared_ptr<PartGeometry> Geometry;
  bool MayHide; ///< false if colours or settings of its own may let light through
};

/** The parts of a mapper. They are valid as long as neither the mapper nor its data change. */
struct MapperParts
{
  std::vector<MapperPart> Parts;
  /** The largest absolute coordinates of all points in the buffers of the mapper. */
  glm::dvec3 Farthest{ 0.0 };
  bool IsFinite = true; ///< floats can hold all of these points
};

/** The result of a culler for one actor in one view: the parts of its mapper that may show. */
class ShownParts
{
public:
  /** @param shown  one byte per part: 1 if it may show, else 0 */
  ShownParts(const ViewMatrices& view, vtkActor* actor, std::shared_ptr<const MapperParts> parts,
    std::vector<std::uint8_t> shown);

  /**
   * Returns true if the actor and the view have not changed since then. Assemblies draw their actors at other places,
   * too, and passes for shadows draw all from the view of a light.
   */
  bool IsOf(vtkRenderer* renderer, vtkActor* actor) const;

  const std::shared_ptr<const MapperParts>& Division() const { return this->Parts; }
  const std::vector<std::uint8_t>& Shown() const { return this->IsShown; }

private:
  ViewMatrices View;
  std::array<double, 16> ToWorld;
  std::shared_ptr<const MapperParts> Parts;
  std::vector<std::uint8_t> IsShown;
};

/**
 * The parts that a mapper draws one by one, and which of them it is to draw. Cullers own what they tell the mapper, and
 * take it back after the frame. It holds for one actor and one renderer. Others that share the mapper do not share it.
 */
class DividedMapper
{
public:
  virtual ~DividedMapper() = default;

  /**
   * Returns the current parts of an actor. They are the same object as long as nothing has changed. Returns null for an
   * actor that is drawn as a whole.
   * @param frame  the current frame, the same for all callers for an actor
   */
  virtual std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) = 0;

  /** Sets which parts of an actor show in a renderer. That holds as long as somebody else keeps `shown`. */
  void SetShown(
    vtkRenderer* renderer, vtkActor* actor, const std::shared_ptr<const ShownParts>& shown);

  /** Returns what to draw of an actor. Returns null for all of it, which is what selectors need. */
  std::shared_ptr<const ShownParts> ShownIn(vtkRenderer* renderer, vtkActor* actor) const;

private:
  void ForgetWhatWasTakenBack();

  std::map<std::pair<vtkRenderer*, vtkActor*>, std::weak_ptr<const ShownParts>> Told;
  /** The size of Told from which entries that were taken back are removed. */
  std::size_t MostTold = 16;
};

/** Returns the divided mapper of a mapper that is one of this module, or null. */
DividedMapper* DividedMapperOf(vtkMapper* mapper);

}

#endif
