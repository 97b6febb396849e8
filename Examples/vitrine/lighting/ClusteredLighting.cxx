#include "lighting/ClusteredLighting.h"

#include "vtkCamera.h"
#include "vtkClusteredLightsPass.h"
#include "vtkDeferredLightsPass.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

namespace program
{

namespace
{
// Of tiles, beyond any picture.
const int WholePicture = 4096;

int SliceLawOf(const std::string& name)
{
  return name == "uniform" ? vtkClusteredLightsPass::UNIFORM
    : name == "ndc"        ? vtkClusteredLightsPass::NDC_UNIFORM
                           : vtkClusteredLightsPass::EXPONENTIAL;
}

/** From window depths to view coordinates. */
class Unprojection
{
public:
  explicit Unprojection(vtkRenderer* renderer)
    : Size{ renderer->GetSize()[0], renderer->GetSize()[1] }
  {
    this->ToView->DeepCopy(renderer->GetActiveCamera()->GetProjectionTransformMatrix(
      renderer->GetTiledAspectRatio(), -1, 1));
    this->ToView->Invert();
  }

  std::array<double, 3> At(int x, int y, double depth) const
  {
    const double clip[4] = { (2 * x + 1.0) / this->Size[0] - 1.0,
      (2 * y + 1.0) / this->Size[1] - 1.0, 2.0 * depth - 1.0, 1.0 };
    double place[4];
    this->ToView->MultiplyPoint(clip, place);
    return { place[0] / place[3], place[1] / place[3], place[2] / place[3] };
  }

private:
  std::array<int, 2> Size;
  vtkNew<vtkMatrix4x4> ToView;
};

/** The renderer's pass, in other light. */
class ClusteredLighting : public LightingMode
{
public:
  explicit ClusteredLighting(const LightingSettings& settings,
    vtkSmartPointer<vtkClusteredLightsPass> pass = vtkSmartPointer<vtkClusteredLightsPass>::New())
    : Pass(pass)
  {
    this->Pass->SetTileSize(settings.TileSize);
    this->Pass->SetNumberOfSlices(settings.Slices);
    this->Pass->SetSliceLaw(SliceLawOf(settings.SliceLaw));
    this->Pass->SetCutOff(settings.CutOff);
  }

  std::string WhyTooMany(std::size_t) const override { return ""; }

  std::string WhyNotRun() const override { return this->Pass->GetFallbackReason(); }

  void Attach(vtkRenderer* renderer) override
  {
    this->Renderer = renderer;
    this->Pass->SetDelegatePass(renderer->GetPass());
    renderer->SetPass(this->Pass);
  }

  LightingStatistics Statistics() const override
  {
    LightingStatistics statistics;
    statistics.AssignmentMilliseconds = 1000.0 * this->Pass->GetAssignmentTime();
    statistics.LightsPerClusterMean = this->Pass->GetMeanNumberOfLightsPerCluster();
    statistics.LightsPerClusterMax = this->Pass->GetMaximumNumberOfLightsPerCluster();
    statistics.Clusters = this->Pass->GetNumberOfClusters();
    statistics.Bytes = this->Pass->GetBytes();
    statistics.ClustersUsed = this->Pass->GetNumberOfUsedClusters();
    return statistics;
  }

  std::vector<std::uint32_t> LightsOfPixels(std::size_t pixels) const override
  {
    const int width = this->Renderer->GetSize()[0], height = this->Renderer->GetSize()[1];
    std::vector<float> depths(pixels);
    this->Renderer->GetRenderWindow()->GetZbufferData(0, 0, width - 1, height - 1, depths.data());
    const Unprojection unprojection(this->Renderer);
    std::vector<std::uint32_t> counts(pixels, 0);
    for (std::size_t i = 0; i < pixels; ++i)
    {
      const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      if (depths[i] < 1.0f)
      {
        const std::array<double, 3> place = unprojection.At(x, y, depths[i]);
        counts[i] =
          static_cast<std::uint32_t>(this->Pass->GetNumberOfLightsAt(place[0], place[1], place[2]));
      }
    }
    return counts;
  }

private:
  vtkRenderer* Renderer = nullptr;
  vtkSmartPointer<vtkClusteredLightsPass> Pass;
};

std::unique_ptr<LightingMode> MakeDeferred(const LightingSettings& settings, int assignment)
{
  auto pass = vtkSmartPointer<vtkDeferredLightsPass>::New();
  pass->SetAssignment(assignment);
  return std::make_unique<ClusteredLighting>(settings, pass);
}
}

std::unique_ptr<LightingMode> MakeClusteredLighting(const LightingSettings& settings)
{
  return std::make_unique<ClusteredLighting>(settings);
}

std::unique_ptr<LightingMode> MakeTiledLighting(const LightingSettings& settings)
{
  return std::make_unique<ClusteredLighting>(
    LightingSettings{ settings.TileSize, 1, settings.SliceLaw, settings.CutOff });
}

std::unique_ptr<LightingMode> MakeWorldLighting(const LightingSettings& settings)
{
  auto pass = vtkSmartPointer<vtkClusteredLightsPass>::New();
  pass->SetGridSpace(vtkClusteredLightsPass::WORLD);
  return std::make_unique<ClusteredLighting>(settings, pass);
}

std::unique_ptr<LightingMode> MakeLightLoop()
{
  return std::make_unique<ClusteredLighting>(LightingSettings{ WholePicture, 1, "uniform", 0.0 });
}

std::unique_ptr<LightingMode> MakeDeferredLighting(const LightingSettings& settings)
{
  return MakeDeferred(settings, vtkDeferredLightsPass::LIGHT_VOLUMES);
}

std::unique_ptr<LightingMode> MakeTiledDeferredLighting(const LightingSettings& settings)
{
  return MakeDeferred(settings, vtkDeferredLightsPass::TILES);
}

std::unique_ptr<LightingMode> MakeClusteredDeferredLighting(const LightingSettings& settings)
{
  return MakeDeferred(settings, vtkDeferredLightsPass::CLUSTERS);
}

}
