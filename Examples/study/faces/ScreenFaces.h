#ifndef VITRINE_STUDY_FACES_SCREEN_FACES_H
#define VITRINE_STUDY_FACES_SCREEN_FACES_H

#include "study/faces/ConvexFace.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** Faces of equally many corners as they stand on the screen, and the order in which they are inserted into an s-buffer. */
struct ScreenFaces
{
  std::vector<glm::dvec3> Points;
  std::vector<std::uint32_t>
    Corners; ///< of one face after the other, counter-clockwise from outside
  std::size_t CornersPerFace = 3;

  std::vector<ScreenPoint> OnScreen; ///< one for each of Corners
  std::vector<std::uint32_t>
    Neighbours;                        ///< the face across each side; empty where that is not known
  std::vector<std::uint32_t> Sequence; ///< the faces that look towards the eye

  /** Views the points from outside, so that all of them are on the screen. The sequence is the order of Corners then. */
  void Project(int columns, int lines);

  /** Orders the sequence by the depth of each face's first corner. */
  void SortFrontToBack();

  /** Where in Corners each face ends. */
  std::vector<std::uint32_t> Ends() const;

  ConvexFace Face(std::uint32_t face) const
  {
    const std::size_t first = face * this->CornersPerFace;
    return { &this->OnScreen[first], this->CornersPerFace, face,
      this->Neighbours.empty() ? nullptr : &this->Neighbours[first] };
  }
};

/** A heap of 4000 turned boxes, with faces of four corners; they cross each other here and there. */
ScreenFaces TurnedBoxes();

/** Sixteen spheres of 20,000 triangles in all; some of them cross. */
ScreenFaces CrossingSpheres();

}

#endif
