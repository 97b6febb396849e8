/**
 * Scenes of parts, and by brute force what is seen of them.
 */
#ifndef VITRINE_TESTING_PART_SCENES_H
#define VITRINE_TESTING_PART_SCENES_H

#include "OccluderScenes.h"

#include "Core/culling/steady/FacePlanes.h"
#include "Core/culling/walk/PartCuller.h"
#include "Core/culling/walk/ShapeSource.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace coverage
{

using vitrine::Box;
using vitrine::LooseOctree;
using vitrine::Occluder;
using vitrine::PartCuller;

/** Parts, their places, what they hide with, and what they are whatever they hide, which is the same. */
class PartScene : public vitrine::ShapeSource
{
public:
  /** @returns its number */
  std::uint32_t Add(const Triangles& triangles, const glm::dmat4& toWorld = glm::dmat4(1.0))
  {
    Part part;
    part.Mesh = std::make_shared<OccluderMesh>(triangles.Mesh());
    if (part.Mesh->PointCount() > vitrine::FewPointsOfAMesh)
    {
      part.Boxes = std::make_shared<vitrine::MeshBoxes>(*part.Mesh);
    }
    part.Planes = std::make_shared<vitrine::FacePlanes>(triangles.Points, triangles.Corners);
    part.ToWorld = toWorld;
    part.FromWorld = glm::inverse(toWorld);
    glm::dvec3 low(1e300), high(-1e300);
    for (const std::uint32_t corner : triangles.Corners)
    {
      const glm::dvec3 point(toWorld * glm::dvec4(triangles.Points[corner], 1.0));
      part.Corners.push_back(point);
      low = glm::min(low, point);
      high = glm::max(high, point);
      glm::dvec3 &farthest = part.Drawn.Farthest, &inWorld = part.Drawn.InWorld;
      farthest = glm::max(farthest, glm::abs(triangles.Points[corner]));
      inWorld = glm::max(inWorld, SumsOf(toWorld, triangles.Points[corner]));
    }
    const glm::dvec3& sums = part.Drawn.InWorld;
    this->Reach = std::max({ this->Reach, sums.x, sums.y, sums.z });
    this->Parts.push_back(part);
    this->Bounds.push_back(Box::Around(low, high));
    this->Visible.push_back(1);
    return static_cast<std::uint32_t>(this->Parts.size() - 1);
  }

  std::uint32_t AddBox(const glm::dvec3& low, const glm::dvec3& high)
  {
    return this->Add(BoxBetween(low, high));
  }

  Occluder OccluderOf(std::uint32_t i) override
  {
    const Part& part = this->Parts[i];
    ++*this->Questions;
    if (!part.Hides)
    {
      return {};
    }
    return { part.Mesh.get(), &part.ToWorld, &part.Drawn, part.HasBackFaces, part.Boxes.get(),
      part.IsOfFacesAlone };
  }

  vitrine::PartPlanes PlanesOf(std::uint32_t i) override
  {
    const Part& part = this->Parts[i];
    return { part.Planes.get(), &part.ToWorld, &part.Drawn, &part.FromWorld };
  }

  bool IsDrawnApart(std::uint32_t i) const override { return this->Parts[i].IsDrawnApart; }

  const std::vector<vitrine::MeshLine>& LinesOf(std::uint32_t i) override
  {
    return this->Parts[i].Lines;
  }

  /** Leaves in Visible what may show. */
  void Cull(PartCuller& culler, const View& view, bool occlusion = true)
  {
    this->Cull(culler, view, LooseOctree(this->Bounds), occlusion);
  }
  void Cull(PartCuller& culler, const View& view, const LooseOctree& tree, bool occlusion = true)
  {
    *this->Questions = 0;
    culler.Cull(tree, *this, view.Projection(this->Reach), occlusion, this->Visible);
  }

  struct Part
  {
    std::shared_ptr<OccluderMesh> Mesh;
    std::shared_ptr<vitrine::MeshBoxes> Boxes; ///< of meshes of many points
    std::shared_ptr<vitrine::FacePlanes> Planes;
    glm::dmat4 ToWorld, FromWorld;
    vitrine::DeviceCoordinates Drawn;
    std::vector<glm::dvec3> Corners; ///< of triangles, in the world
    std::vector<vitrine::MeshLine> Lines;
    bool Hides = true;
    bool HasBackFaces = true;
    bool IsOfFacesAlone = true;
    bool IsDrawnApart = false;
  };

  std::vector<Part> Parts;
  std::vector<Box> Bounds;
  std::vector<std::uint8_t> Visible; ///< first which are drawn, then which may show
  double Reach = 0.0;

  /** How often the last frame asked for an occluder. */
  int Asked() const { return *this->Questions; }

private:
  std::unique_ptr<std::atomic<int>> Questions = std::make_unique<std::atomic<int>>(0);
};

const int FrameColumns = 96;
const int FrameLines = 54;

/** From the origin along -z, or of all that lies 10 to either side; from 1 to 100. */
inline View AheadView(bool isParallel)
{
  View view;
  view.Columns = FrameColumns;
  view.Lines = FrameLines;
  view.IsParallel = isParallel;
  view.Eye = isParallel ? glm::dvec3(0, 0, -1) : glm::dvec3(0.0);
  view.ToClip = isParallel ? glm::ortho(-16.0, 16.0, -9.0, 9.0, 1.0, 100.0)
                           : glm::perspective(glm::radians(60.0), 16.0 / 9.0, 1.0, 100.0);
  return view;
}

/** Leaves in the scene's Visible what may show ahead, to the lines of a frame. */
inline vitrine::CullCounts CullAhead(PartScene& scene, bool isParallel)
{
  PartCuller culler(FrameColumns, FrameLines);
  scene.Cull(culler, AheadView(isParallel));
  return culler.Counts();
}

inline Triangles WallAt(double z)
{
  Triangles wall;
  wall.AddQuad({ -60, -60, z }, { 60, -60, z }, { 60, 60, z }, { -60, 60, z });
  return wall;
}

/** A heap of boxes within -10 .. 10, some turned, some open, some that hide nothing or have no back faces. */
inline PartScene HeapOf(int count, Random& random)
{
  PartScene scene;
  const double size = random.Between(0.5, 3.0);
  for (int i = 0; i < count; ++i)
  {
    glm::dvec3 half = random.Point(0.05, size);
    if (random.OneIn(6))
    {
      half[random.Below(3)] = 6.0;
    }
    Triangles box = BoxBetween(-half, half);
    if (random.OneIn(5))
    {
      box.Corners.resize(box.Corners.size() - 3 * (1 + random.Below(6)));
    }
    glm::dmat4 toWorld = glm::translate(glm::dmat4(1.0), random.Point(-10, 10));
    if (random.OneIn(2))
    {
      toWorld = glm::rotate(toWorld, random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(1.01));
    }
    if (random.OneIn(7))
    {
      toWorld = glm::scale(toWorld, glm::dvec3(-1.0, 1.0, 1.0));
    }
    const std::uint32_t part = scene.Add(box, toWorld);
    scene.Parts[part].Hides = !random.OneIn(10);
    scene.Parts[part].HasBackFaces = !random.OneIn(4);
    scene.Visible[part] = !random.OneIn(12);
  }
  return scene;
}

/** Of a heap, from without or from within. */
inline View ViewOfHeap(Random& random)
{
  View view = AheadView(random.OneIn(3));
  view.Columns = 20 + random.Below(80);
  view.Lines = 12 + random.Below(50);
  const glm::dvec3 eye = random.OneIn(3)
    ? random.Point(-9, 9)
    : random.Between(14.0, 30.0) * glm::normalize(random.Point(-1, 1) + glm::dvec3(0, 0, 0.01));
  const glm::dvec3 target = random.Point(-3, 3);
  const double nearest = random.OneIn(2) ? 0.1 : 2.0;
  view.ToClip = (view.IsParallel ? glm::ortho(-13.0, 13.0, -9.0, 9.0, nearest, 60.0)
                                 : glm::perspective(random.Between(0.5, 1.5), 1.5, nearest, 60.0)) *
    glm::lookAt(eye, target, glm::dvec3(0.1, 1.0, 0.2));
  view.Eye = view.IsParallel ? glm::normalize(target - eye) : eye;
  return view;
}

/** Looks for points of parts that nothing stands before, of the parts that are drawn. */
class SightLines
{
public:
  SightLines(const PartScene& scene, const std::vector<std::uint8_t>& drawn, const View& view)
    : Scene(scene)
    , Drawn(drawn)
    , Seen(view)
    , FromClip(glm::inverse(view.ToClip))
  {
  }

  /** Whether one of so many random points of a part is seen: in its corners, on its edges, and within its faces. */
  bool Sees(std::uint32_t part, int count, Random& random) const
  {
    const std::vector<glm::dvec3>& corners = this->Scene.Parts[part].Corners;
    for (int i = 0; i < count; ++i)
    {
      const std::size_t face = 3 * random.Below(static_cast<unsigned>(corners.size() / 3));
      if (!this->IsDrawn(part, face))
      {
        continue;
      }
      double a = random.Between(0.0, 1.0), b = random.Between(0.0, 1.0);
      a = a + b > 1.0 ? 1.0 - a : a;
      b = i % 3 == 0 ? 0.0 : std::min(b, 1.0 - a);
      a = i % 6 == 0 ? 0.0 : a;
      const unsigned first = random.Below(3);
      const glm::dvec3 &p = corners[face + first], &q = corners[face + (first + 1) % 3],
                       &r = corners[face + (first + 2) % 3];
      if (this->SeesPoint(p + a * (q - p) + b * (r - p), part))
      {
        return true;
      }
    }
    return false;
  }

  /** Whether a part is seen at one of the centres of pixels, of which a line has so many. */
  bool SeesAtCentre(std::uint32_t part, int pixelsPerLine) const
  {
    const std::vector<glm::dvec3>& corners = this->Scene.Parts[part].Corners;
    for (std::size_t face = 0; face < corners.size(); face += 3)
    {
      if (this->IsDrawn(part, face) && this->SeesFaceAtCentre(part, face, pixelsPerLine))
      {
        return true;
      }
    }
    return false;
  }

private:
  /** Faces that reach before the eye are left out. */
  bool SeesFaceAtCentre(std::uint32_t part, std::size_t face, int pixelsPerLine) const
  {
    glm::dvec4 p[3]; // in pixels
    for (int i = 0; i < 3; ++i)
    {
      p[i] = this->Seen.OnScreen(this->Scene.Parts[part].Corners[face + i]);
      if (!(p[i].w > 0.0))
      {
        return false;
      }
      p[i].x *= pixelsPerLine;
      p[i].y *= pixelsPerLine;
    }
    const auto turn = [](const glm::dvec4& a, const glm::dvec4& b, double x, double y)
    { return (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y); };
    const double area = turn(p[0], p[1], p[2].x, p[2].y);
    const int width = this->Seen.Columns * pixelsPerLine, height = this->Seen.Lines * pixelsPerLine;
    const auto first = [](double a, double b, double c) {
      return std::max(0, static_cast<int>(std::max(std::min({ a, b, c }), 0.0)));
    };
    const auto end = [](double a, double b, double c, int most) {
      return static_cast<int>(std::min(std::max({ a, b, c }) + 1.0, double(most)));
    };
    for (int j = first(p[0].y, p[1].y, p[2].y); j < end(p[0].y, p[1].y, p[2].y, height); ++j)
    {
      for (int i = first(p[0].x, p[1].x, p[2].x); i < end(p[0].x, p[1].x, p[2].x, width); ++i)
      {
        const double x = i + 0.5, y = j + 0.5;
        const double c = turn(p[0], p[1], x, y) / area, a = turn(p[1], p[2], x, y) / area;
        const double b = 1.0 - a - c;
        if (a > 0.0 && b > 0.0 && c > 0.0 &&
          this->SeesPoint(
            this->PlaceOf(x / width, y / height, a * p[0].z + b * p[1].z + c * p[2].z), part))
        {
          return true;
        }
      }
    }
    return false;
  }

  /** In the world, of shares of the screen and a reversed depth. */
  glm::dvec3 PlaceOf(double x, double y, double depth) const
  {
    const glm::dvec4 place =
      this->FromClip * glm::dvec4(2.0 * x - 1.0, 2.0 * y - 1.0, 1.0 - 2.0 * depth, 1.0);
    return glm::dvec3(place) / place.w;
  }

  bool SeesPoint(const glm::dvec3& point, std::uint32_t of) const
  {
    const glm::dvec4 clip = this->Seen.ToClip * glm::dvec4(point, 1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(std::abs(clip[axis]) < clip.w))
      {
        return false;
      }
    }
    const glm::dvec4 start =
      this->FromClip * glm::dvec4(clip.x / clip.w, clip.y / clip.w, -1.0, 1.0);
    const glm::dvec3 from = glm::dvec3(start) / start.w;
    for (std::uint32_t i = 0; i < this->Scene.Parts.size(); ++i)
    {
      if (i != of && this->Drawn[i] && this->Scene.Parts[i].Hides &&
        this->MayMeet(this->Scene.Bounds[i], from, point) && this->Blocks(i, from, point))
      {
        return false;
      }
    }
    return true;
  }

  static bool MayMeet(const Box& box, const glm::dvec3& from, const glm::dvec3& to)
  {
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = to[axis] - from[axis];
      const double a = (double{ box.Min[axis] } - from[axis]) / length;
      const double b = (double{ box.Max[axis] } - from[axis]) / length;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave + 1e-9;
  }

  bool IsDrawn(std::uint32_t part, std::size_t face) const
  {
    if (this->Scene.Parts[part].HasBackFaces)
    {
      return true;
    }
    const glm::dvec3* corners = &this->Scene.Parts[part].Corners[face];
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const glm::dvec3 sight = this->Seen.IsParallel ? this->Seen.Eye : corners[0] - this->Seen.Eye;
    return glm::dot(normal, sight) < 0.0;
  }

  bool Blocks(std::uint32_t part, const glm::dvec3& from, const glm::dvec3& to) const
  {
    const std::vector<glm::dvec3>& corners = this->Scene.Parts[part].Corners;
    const glm::dvec3 way = to - from;
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const glm::dvec3 a = corners[i + 1] - corners[i], b = corners[i + 2] - corners[i];
      const glm::dvec3 across = glm::cross(way, b);
      const double volume = glm::dot(a, across);
      const glm::dvec3 start = from - corners[i];
      const double u = glm::dot(start, across) / volume;
      const glm::dvec3 turned = glm::cross(start, a);
      const double v = glm::dot(way, turned) / volume;
      const double t = glm::dot(b, turned) / volume;
      if (u >= -1e-12 && v >= -1e-12 && u + v <= 1.0 + 1e-12 && t > 0.0 && t < 1.0 - 1e-9 &&
        this->IsDrawn(part, i))
      {
        return true;
      }
    }
    return false;
  }

  const PartScene& Scene;
  const std::vector<std::uint8_t>& Drawn;
  const View& Seen;
  glm::dmat4 FromClip;
};

}

#endif
