#include "Core/culling/hidden/BoxesHidden.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine
{

namespace
{

/** The boxes of a mesh in one view. */
class BoxesInView
{
public:
  BoxesInView(const MeshBoxes& boxes, const SBuffer& lines, const ScreenProjection& view,
    const glm::dmat4& toWorld)
    : Nodes(boxes.Nodes())
    , Lines(lines)
    , View(view)
    , ToScreen(glm::translate(view.Of(toWorld).Matrix, boxes.Origin()))
  {
  }

  bool AreHidden(const MeshBoxes::Node& node) const
  {
    RectangleLanes rectangles;
    this->View.Project(this->ToScreen, node.Boxes, rectangles);
    for (int lane = 0; lane < node.Count; ++lane)
    {
      const bool isOutside = (rectangles.Outside >> lane & 1u) != 0;
      const bool isNear = (rectangles.Near >> lane & 1u) != 0;
      if (isOutside || (!isNear && this->Lines.Hides(rectangles.At(lane))))
      {
        continue;
      }
      if (node.Nodes[lane] == MeshBoxes::NoNode || !this->AreHidden(this->Nodes[node.Nodes[lane]]))
      {
        return false;
      }
    }
    return true;
  }

private:
  const std::vector<MeshBoxes::Node>& Nodes;
  const SBuffer& Lines;
  const ScreenProjection& View;
  glm::mat4 ToScreen;
};
}

bool AreBoxesHidden(const MeshBoxes& boxes, const SBuffer& lines, const ScreenProjection& view,
  const glm::dmat4& toWorld)
{
  return !boxes.Nodes().empty() &&
    BoxesInView(boxes, lines, view, toWorld).AreHidden(boxes.Nodes().front());
}

}
