#include "scene/OpacityAdvice.h"

#include "scene/Scene.h"

#include <algorithm>

namespace program
{

std::string OpacityAdvice(const Scene& scene)
{
  const bool isTranslucent = std::any_of(scene.Parts.begin(), scene.Parts.end(), IsTranslucent);
  return scene.Parts.empty() || isTranslucent
    ? ""
    : "Nothing in it is translucent; --opacity 0.3 makes it so.";
}

}
