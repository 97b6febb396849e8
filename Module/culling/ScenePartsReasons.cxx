// Explains why a prop was drawn or left out. Nothing here is called while a frame is drawn.
#include "culling/SceneParts.h"

#include "culling/CullingPolicy.h"
#include "culling/PropPolicy.h"
#include "culling/RendererView.h"

#include "vtkActor.h"
#include "vtkProp.h"

#include <algorithm>

namespace vitrine
{

std::string SceneParts::Explain(vtkProp* prop, const Fate& fate) const
{
  const auto found = this->Index.find(prop);
  // The prop may be a new one at the address of one that was deleted since.
  if (found == this->Index.end() || this->SeenIn[found->second] != this->Frame ||
    this->Living[found->second] != prop)
  {
    return "not drawn: it is not among the visible props of the last frame";
  }
  const std::uint32_t whole = found->second;
  const std::vector<std::uint32_t> parts =
    this->HasPieces[whole] ? this->Parts[whole].Pieces : std::vector<std::uint32_t>{ whole };
  std::vector<std::uint32_t> shown;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(shown),
    [&](std::uint32_t part) { return fate.Visible[part] != IsLeftOut; });
  if (shown.empty())
  {
    const bool isOutside = std::all_of(parts.begin(), parts.end(),
      [&](std::uint32_t part) { return this->IsOutside(part, fate.View); });
    return isOutside ? "left out: outside of the view" : "left out: hidden by others";
  }
  const std::uint32_t first = *std::min_element(shown.begin(), shown.end(),
    [&](std::uint32_t a, std::uint32_t b) { return fate.Visible[a] < fate.Visible[b]; });
  const std::string reason = this->ExplainShown(prop, first, fate);
  const std::size_t leftOut = parts.size() - shown.size();
  return leftOut == 0 ? reason
                      : reason + "; " + std::to_string(leftOut) + " of its " +
      std::to_string(parts.size()) + " parts are left out";
}

/** Explains why a part is drawn. */
std::string SceneParts::ExplainShown(vtkProp* prop, std::uint32_t part, const Fate& fate) const
{
  const Part& known = this->Parts[part];
  const std::uint8_t showing = fate.Visible[part];
  const PropRow* const viewAlone = showing == MayBeElsewhere
    ? FindPropRow(PropStage::Hidden, this->FactsOf(known))
    : known.ViewAloneBy;
  if (known.AlwaysDrawnBy)
  {
    return "always drawn: " + vitrine::Explain(*known.AlwaysDrawnBy, prop);
  }
  if (showing >= FirstKept)
  {
    const KeepRow& row = KeepRows()[showing - FirstKept];
    return std::string("drawn: kept as ") + Sentence(row.Condition, {}, row.Why);
  }
  if (showing == MayShineThrough)
  {
    return "drawn: " + fate.Decision.Reason();
  }
  if (viewAlone)
  {
    return "drawn, as only the view hides it: " + vitrine::Explain(*viewAlone, prop);
  }
  if (showing == MayBeElsewhere)
  {
    return "drawn: it is hidden where it is, but not wherever a device may draw it";
  }
  if (fate.Decision.Mode == CullingMode::ViewOnly)
  {
    return "drawn, as only the view hides in this frame: " + fate.Decision.Reason();
  }
  const PropRow* const hidesNothing = this->FindHidesNothing(known);
  return hidesNothing ? "visible; hides nothing: " + vitrine::Explain(*hidesNothing, prop)
                      : "visible";
}

/** Returns a rule by which the part hides nothing, or null if it hides others. */
const PropRow* SceneParts::FindHidesNothing(const Part& part) const
{
  return part.HidesNothingBy ? part.HidesNothingBy
                             : FindPropRow(PropStage::Frame, this->FactsOf(part));
}

/** Returns true if a part lies outside of the view. */
bool SceneParts::IsOutside(std::uint32_t part, const RendererView& view) const
{
  const ScreenProjection& projection =
    this->Parts[part].IsOfViewAlone ? view.ProjectionOfViewAlone() : view.Projection();
  return !projection.RectangleOf(this->BoxInWorld(part));
}

}
