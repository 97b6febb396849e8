#include "inspection/Cutaway.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vitrine
{

namespace
{

/** How far the sides of the hole open towards the eye. */
const double Opening = glm::radians(15.0);

/** The eye, and where it looks. */
struct Eye
{
  explicit Eye(vtkRenderer* renderer)
  {
    vtkCamera* const camera = renderer->GetActiveCamera();
    camera->GetPosition(&this->Position.x);
    camera->GetDirectionOfProjection(&this->Along.x);
  }

  double DepthOf(const glm::dvec3& place) const
  {
    return glm::dot(place - this->Position, this->Along);
  }

  glm::dvec3 Position;
  glm::dvec3 Along;
};

/** A place of the window at a distance along the view, and the direction of its ray away from the eye. */
struct Place
{
  Place(const PixelRays& rays, const Eye& eye, double x, double y, double depth)
  {
    const glm::dvec3 near = rays.ToWorld({ x, y, 0.0 });
    const glm::dvec3 far = rays.ToWorld({ x, y, 1.0 });
    this->Away = glm::normalize(far - near);
    const double share = (depth - eye.DepthOf(near)) / glm::dot(this->Away, eye.Along);
    this->Point = near + share * this->Away;
  }

  glm::dvec3 Point;
  glm::dvec3 Away;
};

/** Returns the normal of a plane through two places that opens towards the eye, away from `middle`. */
glm::dvec3 SideNormal(const Place& a, const Place& b, const glm::dvec3& middle)
{
  const glm::dvec3 edge = glm::normalize(b.Point - a.Point);
  const glm::dvec3 away = glm::normalize(a.Away + b.Away);
  glm::dvec3 outwards = glm::normalize(glm::cross(edge, away));
  outwards *= glm::dot(outwards, a.Point - middle) < 0.0 ? -1.0 : 1.0;
  return glm::normalize(outwards * std::cos(Opening) + away * std::sin(Opening));
}
}

Cutaway::Cutaway()
{
  this->Section->RemoveBeyondAllOn();
  for (vtkSmartPointer<vtkPlane>& plane : this->Planes)
  {
    plane = vtkSmartPointer<vtkPlane>::New();
    this->Section->AddPlane(plane);
    this->Section->SetParts(plane, vtkSection::ONLY_CHOSEN);
  }
}

std::string Cutaway::ProblemOf(vtkRenderer* renderer) const
{
  vtkSection* const attached = vtkSection::GetAttached(renderer);
  return attached && attached != this->Section
    ? "a cutaway needs the section of the renderer, which has one already: remove it"
    : "";
}

void Cutaway::Suspend()
{
  for (vtkPlane* const plane : this->Planes)
  {
    this->Section->ClearChosenParts(plane);
  }
}

void Cutaway::Cut(vtkRenderer* renderer, const PixelRays& rays, const PixelRegion& region,
  double depth, const std::vector<ShownPart>& parts)
{
  const Eye eye(renderer);
  const double left = region.X;
  const double low = region.Y;
  const double right = left + region.Width;
  const double high = low + region.Height;
  const Place corners[4] = { { rays, eye, left, low, depth }, { rays, eye, right, low, depth },
    { rays, eye, right, high, depth }, { rays, eye, left, high, depth } };
  const glm::dvec3 middle = 0.5 * (corners[0].Point + corners[2].Point);
  const auto place = [this](std::size_t plane, const glm::dvec3& point, const glm::dvec3& normal)
  {
    this->Planes[plane]->SetOrigin(point.x, point.y, point.z);
    this->Planes[plane]->SetNormal(normal.x, normal.y, normal.z);
  };
  for (std::size_t side = 0; side < 4; ++side)
  {
    const Place& next = corners[(side + 1) % 4];
    place(side, corners[side].Point, SideNormal(corners[side], next, middle));
  }
  place(4, middle, eye.Along);
  this->Suspend();
  for (const ShownPart& part : parts)
  {
    for (vtkPlane* const plane : this->Planes)
    {
      this->Section->ChoosePart(plane, part.Prop, static_cast<int>(part.Block));
    }
  }
  if (this->Section->GetRenderer() != renderer)
  {
    this->Section->Attach(renderer);
  }
}

void Cutaway::Remove()
{
  this->Suspend();
  this->Section->Detach();
}

double Cutaway::DepthOf(vtkRenderer* renderer, const std::vector<BoxCorners>& boxes)
{
  const Eye eye(renderer);
  double depth = -std::numeric_limits<double>::infinity();
  for (const BoxCorners& box : boxes)
  {
    for (const glm::dvec3& corner : box)
    {
      depth = std::max(depth, eye.DepthOf(corner));
    }
  }
  return depth;
}

}
