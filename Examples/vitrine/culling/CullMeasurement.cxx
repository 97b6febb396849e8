#include "culling/CullMeasurement.h"

#include "culling/BufferPicture.h"
#include "culling/IdealCuller.h"
#include "culling/ItemBuffer.h"
#include "methods/VTKMethods.h"
#include "scene/Viewpoint.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkHierarchicalSBufferCuller.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_set>

namespace program
{

namespace
{

/** A method, and the culler of the renderer that it is attached to: VTK's own or ours. */
class CulledMethod : public Method
{
public:
  explicit CulledMethod(std::unique_ptr<Method> method)
    : Drawn(std::move(method))
  {
  }

  void Attach(vtkRenderer* renderer) override
  {
    this->Drawn->Attach(renderer);
    this->Renderer = renderer;
  }

  /** Draw one actor in place of all. */
  void SetActor(vtkActor* actor)
  {
    this->Renderer->RemoveAllViewProps();
    this->Renderer->AddActor(actor);
  }

  void SetCuller(vtkCuller* culler)
  {
    this->RemoveCuller();
    this->Renderer->AddCuller(culler);
  }

  void RemoveCuller() { this->Renderer->GetCullers()->RemoveAllItems(); }

  vtkRenderer* GetRenderer() { return this->Renderer; }
  MethodStatistics Statistics() const override { return this->Drawn->Statistics(); }
  std::string WhyNotRun() const override { return this->Drawn->WhyNotRun(); }

private:
  std::unique_ptr<Method> Drawn;
  vtkRenderer* Renderer = nullptr;
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

/**
 * The two pictures of a pose. The order of drawing alternates from pose to pose, since the first drawing costs more for
 * methods that allocate memory then.
 */
class CullStage
{
public:
  CullStage(const Scene& scene, const CullSettings& settings)
    : CullStage(scene, settings, std::make_unique<CulledMethod>(MakeMethod(settings.Method)))
  {
  }

  /** What VTK builds for all parts when it first draws them. */
  void BuildBuffers(vtkCamera* camera) { this->Measure(camera); }

  /** The frame before: what the culler makes of parts when it first sees them. */
  void Prepare(vtkCamera* camera)
  {
    CullFrame frame;
    this->DrawCulled(camera, frame);
  }

  CullFrame Measure(vtkCamera* camera)
  {
    CullFrame frame;
    this->OursFirst = !this->OursFirst;
    if (this->OursFirst)
    {
      this->DrawCulled(camera, frame);
      frame.Props = this->ReasonsOfProps();
    }
    this->Cullers->SetCuller(this->Usual);
    frame.FrameMillisecondsWithout = this->Window.Draw(camera);
    const std::vector<std::uint8_t> without = this->Window.ReadPixels();
    if (!this->OursFirst)
    {
      this->DrawCulled(camera, frame);
      frame.Props = this->ReasonsOfProps();
    }
    frame.WrongPixels = CountDifferent(without, this->Picture);
    if (frame.WrongPixels > 0) // VTK's own culler may have left out what shows
    {
      this->Cullers->RemoveCuller();
      this->Window.Draw(camera);
      frame.WrongPixels = CountDifferent(this->Window.ReadPixels(), this->Picture);
    }
    return frame;
  }

  /** The time of a frame in which some opaque parts are drawn and all that are not opaque. */
  double DrawOnly(
    vtkCamera* camera, const std::vector<std::size_t>& opaque, const std::vector<std::size_t>& some)
  {
    std::vector<vtkProp*> props;
    vtkCollectionSimpleIterator i;
    vtkPropCollection* const all = this->Cullers->GetRenderer()->GetViewProps();
    for (all->InitTraversal(i); vtkProp* prop = all->GetNextProp(i);)
    {
      props.push_back(prop);
    }
    std::unordered_set<vtkProp*> kept(props.begin(), props.end());
    std::for_each(opaque.begin(), opaque.end(), [&](std::size_t part) { kept.erase(props[part]); });
    std::for_each(some.begin(), some.end(), [&](std::size_t part) { kept.insert(props[part]); });
    this->Ideal->Keep(std::move(kept));
    this->Cullers->SetCuller(this->Ideal);
    return this->Window.Draw(camera);
  }

  /** Of the last picture. */
  std::size_t CountParts() const
  {
    return static_cast<std::size_t>(
      this->Ours->GetNumberOfDrawnParts() + this->Ours->GetNumberOfCulledParts());
  }

