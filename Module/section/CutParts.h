/** The parts that the planes of a section cut. */
#ifndef VITRINE_SECTION_CUT_PARTS_H
#define VITRINE_SECTION_CUT_PARTS_H

#include "section/PartData.h"
#include "section/SectionPlanes.h"

#include "vtkPolyData.h"
#include "vtkProp.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

class vtkActor;
class vtkProp;
class vtkRenderer;

namespace vitrine
{

/** A vertex of cut parts: its position relative to CutParts::Center(), and the slot of its part. */
struct CutVertex
{
  float Position[3];
  std::uint32_t Slot;
};

/** A part that a plane cuts. */
struct CutPart
{
  vtkWeakPointer<vtkProp> Prop;
  unsigned int Block = 0;
  std::uint32_t Number =
    0; ///< its number (PartNumbers), which tells in what order parts were asked for
  std::uint32_t Place =
    0; ///< its number among all parts of the renderer, in the order of props and blocks
  std::uint32_t Slot =
    0;              ///< its number among the parts that were cut, from 1, or 0 if it has no cap
  PlaneMasks Masks; ///< the planes that apply to it
  std::uint32_t Cuts = 0; ///< the planes that cut its box
  bool IsClosed = false;
  PartLook Look;
  glm::dvec3 Min; ///< its box in WC
  glm::dvec3 Max;
  std::uint32_t FirstCorner = 0; ///< in CutParts::Corners()
  std::uint32_t CornerCount = 0;
};

class CutParts
{
public:
  using MasksOf = std::function<PlaneMasks(vtkProp*, unsigned int)>;
  using MayCut = std::function<bool(vtkProp*)>;

  /**
   * Find the parts of all visible actors that the planes cut. Boxes decide. The geometry of parts is read when they are
   * cut for the first time, and again when they have changed. Glyphs, wireframes and points are found, but not read.
   * @param mayCut  returns false for a prop that no plane cuts, which is not asked for its data then
   * @param center  the center of the triangles, or null for the middle of the part that is read first
   */
  void Update(vtkRenderer* renderer, const SectionPlanes& planes, const MasksOf& masksOf,
    const MayCut& mayCut, const glm::dvec3* center);

  const std::vector<CutPart>& Parts() const { return this->Cut; }

  ///@{
  /** The triangles of all parts that were cut, in WC relative to Center(). They are appended to until Generation()
   * changes. */
  const std::vector<CutVertex>& Vertices() const { return this->AllVertices; }
  const std::vector<std::uint32_t>& Corners() const { return this->AllCorners; }
  const glm::dvec3& Center() const { return this->Middle; }
  std::uint64_t Generation() const { return this->GenerationNumber; }
  ///@}

  /** Returns true if a closed part contains a point in WC. */
  bool Contains(const CutPart& part, const glm::dvec3& point) const;

  /** The number of slots that were given. */
  std::uint32_t SlotCount() const { return this->NextSlot; }

  /** Changes when an image of the cut parts changes. */
  std::uint64_t Changes() const { return this->ChangeNumber; }

private:
  using Key = std::pair<vtkProp*, unsigned int>;
  /** A part whose geometry has been read. */
  struct Known
  {
    vtkWeakPointer<vtkPolyData> Data;
    vtkMTimeType DataTime = 0;
    glm::dmat4 ToWorld{ 1.0 };
    std::uint32_t Slot = 0;
    bool IsClosed = false;
    std::uint32_t FirstCorner = 0;
    std::uint32_t CornerCount = 0;
  };

  void Look(vtkActor* actor, const DrawnData& drawn, const glm::dmat4& toWorld,
    const SectionPlanes& planes, const MasksOf& masksOf);
  const Known& Read(vtkActor* actor, const DrawnData& drawn, const glm::dmat4& toWorld);
  std::size_t CountStaleCorners() const;
  void Forget();

  std::vector<CutPart> Cut;
  std::map<Key, Known> KnownParts;
  std::vector<CutVertex> AllVertices;
  std::vector<std::uint32_t> AllCorners;
  std::size_t StaleCorners = 0; ///< of parts that have changed
  bool HasManyGone = false;     ///< most of the known parts are no longer drawn
  glm::dvec3 Middle{ 0.0 };
  bool IsCenterGiven = false;
  std::uint32_t NextSlot = 1;
  std::uint64_t GenerationNumber = 1;
  std::uint64_t ChangeNumber = 1;
};

}

#endif
