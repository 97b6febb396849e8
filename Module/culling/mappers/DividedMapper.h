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
  vtkPolyData* Data; ///< that has its points
  std::shared_ptr<PartGeometry> Geometry;
  bool MayHide; ///< false where colours or settings of its own may let something through
};

/** The parts of a mapper, as long as neither it nor its data change. */
struct MapperParts
{
  std::vector<MapperPart> Parts;
  glm::dvec3 Farthest{
    0.0
  };                    ///< largest absolute coordinates of all that stands in the mapper's buffers
  bool IsFinite = true; ///< whether all of those are numbers that floats can hold
};

/** What a culler has found in one view of one actor: which parts of its mapper may show. */
class ShownParts
{
public:
  /** @param shown  1 for each of the parts that may show, 0 for the others */
  ShownParts(const ViewMatrices& view, vtkActor* actor, std::shared_ptr<const MapperParts> parts,
    std::vector<std::uint8_t> shown);

  /**
   * Whether the actor stands where it stood, and is seen as it was: assemblies draw their actors at other places, too, and passes
   * that cast shadows draw all from the light's.
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
 * The parts that a mapper draws one by one, and which of them it is to draw. Cullers own what they tell, and take it back when the
 * frame is done. It is told for an actor and a renderer: those that share the mapper do not share it.
 */
class DividedMapper
{
public:
  virtual ~DividedMapper() = default;

  /**
   * The parts as they are now: the same ones as long as nothing has changed. Null for an actor that is drawn as a whole.
   * @param frame  in which that is asked, of all that ask for those of an actor
   */
  virtual std::shared_ptr<const MapperParts> PartsFor(vtkActor* actor, vtkMTimeType frame) = 0;

  /** Says what shows of an actor in a renderer, as long as somebody holds it. */
  void SetShown(
    vtkRenderer* renderer, vtkActor* actor, const std::shared_ptr<const ShownParts>& shown);

  /** What to draw of an actor; null for all of it, which is what selectors need. */
  std::shared_ptr<const ShownParts> ShownIn(vtkRenderer* renderer, vtkActor* actor) const;

private:
  void ForgetWhatWasTakenBack();

  std::map<std::pair<vtkRenderer*, vtkActor*>, std::weak_ptr<const ShownParts>> Told;
  std::size_t MostTold = 16; ///< before it is looked for what was taken back
};

/** The parts of a mapper that is one of this module's; null for all others. */
DividedMapper* DividedMapperOf(vtkMapper* mapper);

}

#endif
