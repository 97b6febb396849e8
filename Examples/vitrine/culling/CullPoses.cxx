#include "culling/CullPoses.h"

#include <cmath>

namespace program
{

const std::map<std::string, PoseProjection>& NamesOfProjections()
{
  static const std::map<std::string, PoseProjection> names = { { "perspective",
                                                                 PoseProjection::Perspective },
    { "parallel", PoseProjection::Parallel }, { "both", PoseProjection::Both } };
  return names;
}

CullPoses::CullPoses(const Scene& scene, PoseProjection projection, std::uint64_t seed)
  : Bounds(SceneBounds(scene))
  , Radius(0.5 *
      std::sqrt(std::pow(this->Bounds[1] - this->Bounds[0], 2) +
        std::pow(this->Bounds[3] - this->Bounds[2], 2) +
        std::pow(this->Bounds[5] - this->Bounds[4], 2)))
  , Projection(projection)
  , Numbers(seed)
{
}

/** Uniform on the sphere. */
std::array<double, 3> CullPoses::Direction()
{
  const double z = this->Numbers.Between(-1.0, 1.0);
  const double angle = this->Numbers.Between(0.0, 2.0 * 3.14159265358979323846);
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

vtkSmartPointer<vtkCamera> CullPoses::Next()
{
  const std::array<double, 3> toward = this->Direction();
  const std::array<double, 3> up = this->Direction();
  const int place = this->Count % 3;
  double eye[3];
  double target[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = this->Bounds[2 * axis];
    const double high = this->Bounds[2 * axis + 1];
    target[axis] = this->Numbers.Between(low, high);
    const double within = this->Numbers.Between(low, high);
    const double middle = 0.5 * (low + high);
    eye[axis] = place == 1 ? within
      : place == 2         ? target[axis] + 0.3 * this->Radius * toward[axis]
                           : middle + 3.5 * this->Radius * toward[axis];
    target[axis] = place == 0 ? middle : target[axis];
  }
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(eye);
  camera->SetFocalPoint(target);
  camera->SetViewUp(up.data());
  camera->SetViewAngle(place == 0 ? 35.0 : 60.0);
  const bool isParallel = this->Projection == PoseProjection::Parallel ||
    (this->Projection == PoseProjection::Both && this->Count / 3 % 2 == 1);
  camera->SetParallelProjection(isParallel);
  camera->SetParallelScale(this->Radius * (place == 0 ? 1.0 : this->Numbers.Between(0.05, 0.6)));
  ++this->Count;
  return camera;
}

void CullPoses::Skip(int poses)
{
  for (int i = 0; i < poses; ++i)
  {
    this->Next();
  }
}

}
