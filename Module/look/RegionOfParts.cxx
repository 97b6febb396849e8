#include "look/RegionOfParts.h"

#include "scene/ActorRules.h"
#include "scene/Matrices.h"
#include "scene/PartNumbers.h"
#include "scene/ViewMatrices.h"

#include "vtkActor.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

/** The rectangle around points in the window, from -1 to 1 in both directions. */
struct Spread
{
  glm::dvec2 Least{ std::numeric_limits<double>::infinity() };
  glm::dvec2 Most{ -std::numeric_limits<double>::infinity() };
  bool IsAnywhere = false;

  void Add(const double* bounds, const glm::dmat4& toClip)
  {
    for (int i = 0; vtkMath::AreBoundsInitialized(bounds) && i < 8; ++i)
    {
      const glm::dvec4 clip =
        toClip * glm::dvec4(bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)], 1.0);
      this->IsAnywhere = this->IsAnywhere || !(clip.w > 0.0);
      const glm::dvec2 place = glm::dvec2(clip) / clip.w;
      this->Least = glm::min(this->Least, place);
      this->Most = glm::max(this->Most, place);
    }
  }
};

/** Adds the boxes of the chosen leaves of composite data. */
void AddLeaves(vtkDataObject* data, const std::vector<std::uint32_t>& chosen, std::size_t& index,
  const glm::dmat4& toClip, Spread& spread)
{
  const std::size_t own = index++;
  if (auto* const tree = vtkDataObjectTree::SafeDownCast(data))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      AddLeaves(child, chosen, index, toClip, spread);
    }
  }
  else if (auto* const set = vtkDataSet::SafeDownCast(data))
  {
    if (own < chosen.size() && chosen[own] != 0)
    {
      spread.Add(set->GetBounds(), toClip);
    }
  }
}

/** Returns the pixel of a place from -1 to 1. It is within the first and the last. */
int PixelAt(double place, int first, int count, double away)
{
  const double pixel = std::floor(first + 0.5 * (place + 1.0) * count + away);
  return static_cast<int>(std::clamp<double>(pixel, first, first + count));
}
}

PixelRegion RegionOfParts(vtkRenderer* renderer, const PixelRegion& viewport,
  const ChosenParts& chosen, const std::vector<vtkProp*>& props, int margin)
{
  const ViewMatrices view = ViewMatricesOf(renderer);
  const glm::dmat4 worldToClip = MatrixOf(view.data() + 16) * MatrixOf(view.data());
  Spread spread;
  double width = 0.0; // of lines and points
  for (vtkProp* prop : props)
  {
    vtkActor* const actor = AsHideable(prop);
    if (!actor)
    {
      return viewport;
    }
    width = std::max<double>(
      { width, actor->GetProperty()->GetLineWidth(), actor->GetProperty()->GetPointSize() });
    if (vtkDataObject* const blocks = BlocksOf(actor))
    {
      std::size_t index = 0;
      AddLeaves(
        blocks, chosen.NumbersOf(actor), index, worldToClip * MatrixOf(actor->GetMatrix()), spread);
    }
    else if (const double* const bounds = actor->GetBounds())
    {
      spread.Add(bounds, worldToClip);
    }
  }
  if (spread.IsAnywhere)
  {
    return viewport;
  }
  const double away = margin + width;
  PixelRegion region;
  region.X = PixelAt(spread.Least.x, viewport.X, viewport.Width, -away);
  region.Y = PixelAt(spread.Least.y, viewport.Y, viewport.Height, -away);
  region.Width = PixelAt(spread.Most.x, viewport.X, viewport.Width, away + 1.0) - region.X;
  region.Height = PixelAt(spread.Most.y, viewport.Y, viewport.Height, away + 1.0) - region.Y;
  return region;
}

}
