// Puts random meshes into an s-buffer, face by face or, if they have few facets, all at once. The matrices may hold
// anything. The exact spans of all faces are the judge.

#include "FuzzBytes.h"

#include "../Core/DeviceFaces.h"
#include "../Core/FewFacetsScenes.h"

#include "Core/culling/cover/FaceCoverage.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace vitrine;
using coverage::ScreenFace;
using Facing = MeshProjection::Facing;

constexpr unsigned MostPoints = 20;
constexpr unsigned MostFaces = 24;

glm::dvec3 PointOf(FuzzBytes& bytes)
{
  const double x = bytes.Number();
  const double y = bytes.Number();
  return { x, y, bytes.Number() };
}

OccluderMesh BoxOf(FuzzBytes& bytes)
{
  const glm::dvec3 corner = PointOf(bytes), a = PointOf(bytes), b = PointOf(bytes);
  return coverage::BoxOf(corner, a, b, PointOf(bytes)).Mesh();
}

OccluderMesh TetrahedronOf(FuzzBytes& bytes)
{
  const glm::dvec3 a = PointOf(bytes), b = PointOf(bytes), c = PointOf(bytes);
  return coverage::TetrahedronOf(a, b, c, PointOf(bytes)).Mesh();
}

OccluderMesh SoupOf(FuzzBytes& bytes)
{
  std::vector<glm::dvec3> points(3 + bytes.Below(MostPoints));
  for (glm::dvec3& point : points)
  {
    point = PointOf(bytes);
  }
  std::vector<std::uint32_t> corners(3 * (1 + bytes.Below(MostFaces)));
  for (std::uint32_t& corner : corners)
  {
    corner = bytes.Below(static_cast<unsigned>(points.size()));
  }
  return OccluderMesh(points, corners);
}

OccluderMesh MeshOf(FuzzBytes& bytes)
{
  const unsigned kind = bytes.Below(4);
  return kind == 0 ? BoxOf(bytes) : kind == 1 ? TetrahedronOf(bytes) : SoupOf(bytes);
}

/** The largest absolute coordinate. */
double ReachOf(const OccluderMesh& mesh)
{
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const float coordinate : mesh.Coordinates(axis))
    {
      reach = std::max(reach, std::abs(mesh.Origin()[axis] + double{ coordinate }));
    }
  }
  return reach;
}

ScreenMatrix MatrixOf(FuzzBytes& bytes, int columns, int lines, double reach)
{
  const double aspect = double(columns) / lines;
  const glm::dmat4 lens = bytes.Below(2) == 0
    ? glm::ortho(-2.0 * aspect, 2.0 * aspect, -2.0, 2.0, 0.5, 20.0)
    : glm::perspective(0.5 + bytes.Below(16) / 8.0, aspect, 0.5, 20.0);
  glm::dmat4 toClip = lens *
    glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -1.0 - bytes.Below(8))),
      bytes.Below(64) / 10.0, glm::dvec3(0.3, 1.0, 0.1));
  const float most = bytes.Below(4) == 0 ? bytes.Below(64) / 100.0f : 0.0f;
  for (unsigned damages = bytes.Below(16) == 0 ? bytes.Below(4) : 0; damages > 0; --damages)
  {
    const unsigned at = bytes.Below(16);
    toClip[at / 4][at % 4] = bytes.Number();
  }
  return ScreenProjection(toClip, columns, lines, glm::dvec3(reach), { most, most, 0.1f * most })
    .Of(glm::dmat4(1.0));
}

/**
 * Adds the faces that a device may draw. Each point is moved by up to the margin, or cut at the near plane after
 * rounding.
 */
void AddDrawn(const MeshProjection& projection, const ScreenMatrix& matrix, Facing facing,
  std::mt19937& random, std::vector<ScreenFace>& faces)
{
  if (!projection.IsBehindNear())
  {
    const std::vector<ScreenFace> drawn =
      coverage::DeviceFaces(projection.Mesh(), matrix, true, random).Facing(facing);
    faces.insert(faces.end(), drawn.begin(), drawn.end());
    return;
  }
  const ScreenMargin& margin = projection.Margin();
  const auto moved = [&random](double place, double most)
  { return place + (random() % 2 == 0 ? most : -most); };
  std::vector<glm::dvec3> places;
  for (std::uint32_t i = 0; i < projection.Mesh().PointCount(); ++i)
  {
    const ScreenPoint onScreen = projection.Point(i);
    const double column = moved(onScreen.Column, margin.Column);
    const double line = moved(onScreen.Line, margin.Line);
    places.emplace_back(column, line, moved(onScreen.Depth, margin.Depth));
  }
  for (const OccluderMesh::Face& face : projection.Mesh().Faces())
  {
    const ScreenFace onScreen{ places[face[0]], places[face[1]], places[face[2]] };
    const double turn = coverage::TurnOf(onScreen);
    if (facing == Facing::Front ? turn > 0.0 : turn < 0.0)
    {
      faces.push_back(onScreen);
    }
  }
}

