/**
 * A device that computes in floats, as llvmpipe does.
 *
 * It cuts faces at the planes of the view, one after the other and from the nearer end of an edge. It snaps corners to
 * a grid of 1/256 pixel to find the covered pixel centres. Depths come from planes through the corners before snapping,
 * relative to the first column and line.
 */
#ifndef VITRINE_TESTING_FLOAT_DEVICE_H
#define VITRINE_TESTING_FLOAT_DEVICE_H

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coverage
{

class FloatDevice
{
public:
  FloatDevice(const glm::dmat4& toClip, const glm::dvec2& size)
    : ToClip(toClip)
    , Size(size)
  {
  }

  /** Column, line and reversed depth of what it draws of a face, at up to some hundred samples. */
  std::vector<glm::dvec3> Draw(const std::vector<glm::dvec3>& face) const
  {
    std::vector<glm::vec3> corners;
    for (const glm::vec4& corner : this->Cut(face))
    {
      const float inverse = 1.0f / corner.w;
      const glm::vec2 half = 0.5f * this->Size;
      corners.emplace_back(corner.x * inverse * half.x + half.x,
        corner.y * inverse * half.y + half.y, corner.z * inverse * 0.5f + 0.5f);
    }
    std::vector<glm::dvec3> drawn;
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->DrawTriangle({ corners[i - 1], corners[i], corners[0] }, drawn);
    }
    return drawn;
  }

private:
  using Polygon = std::vector<glm::vec4>;

  Polygon Cut(const std::vector<glm::dvec3>& face) const
  {
    const glm::mat4& m = this->ToClip;
    Polygon polygon;
    for (const glm::dvec3& corner : face)
    {
      const glm::vec3 point(corner);
      polygon.push_back(m[0] * point.x + m[1] * point.y + m[2] * point.z + m[3]);
    }
    for (const glm::vec4& plane :
      { glm::vec4(-1, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, -1, 0, 1),
        glm::vec4(0, 1, 0, 1), glm::vec4(0, 0, 1, 1), glm::vec4(0, 0, -1, 1) })
    {
      polygon = CutAt(polygon, plane);
    }
    return polygon;
  }

  static Polygon CutAt(const Polygon& polygon, const glm::vec4& plane)
  {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const glm::vec4 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
      const float start = DistanceOf(from, plane), end = DistanceOf(to, plane);
      if (start >= 0.0f)
      {
        left.push_back(from);
      }
      if ((start < 0.0f) != (end < 0.0f))
      {
        const bool isStartNearer = std::abs(start) <= std::abs(end);
        left.push_back(isStartNearer ? from + (start / (start - end)) * (to - from)
                                     : to + (end / (end - start)) * (from - to));
      }
    }
    return left;
  }

  static float DistanceOf(const glm::vec4& point, const glm::vec4& plane)
  {
    return plane.x * point.x + plane.y * point.y + plane.z * point.z + plane.w * point.w;
  }

  struct Triangle
  {
    glm::vec3 A, B, C;
  };

  /** What a plane of depth has in floats. */
  struct DevicePlane
  {
    float First, ByColumn, ByLine;

    explicit DevicePlane(const Triangle& t)
    {
      const glm::vec3 ab = t.A - t.B, ca = t.C - t.A;
      const float inverse = 1.0f / (ab.x * ca.y - ca.x * ab.y);
      this->ByColumn = ab.z * (ca.y * inverse) - ca.z * (ab.y * inverse);
      this->ByLine = ca.z * (ab.x * inverse) - ab.z * (ca.x * inverse);
      this->First = t.A.z - (this->ByColumn * (t.A.x - 0.5f) + this->ByLine * (t.A.y - 0.5f));
    }

    float At(int column, int line) const
    {
      return this->First + static_cast<float>(column) * this->ByColumn +
        static_cast<float>(line) * this->ByLine;
    }
  };

  static glm::dvec2 Snapped(const glm::vec3& corner)
  {
    return (glm::dvec2(std::floor((corner.x - 0.5f) * 256.0f + 0.5f),
             std::floor((corner.y - 0.5f) * 256.0f + 0.5f))) /
      256.0;
  }

  void DrawTriangle(const Triangle& t, std::vector<glm::dvec3>& drawn) const
  {
    const glm::dvec2 snapped[3] = { Snapped(t.A), Snapped(t.B), Snapped(t.C) };
    const DevicePlane plane(t);
    const glm::dvec2 low = glm::min(snapped[0], glm::min(snapped[1], snapped[2]));
    const glm::dvec2 high = glm::max(snapped[0], glm::max(snapped[1], snapped[2]));
    const int first = static_cast<int>(std::ceil(std::max(low.y, 0.0)));
    const int last = static_cast<int>(std::floor(std::min(high.y, double{ this->Size.y } - 1.0)));
    const int step = std::max((last - first) / 16, 1);
    for (int line = first; line <= last; line += step)
    {
      double left = double{ this->Size.x } - 1.0, right = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const glm::dvec2 &a = snapped[i], &b = snapped[(i + 1) % 3];
        if (a.y != b.y && std::min(a.y, b.y) <= line && line <= std::max(a.y, b.y))
        {
          const double column = a.x + (b.x - a.x) * (line - a.y) / (b.y - a.y);
          left = std::min(left, column);
          right = std::max(right, column);
        }
      }
      for (int column : { static_cast<int>(std::ceil(left)), static_cast<int>(std::floor(right)) })
      {
        const float depth = plane.At(column, line);
        if (left < column && column < right && std::isfinite(depth))
        {
          drawn.emplace_back(column + 0.5, line + 0.5, 1.0 - std::clamp(double{ depth }, 0.0, 1.0));
        }
      }
    }
  }

  glm::mat4 ToClip;
  glm::vec2 Size;
};

}

#endif
