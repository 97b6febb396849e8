#include "Core/culling/steady/FacePlanes.h"

#include "Core/culling/screen/DeviceModel.h"
#include "Core/geometry/BeyondAll.h"
#include "Core/geometry/Finite.h"
#include "Core/geometry/Lanes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// The planes of consecutive faces are one if they differ by less than this share of all distances. So a polygon that
// was cut into faces has one plane.
const double SamePlane = 1e-6;

// The number of planes that are tested before the faces of thin ones are listed.
const std::size_t PlanesAtOnce = 64 * LaneCount;

/**
 * Returns how a face is aligned with the axes, exactly. Bits 0 to 2 tell along which axes an edge lies. Bits 3 to 5
 * tell on which axes all corners have one coordinate.
 */
std::uint8_t AlignmentOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  unsigned bits = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const auto isAlong = [&](const glm::dvec3& from, const glm::dvec3& to)
    { return from[next] == to[next] && from[last] == to[last]; };
    bits |= unsigned{ isAlong(a, b) || isAlong(b, c) || isAlong(c, a) } << axis;
    bits |= unsigned{ a[axis] == b[axis] && b[axis] == c[axis] } << (3 + axis);
  }
  return static_cast<std::uint8_t>(bits);
}

/** Returns the axis that a direction lies along exactly, or -1. */
int AxisOf(const glm::dvec4& direction)
{
  int axis = -1;
  for (int i = 0; i < 4; ++i)
  {
    if (direction[i] != 0.0)
    {
      axis = axis < 0 && i < 3 ? i : 3;
    }
  }
  return axis < 3 ? axis : -1;
}

/**
 * Returns the alignments with which a face has no area in a view: some of its corners coincide, or all lie on one
 * column or line. That holds for a device as for us, since the matrix has zeros there.
 */
unsigned VanishingIn(const PlaneView& view)
{
  const int ahead = AxisOf(view.Eye), across = AxisOf(view.ByColumn), up = AxisOf(view.ByLine);
  if (ahead < 0)
  {
    return 0;
  }
  return 1u << ahead | (across < 0 || up < 0 ? 0u : 8u << across | 8u << up);
}

/** Returns true if an OccluderMesh keeps such a face. */
bool IsFaceOfMesh(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  return IsFinite(a) && IsFinite(b) && IsFinite(c) && a != b && b != c && c != a;
}
}

/**
 * The plane of a face or of several consecutive ones. The plane of a face without area is not known: the face may have
 * area where a device rounds its corners.
 */
struct FacePlanes::Plane
{
  glm::dvec3 Normal{ 0.0 };
  glm::dvec3 Place{ 0.0 };
  std::uint32_t FirstFace = 0;
  std::uint8_t Alignment = 0; ///< common alignment of all of its faces
  double Extent = 0.0;        ///< width across the narrowest face; 0 if the plane is not known
  /**
   * Bound of the error in the distances of the other faces from an eye, as a share of the distance from the eye to the
   * farthest point.
   */
  double Deviation = 0.0;

  /** Takes another face into this plane if it lies there. Returns true then. */
  bool Takes(const Plane& other, double radius)
  {
    const double turned = glm::length(other.Normal - this->Normal);
    const double moved = std::abs(glm::dot(this->Normal, other.Place - this->Place));
    const double deviation = turned + moved / radius;
    if (this->Extent == 0.0 || other.Extent == 0.0 || !(deviation < SamePlane))
    {
      return false;
    }
    this->Alignment &= other.Alignment;
    this->Extent = std::min(this->Extent, other.Extent);
    this->Deviation = std::max(this->Deviation, deviation);
    return true;
  }
};

FacePlanes::Plane FacePlanes::PlaneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  const glm::dvec3 cross = glm::cross(b - a, c - a);
  const double size = glm::length(cross);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return {};
  }
  const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
  return { cross / size, a, 0, AlignmentOf(a, b, c), size / longest, 0.0 };
}

FacePlanes::FacePlanes(
  const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& corners)
{
  glm::dvec3 least(1e300), greatest(-1e300);
  for (const std::uint32_t corner : corners)
  {
    const glm::dvec3& point = points[corner];
    least = IsFinite(point) ? glm::min(least, point) : least;
    greatest = IsFinite(point) ? glm::max(greatest, point) : greatest;
  }
  this->Middle = 0.5 * least + 0.5 * greatest;
  this->Radius = glm::length(greatest - this->Middle);
  std::vector<Plane> planes;
  std::uint32_t faces = 0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    const glm::dvec3 &a = points[corners[i]], &b = points[corners[i + 1]],
                     &c = points[corners[i + 2]];
    if (IsFaceOfMesh(a, b, c))
    {
      Plane plane = PlaneOf(a, b, c);
      plane.FirstFace = faces++;
      if (planes.empty() || !planes.back().Takes(plane, this->Radius))
      {
        planes.push_back(plane);
      }
    }
  }
  this->Keep(planes, faces);
}