SBuffer BufferOf(FuzzBytes& bytes, int columns, int lines, unsigned pixels)
{
  const SampleGrid grid =
    pixels == 0 ? SampleGrid() : SampleGrid::AtCentres(static_cast<int>(pixels));
  const unsigned kind = bytes.Below(9);
  return kind == 8 ? SBuffer::WithFewSamples(columns, lines, grid)
                   : SBuffer(columns, lines, grid, 1 + kind * 300);
}

/** Inserts a side of a mesh that is projected by one of the ways there are for it. */
void Insert(SBuffer& buffer, MeshProjection& projection, Facing facing, std::uint32_t part)
{
  const FewFacets* const few = projection.Mesh().Few();
  if (few != nullptr && buffer.BySample() && projection.IsBehindNear())
  {
    FewFacetsCoverage::Insert(buffer, *few, projection, facing, part);
  }
  else
  {
    FaceCoverage().Insert(buffer, projection, facing, part);
  }
}

/** Whether each sample in what is said to be hidden is covered by what is nearer. */
void RequireSamples(
  const std::vector<Span>& spans, const SampleGrid& grid, float left, float right, float nearest)
{
  std::size_t covered = 0, count = 0;
  for (float place = left; place <= right; place += grid.Width())
  {
    ++count;
  }
  for (const Span& span : spans)
  {
    covered += span.Left >= left && span.Left <= right && span.Depth > nearest;
  }
  Require(covered == count, "what is hidden has a sample that is not covered");
}

/** Whether spans leave out no sample in what is said to be hidden, and are nearer at all of them. */
void AskWhatIsHidden(SBuffer& buffer, FuzzBytes& bytes)
{
  const float start = bytes.Below(256) * buffer.Columns() / 256.0f;
  const float base = bytes.Below(256) * buffer.Lines() / 256.0f;
  const ScreenRectangle rectangle{ start, start + bytes.Below(256) / 32.0f, base,
    base + bytes.Below(256) / 64.0f, bytes.Below(256) / 256.0f };
  if (!buffer.Hides(rectangle))
  {
    return;
  }
  const SampleGrid& grid = buffer.Samples();
  const float left = grid.From(start), bottom = grid.From(base);
  const float right = grid.UpTo(std::min(rectangle.Right, static_cast<float>(buffer.Columns())));
  const float top = grid.UpTo(std::min(rectangle.Top, static_cast<float>(buffer.Lines())));
  const int last = std::min(static_cast<int>(top), buffer.Lines() - 1);
  for (int line = static_cast<int>(bottom); left <= right && bottom <= top && line <= last; ++line)
  {
    const std::vector<Span> spans = buffer.SpansOf(line);
    if (buffer.BySample())
    {
      RequireSamples(spans, grid, left, right, rectangle.Nearest);
      continue;
    }
    float next = left; // between samples nothing shows
    bool isCovered = false;
    for (const Span& span : spans)
    {
      if (span.Right >= next && span.Left <= next && !isCovered)
      {
        const float end = std::min(right, grid.UpTo(span.Right));
        Require(span.DepthAt(next) > rectangle.Nearest && span.DepthAt(end) > rectangle.Nearest,
          "what is hidden is nearer than what hides it");
        isCovered = end >= right;
        next = grid.Behind(end);
      }
    }
    Require(isCovered, "what is hidden is not covered");
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const int columns = 1 + static_cast<int>(bytes.Below(40));
  const int lines = 1 + static_cast<int>(bytes.Below(24));
  std::mt19937 random(bytes.Byte());
  const unsigned pixels = bytes.Below(5);
  SBuffer buffer = BufferOf(bytes, columns, lines, pixels);
  MeshProjection projection;
  std::vector<ScreenFace> faces;
  for (int i = 0; i < 4 && bytes.AreLeft(); ++i)
  {
    const OccluderMesh mesh = MeshOf(bytes);
    const ScreenMatrix matrix = MatrixOf(bytes, columns, lines, ReachOf(mesh));
    projection.Project(mesh, matrix);
    if (!projection.IsBehindNear() && bytes.Below(2) == 1)
    {
      projection.ClipFarther(matrix);
    }
    projection.FindFacings();
    for (const Facing facing : { Facing::Front, Facing::Back })
    {
      Insert(buffer, projection, facing, static_cast<std::uint32_t>(i));
      AddDrawn(projection, matrix, facing, random, faces);
    }
  }
  const std::string wrong =
    coverage::CoverageJudge(faces, pixels == 0 ? 0.0 : 0.5 / pixels).WhatIsWrong(buffer, random, 3);
  Require(wrong.empty(), wrong.c_str());
  AskWhatIsHidden(buffer, bytes);
  return 0;
}
