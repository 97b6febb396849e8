#include "lighting/VTKLighting.h"

#include "scene/Lights.h"

#include "vtkLightCollection.h"
#include "vtkRenderer.h"

namespace program
{

namespace
{
class VTKLighting : public LightingMode
{
public:
  std::string WhyTooMany(std::size_t lights) const override
  {
    return lights > MostLightsOfVTK
      ? std::to_string(lights) + " lights take VTK minutes to compile, or end the program; " +
        std::to_string(MostLightsOfVTK) + " are the most that are tried"
      : "";
  }

  void Attach(vtkRenderer* renderer) override { this->Renderer = renderer; }

  LightingStatistics Statistics() const override { return {}; }

  std::vector<std::uint32_t> LightsOfPixels(std::size_t pixels) const override
  {
    const int lights = this->Renderer->GetLights()->GetNumberOfItems();
    return std::vector<std::uint32_t>(pixels, static_cast<std::uint32_t>(lights));
  }

private:
  vtkRenderer* Renderer = nullptr;
};
}

std::unique_ptr<LightingMode> MakeVTKLighting()
{
  return std::make_unique<VTKLighting>();
}

}
