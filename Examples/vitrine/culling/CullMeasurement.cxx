#include "culling/CullMeasurement.h"

#include "culling/ItemBuffer.h"
#include "methods/Method.h"

#include "vtkHierarchicalSBufferCuller.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <memory>
#include <optional>

namespace program
{

namespace
{

/** A method, and a culler at the renderer that it is attached to. */
class CulledMethod : public Method
{
public:
  CulledMethod(std::unique_ptr<Method> method, vtkHierarchicalSBufferCuller* culler)
    : Drawn(std::move(method))
    , Culler(culler)
  {
  }

  void Attach(vtkRenderer* renderer) override
  {
    this->Drawn->Attach(renderer);
    renderer->AddCuller(this->Culler);
  }
  MethodStatistics Statistics() const override { return this->Drawn->Statistics(); }
  std::string WhyNotRun() const override { return this->Drawn->WhyNotRun(); }

private:
  std::unique_ptr<Method> Drawn;
  vtkHierarchicalSBufferCuller* Culler;
};

std::int64_t CountDifferent(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)
{
  std::int64_t different = 0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3)
  {
    different += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
  }
  return different;
}

/** The two pictures of a pose. */
class CullStage
{
public:
  CullStage(const Scene& scene, const CullSettings& settings)
    : Window(scene, std::make_unique<CulledMethod>(MakeMethod(settings.Method), this->Culler),
        settings.Size, settings.Multisamples)
  {
    this->Culler->SetBufferLines(settings.BufferLines);
  }

  CullFrame Measure(vtkCamera* camera)
  {
    CullFrame frame;
    this->Culler->CullingOff();
    frame.FrameMillisecondsWithout = this->Window.Draw(camera);
    const std::vector<std::uint8_t> without = this->Window.ReadPixels();
    this->Culler->CullingOn();
    frame.FrameMilliseconds = this->Window.Draw(camera);
    frame.CullMilliseconds = 1000.0 * this->Culler->GetCullTime();
    frame.Drawn = static_cast<std::size_t>(this->Culler->GetNumberOfDrawnProps());
    frame.WrongPixels = CountDifferent(without, this->Window.ReadPixels());
    return frame;
  }

  Device GetDevice() { return this->Window.GetDevice(); }

private:
  vtkNew<vtkHierarchicalSBufferCuller> Culler;
  Stage Window;
};
}

CullRun MeasureCulling(
  const Scene& scene, const CullSettings& settings, const std::function<void(int)>& progress)
{
  CullRun run;
  run.Name = scene.Name;
  run.Parts = scene.Parts.size();
  run.Settings = settings;
  CullStage stage(scene, settings);
  std::optional<ItemBuffer> ideal;
  if (settings.CountsIdeal)
  {
    ideal.emplace(scene, settings.Size);
    run.OpaqueParts = ideal->CountParts();
  }
  CullPoses poses(scene, settings.Projection, settings.Seed);
  for (int i = 0; i < settings.Poses; ++i)
  {
    progress(i);
    const vtkSmartPointer<vtkCamera> camera = poses.Next();
    if (i == 0)
    {
      stage.Measure(camera); // builds buffers
    }
    run.Frames.push_back(stage.Measure(camera));
    if (ideal)
    {
      run.Frames.back().Ideal = ideal->CountOwners(camera);
    }
  }
  run.DrawnBy = stage.GetDevice();
  return run;
}

}
