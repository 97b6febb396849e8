// Whether any of what is translucent is drawn.
#include "culling/SceneParts.h"

#include "vtkProp.h"

#include <cstddef>
#include <optional>

namespace vitrine
{

void SceneParts::KeepOneTranslucent(std::vector<std::uint8_t>& visible) const
{
  std::optional<std::uint32_t> leftOut;
  for (std::size_t i = 0; i < this->Drawn.size(); ++i)
  {
    const std::uint32_t part = this->Drawn[i];
    const int number = static_cast<int>(i);
    const bool shows = this->CountHidden(number, visible) < this->CountParts(number);
    if ((shows || !leftOut) && this->MayBeTranslucent(part) &&
      this->PropOf[part]->HasTranslucentPolygonalGeometry())
    {
      if (shows)
      {
        return;
      }
      leftOut = part;
    }
  }
  if (leftOut)
  {
    this->Mark(*leftOut, visible);
  }
}

/** Of a prop: it takes VTK longer to find out than it takes to see that many surely are not. Whether blocks are is known of each by itself. */
bool SceneParts::MayBeTranslucent(std::uint32_t part) const
{
  const Part& known = this->Parts[part];
  return !known.Actor || known.Divided || !this->IsOpaque(known);
}

}
