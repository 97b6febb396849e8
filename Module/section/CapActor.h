/** The cap of a plane: an actor that shows the parts that the plane cuts. */
#ifndef VITRINE_SECTION_CAP_ACTOR_H
#define VITRINE_SECTION_CAP_ACTOR_H

#include "Core/section/CutPlane.h"

#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <functional>

namespace vitrine
{

/**
 * A plane has two caps, for opaque and for translucent parts. Their shaders (SectionShader) look up which part is cut
 * at a pixel. The caps are lit and drawn as other actors are, so any transparency method draws them in order.
 */
class CapActor : public vtkOpenGLActor
{
public:
  static CapActor* New();
  vtkTypeMacro(CapActor, vtkOpenGLActor);

  /** The number of the plane. */
  int Plane = 0;
  bool IsForTranslucent = false;

  /** Called around each draw. If `Begin` returns false, nothing is drawn. */
  std::function<bool(vtkRenderer*)> Begin;
  std::function<void()> End;
  std::function<void(vtkWindow*)> Release;

  /** Show the part of the plane within a box in WC, and set the side of the caps. It is hidden if there is none. */
  void Place(const CutPlane& plane, const glm::dvec3& min, const glm::dvec3& max);

  void SetForTranslucent(bool isForTranslucent);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  CapActor();

private:
  vtkNew<vtkPolyData> Polygon;
  vtkNew<vtkPolyDataMapper> Drawing;
  CutPlane Placed{ glm::dvec3(0.0), 0.0 };
  glm::dvec3 PlacedMin{ 0.0 };
  glm::dvec3 PlacedMax{ 0.0 };
};

}

#endif