void FacePlanes::Keep(const std::vector<Plane>& planes, std::uint32_t faces)
{
  for (const Plane& plane : planes)
  {
    const double distance = glm::dot(plane.Normal, plane.Place - this->Middle);
    const double values[] = { plane.Normal.x, plane.Normal.y, plane.Normal.z, distance,
      plane.Extent, plane.Deviation };
    for (int i = 0; i < 6; ++i)
    {
      this->Planes[i].push_back(static_cast<float>(values[i]));
    }
    this->FirstFaces.push_back(plane.FirstFace);
    this->Alignments.push_back(plane.Alignment);
  }
  this->FirstFaces.push_back(faces);
  this->Pad();
}

/** Pads the arrays to a multiple of eight. */
void FacePlanes::Pad()
{
  while (this->Planes[0].size() % LaneCount != 0)
  {
    for (std::vector<float>& values : this->Planes)
    {
      values.push_back(values.back());
    }
  }
}

VITRINE_FOR_EACH_PROCESSOR
glm::dvec2 FacePlanes::FindThin(
  const PlaneView& view, const Thickness& thickness, std::vector<std::uint32_t>& thin) const
{
  if (this->Planes[0].empty())
  {
    return glm::dvec2(0.0);
  }
  const glm::dvec3 place = glm::dvec3(view.Eye) - view.Eye.w * this->Middle;
  const double farthest = glm::length(place) + view.Eye.w * this->Radius;
  const double least = (thickness.Fixed * farthest + thickness.ByNear) * farthest;
  const Lanes most = AllLanes(static_cast<float>(least * thickness.Unevenness));
  const Lanes rounded = AllLanes(static_cast<float>(RoundingOfDistances * farthest));
  const unsigned vanishing = VanishingIn(view);
  const auto toFarthest = static_cast<float>(farthest);
  const glm::vec4 from(place, -view.Eye.w);
  Lanes nearestOfOthers = AllLanes(BeyondAll);
  const float *const normalX = this->Planes[0].data(), *const normalY = this->Planes[1].data(),
                     *const normalZ = this->Planes[2].data(),
                     *const middle = this->Planes[3].data(), *const extent = this->Planes[4].data(),
                     *const deviation = this->Planes[5].data();
  const std::size_t planes = this->Alignments.size();
  for (std::size_t first = 0; first < planes; first += PlanesAtOnce)
  {
    const std::size_t end = std::min(first + PlanesAtOnce, planes);
    std::uint8_t areThin[PlanesAtOnce / LaneCount];
    for (std::size_t i = first; i < end; i += LaneCount)
    {
      const Lanes distance =
        SizeOf(from.x * LoadLanes(normalX + i) + from.y * LoadLanes(normalY + i) +
          from.z * LoadLanes(normalZ + i) + from.w * LoadLanes(middle + i));
      const Lanes surely = distance - LoadLanes(deviation + i) * toFarthest - rounded;
      const LaneMask isThick = surely * LoadLanes(extent + i) > most;
      nearestOfOthers = LeastOf(Chosen(isThick, surely, AllLanes(BeyondAll)), nearestOfOthers);
      areThin[(i - first) / LaneCount] =
        static_cast<std::uint8_t>(BitsOf(~isThick)); // also if it is no number
    }
    this->AddFaces(first, end, areThin, vanishing, thin);
  }
  return glm::dvec2(this->FarthestFrom(view.ByColumn), this->FarthestFrom(view.ByLine)) /
    static_cast<double>(LeastLane(nearestOfOthers));
}

/** Returns the greatest distance of a place, or of a direction, from any of the planes. */
double FacePlanes::FarthestFrom(const glm::dvec4& place) const
{
  return glm::length(glm::dvec3(place) - place.w * this->Middle) + std::abs(place.w) * this->Radius;
}

/**
 * Adds the faces of some planes from `first` up to before `end`.
 * @param planes     a bit for each plane whose faces are added
 * @param vanishing  planes with any of these alignments are left out
 */
void FacePlanes::AddFaces(std::size_t first, std::size_t end, const std::uint8_t* planes,
  unsigned vanishing, std::vector<std::uint32_t>& to) const
{
  const std::uint8_t* const endOfPlanes = planes + (end - first + LaneCount - 1) / LaneCount;
  if (std::all_of(planes, endOfPlanes, [](std::uint8_t bits) { return bits == 0; }))
  {
    return;
  }
  const std::size_t before = to.size();
  to.resize(before + this->FirstFaces[end] - this->FirstFaces[first]);
  std::uint32_t* next = to.data() + before;
  for (std::size_t i = first; i < end; i += LaneCount)
  {
    const auto left = static_cast<int>(std::min<std::size_t>(end - i, LaneCount));
    unsigned bits = planes[(i - first) / LaneCount] & ((1u << left) - 1u);
    for (; bits != 0; bits &= bits - 1)
    {
      const std::size_t plane = i + static_cast<std::size_t>(LowestBit(bits));
      const bool isVanishing = (this->Alignments[plane] & vanishing) != 0;
      const std::uint32_t endOfFaces = isVanishing ? 0 : this->FirstFaces[plane + 1];
      for (std::uint32_t face = this->FirstFaces[plane]; face < endOfFaces; ++face)
      {
        *next++ = face;
      }
    }
  }
  to.resize(static_cast<std::size_t>(next - to.data()));
}

}
