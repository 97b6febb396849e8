#ifndef VITRINE_STUDY_FACES_SCREEN_FACES_H
#define VITRINE_STUDY_FACES_SCREEN_FACES_H

#include "study/faces/ConvexFace.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** Faces with equally many corners on the screen, and the order of their insertion into an s-buffer. */
struct ScreenFaces
{
  std::vector<glm::dvec3> Points;
  /** Corners face by face, counter-clockwise from outside. */
  std::vector<std::uint32_t> Corners;
  std::size_t CornersPerFace = 3;

  std::vector<ScreenPoint> OnScreen; ///< One screen point for each of Corners.
  /** The face across each side; empty if unknown. */
  std::vector<std::uint32_t> Neighbours;
  std::vector<std::uint32_t> Sequence; ///< The faces that look towards the eye.

  /**
   * Projects the points from an eye outside, so that all are on the screen. The sequence becomes the order of Corners.
   */
  void Project(int columns, int lines);

  /** Sorts the sequence by the depth of each face's first corner, nearest first. */
  void SortFrontToBack();

  /** Returns the end of each face in Corners. */
  std::vector<std::uint32_t> Ends() const;

  ConvexFace Face(std::uint32_t face) const
  {
    const std::size_t first = face * this->CornersPerFace;
    return { &this->OnScreen[first], this->CornersPerFace, face,
      this->Neighbours.empty() ? nullptr : &this->Neighbours[first] };
  }
};

/** Returns a heap of 4000 rotated boxes, with faces of four corners. Some boxes cross. */
ScreenFaces TurnedBoxes();

/** Returns sixteen spheres with 20,000 triangles in all. Some spheres cross. */
ScreenFaces CrossingSpheres();

}

#endif