  /** The last culled frame and its s-buffer. */
  std::vector<std::uint8_t> PictureWithBuffer()
  {
    return WithBuffer(this->Picture, this->Window.GetSize(),
      this->Ours->GetBufferImage(this->Cullers->GetRenderer()));
  }

  Device GetDevice() { return this->Window.GetDevice(); }
  int GetSamples() { return this->Window.GetSamples(); }

private:
  CullStage(const Scene& scene, const CullSettings& settings, std::unique_ptr<CulledMethod> cullers)
    : Cullers(cullers.get())
    , Window(scene, std::move(cullers), settings.Size, settings.Multisamples)
  {
    this->Ours->SetBufferLines(settings.BufferLines);
    for (const char* pass : PassesOfVTKMethods())
    {
      this->Ours->AddKnownPass(pass);
    }
    if (settings.Form != SceneForm::Actors)
    {
      this->Cullers->SetActor(MakeActorOfAll(scene, settings.Form));
    }
  }

  void DrawCulled(vtkCamera* camera, CullFrame& frame)
  {
    this->Cullers->SetCuller(this->Ours);
    frame.FrameMilliseconds = this->Window.Draw(camera);
    frame.CullMilliseconds = 1000.0 * this->Ours->GetCullTime();
    frame.Lines = this->Ours->GetNumberOfBufferLines();
    frame.Drawn = static_cast<std::size_t>(this->Ours->GetNumberOfDrawnParts());
    frame.Mode = this->Ours->GetCullingModeAsString();
    frame.Reason = this->Ours->GetReason();
    this->Picture = this->Window.ReadPixels();
  }

  /** Of the last culled frame. */
  PropReasons ReasonsOfProps()
  {
    PropReasons reasons;
    vtkCollectionSimpleIterator i;
    vtkPropCollection* const all = this->Cullers->GetRenderer()->GetViewProps();
    for (all->InitTraversal(i); vtkProp* prop = all->GetNextProp(i);)
    {
      ++reasons[this->Ours->GetReason(prop)];
    }
    return reasons;
  }

  CulledMethod* Cullers; ///< of the window
  vtkNew<vtkFrustumCoverageCuller> Usual;
  vtkNew<vtkHierarchicalSBufferCuller> Ours;
  vtkNew<IdealCuller> Ideal;
  Stage Window;
  bool OursFirst = false;
  std::vector<std::uint8_t> Picture; ///< with our culler
};

void AddIdeal(CullRun& run, CullStage& stage, ItemBuffer& ideal, vtkCamera* camera)
{
  CullFrame& frame = run.Frames.back();
  const std::vector<std::size_t> owners = ideal.FindOwners(camera);
  frame.Ideal = owners.size();
  if (run.HasIdealFrames)
  {
    frame.FrameMillisecondsIdeal = stage.DrawOnly(camera, ideal.Parts(), owners);
  }
}
}

CullRun MeasureCulling(const Scene& scene, const CullSettings& settings,
  const std::function<void(const CullRun&)>& progress)
{
  CullRun run;
  run.Name = scene.Name;
  run.Settings = settings;
  CullStage stage(scene, settings);
  std::optional<ItemBuffer> ideal;
  if (settings.CountsIdeal && settings.Form != SceneForm::Mesh)
  {
    ideal.emplace(scene, settings.Size);
    run.OpaqueParts = ideal->Parts().size();
    run.HasIdealFrames = run.OpaqueParts > 0 && settings.Form == SceneForm::Actors;
  }
  CullPoses poses(scene, settings.Projection, settings.Seed);
  poses.Skip(settings.SkippedPoses);
  for (int i = 0; i < settings.Poses; ++i)
  {
    progress(run);
    const vtkSmartPointer<vtkCamera> camera = poses.Next();
    if (i == 0)
    {
      stage.BuildBuffers(camera);
    }
    stage.Prepare(Orbit(camera, settings.TurnDegrees));
    run.Frames.push_back(stage.Measure(camera));
    if (ideal)
    {
      AddIdeal(run, stage, *ideal, camera);
    }
    if (i == 0)
    {
      run.DrawnBy = stage.GetDevice();
      run.Samples = stage.GetSamples();
    }
    run.Parts = stage.CountParts();
  }
  if (settings.ShowsBuffer)
  {
    run.LastPicture = stage.PictureWithBuffer();
  }
  return run;
}

}
