#include "Core/culling/hidden/HiddenLines.h"

#include "Core/culling/screen/DeviceModel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

/** An end of a line on the screen. */
struct ScreenEnd
{
  glm::dvec2 Place; ///< column and line
  double Depth;

  explicit ScreenEnd(const glm::dvec4& place)
    : Place(glm::dvec2(place) / place.w)
    , Depth(place.z / place.w)
  {
  }
};

/**
 * Returns the rectangle of a line, with all that is drawn beyond its ends and beside it. If its depth is not known,
 * Nearest is infinite or no number.
 */
ScreenRectangle Around(
  const ScreenEnd& a, const ScreenEnd& b, const ScreenMargin& margin, const glm::dvec2& growth)
{
  const double off = std::max(margin.Column, margin.Line);
  const double length = glm::length(b.Place - a.Place);
  const double differ = std::abs(b.Depth - a.Depth) + 2.0 * margin.Depth;
  const double beyond = length >= ShortestByMargin * off
    ? SteeperByMargin * differ / length * glm::length(growth)
    : std::numeric_limits<double>::infinity();
  const glm::dvec2 aside = growth + glm::dvec2(margin.Column, margin.Line);
  const glm::dvec2 low = glm::min(a.Place, b.Place) - aside;
  const glm::dvec2 high = glm::max(a.Place, b.Place) + aside;
  return { static_cast<float>(low.x), static_cast<float>(high.x), static_cast<float>(low.y),
    static_cast<float>(high.y),
    static_cast<float>(std::max(a.Depth, b.Depth) + margin.Depth + beyond) };
}

bool IsHidden(const MeshLine& line, const ScreenMatrix& toScreen, const glm::vec2& growth,
  const SBuffer& buffer)
{
  const glm::dvec4 from = toScreen.Matrix * glm::dvec4(line.From, 1.0);
  const glm::dvec4 to = toScreen.Matrix * glm::dvec4(line.To, 1.0);
  const double leastW = std::min(from.w, to.w);
  if (!(leastW > 2.0 * static_cast<double>(toScreen.Rounding.w)))
  {
    return false;
  }
  const ScreenMargin margin = toScreen.MarginFrom(static_cast<float>(leastW));
  return buffer.Hides(Around(ScreenEnd(from), ScreenEnd(to), margin, glm::dvec2(growth)));
}
}

bool AreLinesHidden(const std::vector<MeshLine>& lines, const ScreenMatrix& toScreen,
  const glm::vec2& growth, const SBuffer& buffer)
{
  return std::all_of(lines.begin(), lines.end(),
    [&](const MeshLine& line) { return IsHidden(line, toScreen, growth, buffer); });
}

}
