#include "lighting/LightingMeasurement.h"

#include "report/HeatMap.h"
#include "scene/Viewpoint.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>

namespace program
{

namespace
{
using Pixels = std::vector<std::uint8_t>;

/** A way of drawing lights in a stage. What is translucent is drawn as VTK does by default. */
class LitMethod : public Method
{
public:
  explicit LitMethod(std::unique_ptr<LightingMode> mode)
    : Mode(std::move(mode))
    , Translucent(MakeMethod("vtk-oit"))
  {
  }

  void Attach(vtkRenderer* renderer) override
  {
    this->Translucent->Attach(renderer);
    this->Mode->Attach(renderer);
  }

  /** Modes have been asked before. */
  std::size_t MostLights() const override { return std::numeric_limits<std::size_t>::max(); }

  MethodStatistics Statistics() const override { return this->Translucent->Statistics(); }
  std::string WhyNotRun() const override { return this->Mode->WhyNotRun(); }

  LightingMode& GetMode() { return *this->Mode; }

private:
  std::unique_ptr<LightingMode> Mode;
  std::unique_ptr<Method> Translucent;
};

/** A mode in its window, or why it has none. */
class LightingContestant
{
public:
  LightingContestant(const Scene& scene, const std::string& name, const LightingPlan& plan)
  {
    this->Result.Mode = name;
    std::unique_ptr<LightingMode> mode = MakeLightingMode(name, plan.Settings);
    this->Result.Skipped = mode->WhyTooMany(scene.Lights.size());
    if (!this->IsSkipped())
    {
      auto method = std::make_unique<LitMethod>(std::move(mode));
      this->Mode = &method->GetMode();
      this->Window =
        std::make_unique<Stage>(scene, std::move(method), plan.Size, /* multisamples= */ 0);
    }
  }

  bool IsSkipped() const { return !this->Result.Skipped.empty(); }

  /** Draw a frame for the time that the first one takes. */
  void DrawFirst(vtkCamera* camera) { this->Result.FirstFrameMilliseconds = this->Draw(camera); }

  void DrawTimed(vtkCamera* camera)
  {
    this->Result.FrameMilliseconds.push_back(this->Draw(camera));
    this->Last = this->Window->ReadPixels();
    if (this->First.empty())
    {
      this->First = this->Last;
    }
  }

  Pixels Heat() const
  {
    const PictureSize size = this->Window->GetSize();
    return HeatMap(this->Mode->LightsOfPixels(static_cast<std::size_t>(size.Width) * size.Height));
  }

  ModeResult Result;
  Pixels First; ///< frame that was timed
  Pixels Last;

private:
  /** The first frame that the mode does not draw itself makes its row a skipped one. */
  double Draw(vtkCamera* camera)
  {
    const double milliseconds = this->Window->Draw(camera);
    this->Result.Skipped = this->Mode->WhyNotRun();
    this->Result.Statistics = this->Mode->Statistics();
    return milliseconds;
  }

  LightingMode* Mode = nullptr; ///< of the window
  std::unique_ptr<Stage> Window;
};

using Contestants = std::vector<LightingContestant>;

/** Shows what is done next, and tells what was measured before. */
class LightingTeller
{
public:
  LightingTeller(
    const Scene& scene, Progress& progress, const std::function<void(const LightingRun&)>& changed)
    : Shown(progress)
    , Changed(changed)
  {
    this->Run.Name = scene.Name;
    this->Run.Lights = scene.Lights.size();
    this->Run.Reference = ReferenceMode(this->Run.Lights);
  }

  void Tell(const Contestants& contestants, const std::string& task)
  {
    this->Shown.Show(task);
    this->Run.Unfinished = task;
    this->Take(contestants);
    this->Changed(this->Run);
  }

  LightingRun Finish(const Contestants& contestants)
  {
    this->Run.Unfinished.clear();
    this->Take(contestants);
    return this->Run;
  }

  LightingRun Run;

private:
  void Take(const Contestants& contestants)
  {
    this->Run.Results.clear();
    for (const LightingContestant& contestant : contestants)
    {
      this->Run.Results.push_back(contestant.Result);
    }
  }

