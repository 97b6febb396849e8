#include "scene/hall/HallSite.h"

namespace program
{

HallSite::HallSite()
{
  for (std::size_t i = 0; i < this->Materials.size(); ++i)
  {
    this->Materials[i] = MakeProperty(static_cast<HallMaterial>(i));
  }
}

void HallSite::Add(const std::string& name, HallMaterial material, const glm::dmat4& place,
  const std::function<Mesh()>& make)
{
  Part part;
  part.Name = "hall/" + name + "-" + std::to_string(++this->Numbers[name]);
  part.Geometry = this->Stock.Take(name, make);
  part.Material = this->Materials[static_cast<std::size_t>(material)];
  part.Transform = MatrixOf(place);
  this->Parts.push_back(part);
}

glm::dmat4 Upright()
{
  return TurnX(-0.5 * Pi);
}

}
