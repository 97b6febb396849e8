/**
 * Cameras all over a scene, from outside and from within, in both projections.
 */
#ifndef VITRINE_PROGRAM_CULL_POSES_H
#define VITRINE_PROGRAM_CULL_POSES_H

#include "scene/Random.h"
#include "scene/Scene.h"

#include "vtkCamera.h"
#include "vtkSmartPointer.h"

#include <map>
#include <string>

namespace program
{

/** Which projection poses have. */
enum class PoseProjection
{
  Perspective,
  Parallel,
  Both ///< in turns
};

/** As --projection and JSON call them. */
const std::map<std::string, PoseProjection>& NamesOfProjections();

/** The next of an endless row of poses, the same for the same seed. */
class CullPoses
{
public:
  CullPoses(const Scene& scene, PoseProjection projection, std::uint64_t seed);

  /** The scene is seen from outside, from within, or from near by, in turns. */
  vtkSmartPointer<vtkCamera> Next();

  /** Go past so many. */
  void Skip(int poses);

private:
  std::array<double, 3> Direction();

  std::array<double, 6> Bounds;
  double Radius;
  PoseProjection Projection;
  Random Numbers;
  int Count = 0;
};

}

#endif
