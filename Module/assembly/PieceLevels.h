/** Which level each part of an actor of CoarseActors is drawn at. */
#ifndef VITRINE_ASSEMBLY_PIECE_LEVELS_H
#define VITRINE_ASSEMBLY_PIECE_LEVELS_H

#include "Core/levels/PixelLength.h"
#include "assembly/PartDetail.h"
#include "scene/ExactParts.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace vitrine
{

/** What levels are chosen for. */
struct LevelRequest
{
  PixelView View;
  double Pixels = 0.5; ///< by which points may move
  ExactParts Exact;
  double Reach = 0; ///< the greatest distance of points from the origin, in WC
};

/** A part in an actor. */
struct Piece
{
  std::shared_ptr<const PartDetail> Detail;
  vtkProp* Own;        ///< the prop that draws it without levels
  std::uint32_t First; ///< the number that its first point has in the actor
  bool IsMirrored;
  double Scale;    ///< by which its place makes lengths longer, at most
  double Rounding; ///< how far its points may be from their places
  glm::dvec3 Centre;
  double Radius;
  std::uint32_t FirstOfSpeck = 0; ///< the number of its first corner in the actor
  double BoundOfSpeck =
    std::numeric_limits<double>::infinity(); ///< as Bound; infinite if there is none

  /** What draws it. */
  enum DrawnBy
  {
    LEVEL,
    SPECK,
    OWN_PROP
  };
  DrawnBy By = LEVEL;
  int Level = -1;   ///< -1 for all triangles
  double Bound = 0; ///< how far its points may be from their places, levels included

  const std::vector<std::uint32_t>& Corners(int level) const;

  /** The number of its triangles in the actor. */
  std::size_t Triangles() const;

  /**
   * Returns true if a plane of ExactParts meets the ball around the part. Such a part has to be exact: where a face is
   * nearly parallel to a plane that cuts it, a small move of the face is a large one of its edge in the plane.
   */
  bool IsMetByPlane(const LevelRequest& asked) const;

  /**
   * Chooses what draws it: the fewest triangles with which no point moves by more than a length, and whose area is
   * nearly that of the part, unless these are many in each pixel. So many tiny parts hide together what they should,
   * and let as much light through.
   */
  void Choose(const LevelRequest& asked, double length);

  /** Returns true if the choice that was made before may be drawn. */
  bool IsRightFor(const LevelRequest& asked, double length) const;
};

/** Returns by how much points of a part may move, in WC, for some share of what is asked. */
double LengthFor(const Piece& piece, const LevelRequest& asked, double share = 1.0);

}

#endif
