/** The data that an actor draws as a part, and how they look. */
#ifndef VITRINE_SECTION_PART_DATA_H
#define VITRINE_SECTION_PART_DATA_H

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <functional>
#include <vector>

class vtkActor;
class vtkPolyData;

namespace vitrine
{

/** How a part looks: colours by their coefficients, and the opacity. */
struct PartLook
{
  glm::vec4 Diffuse{ 1.0f }; ///< with the opacity
  glm::vec4 Ambient{ 0.0f };
};

/** Polygonal data that an actor draws. */
struct DrawnData
{
  vtkPolyData* Data = nullptr;
  unsigned int Block = 0; ///< flat index, 0 for data that are no blocks

  /** The block's colour and opacity, where it has its own. */
  bool HasColor = false;
  bool HasOpacity = false;
  glm::dvec3 Color{ 0.0 };
  double Opacity = 1.0;
};

/** Calls `visit` with all polygonal data that an actor draws, without hidden blocks. Updates its pipeline. */
void ForEachDrawn(vtkActor* actor, const std::function<void(const DrawnData&)>& visit);

/** Returns how the data look. Those that are coloured by scalars have the mean of their colours. */
PartLook LookOf(vtkActor* actor, const DrawnData& drawn);

/** Returns the points of data, in model coordinates. */
std::vector<glm::dvec3> PointsOfPart(vtkPolyData* data);

/** Returns the triangles of polygons and strips, three indices each, without those whose points do not exist. */
std::vector<std::uint32_t> TrianglesOfPart(vtkPolyData* data);

}

#endif
