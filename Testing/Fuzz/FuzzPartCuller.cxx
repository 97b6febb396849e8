// Culls random parts of all sizes for several frames with one culler, by cameras among the parts. A part that a line of
// sight or a pixel centre sees must not be culled.

#include "FuzzBytes.h"

#include "../Core/PartScenes.h"

#include <cstdint>
#include <vector>

namespace
{

using coverage::PartScene;
using coverage::Triangles;
using coverage::View;
using vitrine::PartCuller;
using vitrine::SampleGrid;

constexpr unsigned MostParts = 12;
constexpr unsigned MostFaces = 40;
constexpr int PointsOfAPart = 12;

glm::dvec3 PointOf(FuzzBytes& bytes)
{
  const double x = bytes.Below(256), y = bytes.Below(256), z = bytes.Below(256);
  return (glm::dvec3(x, y, z) - 128.0) / 32.0;
}

Triangles SoupOf(FuzzBytes& bytes)
{
  Triangles soup;
  for (unsigned faces = 1 + bytes.Below(MostFaces); faces > 0; --faces)
  {
    const glm::dvec3 a = PointOf(bytes), b = PointOf(bytes);
    soup.Add(a, b, PointOf(bytes));
  }
  return soup;
}

Triangles BoxOf(FuzzBytes& bytes)
{
  const glm::dvec3 a = PointOf(bytes), b = PointOf(bytes);
  return coverage::BoxBetween(glm::min(a, b), glm::max(a, b) + 0.01);
}

PartScene SceneOf(FuzzBytes& bytes)
{
  PartScene scene;
  for (unsigned parts = 1 + bytes.Below(MostParts); parts > 0; --parts)
  {
    const Triangles mesh = bytes.Below(3) == 0 ? BoxOf(bytes) : SoupOf(bytes);
    const glm::dvec3 place = 2.0 * PointOf(bytes);
    const std::uint32_t part = scene.Add(mesh, glm::translate(glm::dmat4(1.0), place));
    scene.Parts[part].Hides = bytes.Below(8) != 0;
    scene.Parts[part].HasBackFaces = bytes.Below(4) != 0;
  }
  return scene;
}

View ViewOf(FuzzBytes& bytes, int columns, int lines)
{
  View view = coverage::AheadView(bytes.Below(3) == 0);
  view.Columns = columns;
  view.Lines = lines;
  const glm::dvec3 eye = (bytes.Below(2) == 0 ? 1.0 : 4.0) * PointOf(bytes);
  const glm::dvec3 target = PointOf(bytes) + glm::dvec3(0.003, 0.002, 0.001);
  const double nearest = bytes.Below(2) == 0 ? 0.1 : 2.0;
  view.ToClip = (view.IsParallel ? glm::ortho(-7.0, 7.0, -5.0, 5.0, nearest, 60.0)
                                 : glm::perspective(1.2, 1.4, nearest, 60.0)) *
    glm::lookAt(eye, target, glm::dvec3(0.1, 1.0, 0.2));
  view.Eye = view.IsParallel ? glm::normalize(target - eye) : eye;
  return view;
}

void CullFrame(PartScene& scene, PartCuller& culler, const View& view, unsigned pixels)
{
  const std::vector<std::uint8_t> drawn(scene.Parts.size(), 1);
  scene.Visible = drawn;
  scene.Cull(culler, view);
  std::vector<vitrine::BoxedPart> hidden;
  for (std::uint32_t part = 0; part < scene.Parts.size(); ++part)
  {
    if (!scene.Visible[part])
    {
      hidden.push_back({ part, scene.Bounds[part] });
    }
  }
  culler.VerifyHidden(hidden, scene, view.Projection(scene.Reach)); // for what sanitizers find
  const coverage::SightLines sight(scene, drawn, view);
  coverage::Random random(5);
  for (const vitrine::BoxedPart& part : hidden)
  {
    const bool isSeen = pixels == 0 ? sight.Sees(part.Part, PointsOfAPart, random)
                                    : sight.SeesAtCentre(part.Part, static_cast<int>(pixels));
    Require(!isSeen, "a part that is hidden is seen");
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const int columns = 8 + static_cast<int>(bytes.Below(60));
  const int lines = 8 + static_cast<int>(bytes.Below(40));
  const unsigned pixels = bytes.Below(5);
  PartScene scene = SceneOf(bytes);
  PartCuller culler(columns, lines,
    pixels == 0 ? SampleGrid() : SampleGrid::AtCentres(static_cast<int>(pixels)),
    1 + static_cast<int>(bytes.Below(2)));
  for (int frame = 0; frame < 4 && (frame == 0 || bytes.AreLeft()); ++frame)
  {
    CullFrame(scene, culler, ViewOf(bytes, columns, lines), pixels);
  }
  return 0;
}