  Progress& Shown;
  const std::function<void(const LightingRun&)>& Changed;
};

/** Where the camera is at a frame; the last is `plan.Orbit` from the first. */
vtkSmartPointer<vtkCamera> CameraOf(const Scene& scene, const LightingPlan& plan, int frame)
{
  const double step = plan.Frames > 1 ? plan.Orbit / (plan.Frames - 1) : 0.0;
  return Orbit(PlaceCamera(scene, scene.Placement.DefaultView, plan.Size.Aspect()), frame * step);
}

Contestants SetUp(const Scene& scene, const LightingPlan& plan, LightingTeller& teller)
{
  Contestants contestants;
  for (const std::string& mode : plan.Modes)
  {
    teller.Tell(contestants, "first frame of " + mode);
    contestants.emplace_back(scene, mode, plan);
    if (!contestants.back().IsSkipped())
    {
      contestants.back().DrawFirst(CameraOf(scene, plan, 0));
    }
  }
  return contestants;
}

void DrawFrames(
  const Scene& scene, const LightingPlan& plan, Contestants& contestants, LightingTeller& teller)
{
  for (int frame = 0; frame < plan.Frames; ++frame)
  {
    const vtkSmartPointer<vtkCamera> camera = CameraOf(scene, plan, frame);
    for (LightingContestant& contestant : contestants)
    {
      if (!contestant.IsSkipped())
      {
        teller.Tell(contestants,
          "frame " + std::to_string(frame + 1) + " of " + std::to_string(plan.Frames) + ", " +
            contestant.Result.Mode);
        contestant.DrawTimed(camera);
      }
    }
  }
}

double LargestDifference(const Pixels& a, const Pixels& b)
{
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest / 255.0;
}

/** The pictures of a mode, of the first and the last frame alone. */
LightingContestant DrawReference(
  const Scene& scene, const LightingPlan& plan, const std::string& mode)
{
  LightingContestant reference(scene, mode, plan);
  for (const int frame : { 0, plan.Frames - 1 })
  {
    if (!reference.IsSkipped())
    {
      reference.DrawTimed(CameraOf(scene, plan, frame));
    }
  }
  return reference;
}

void JudgeBy(const LightingContestant& reference, Contestants& contestants)
{
  for (LightingContestant& contestant : contestants)
  {
    if (!contestant.IsSkipped() && !reference.IsSkipped())
    {
      contestant.Result.Error = std::max(LargestDifference(contestant.First, reference.First),
        LargestDifference(contestant.Last, reference.Last));
    }
  }
}

/** By the reference among the modes, or by one that is drawn for that. */
void Judge(const Scene& scene, const LightingPlan& plan, const std::string& reference,
  Contestants& contestants, LightingTeller& teller)
{
  if (reference.empty())
  {
    return;
  }
  const auto among = std::find_if(contestants.begin(), contestants.end(),
    [&](const LightingContestant& each) { return each.Result.Mode == reference; });
  if (among != contestants.end())
  {
    JudgeBy(*among, contestants);
  }
  else
  {
    teller.Tell(contestants, "drawing the reference, " + reference);
    JudgeBy(DrawReference(scene, plan, reference), contestants);
  }
}

Pixels LastHeat(const Contestants& contestants)
{
  const auto last = std::find_if(contestants.rbegin(), contestants.rend(),
    [](const LightingContestant& each) { return !each.IsSkipped(); });
  return last == contestants.rend() ? Pixels{} : last->Heat();
}
}

LightingRun MeasureLighting(const Scene& scene, const LightingPlan& plan, Progress& progress,
  const std::function<void(const LightingRun&)>& changed)
{
  LightingTeller teller(scene, progress, changed);
  Contestants contestants = SetUp(scene, plan, teller);
  DrawFrames(scene, plan, contestants, teller);
  if (plan.ShowsHeat)
  {
    teller.Run.Heat = LastHeat(contestants);
  }
  Judge(scene, plan, teller.Run.Reference, contestants, teller);
  return teller.Finish(contestants);
}

}
