#include "stability/SceneTruth.h"

#include "VTKMessages.h"
#include "scene/Viewpoint.h"
#include "stability/PictureChanges.h"
#include "stability/StudyPlan.h"
#include "stability/Verdict.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace program
{

namespace
{
const double ShiftDirection = 0.5; // radians above the picture's horizon, so that both axes move

/** Steps of scenes that take long to draw. */
const int HeavySteps = 2;

int Steps(const StabilityScene& entry, int usual)
{
  return entry.IsHeavy ? std::min(usual, HeavySteps) : usual;
}

vtkSmartPointer<vtkCamera> Shifted(vtkCamera* start, double pixels, int height)
{
  return Shift(start, pixels * std::cos(ShiftDirection), pixels * std::sin(ShiftDirection), height);
}

std::vector<OtherTruth> OtherWindowsOf(PictureSize size)
{
  const auto part = [](int side, int divisor) { return std::max(1, side / divisor); };
  return { { "half", { part(size.Width, 2), part(size.Height, 2) }, 0, {}, "" },
    { "double", { 2 * size.Width, 2 * size.Height }, 0, {}, "" },
    { "third", { part(size.Width, 3), part(size.Height, 3) }, 0, {}, "" },
    { "4-samples", size, 4, {}, "" } };
}

SceneTruth PlanViews(const StabilityScene& entry, const StabilitySettings& settings)
{
  SceneTruth plan;
  plan.Entry = entry;
  plan.Parts = entry.Load();
  DrawPartsApart(plan.Parts); // in any order
  plan.Size = entry.Size.value_or(settings.Size);
  plan.Repetitions = Steps(entry, settings.Repetitions);
  plan.Orders = PlanOrders(plan.Parts.Parts.size(), Steps(entry, settings.Orders));
  const vtkSmartPointer<vtkCamera> start = OwnView(plan.Parts, plan.Size);
  const MotionPlan turns = PlanTurns(Steps(entry, settings.Turns));
  for (const double degrees : turns.Places)
  {
    plan.Turns.push_back(Orbit(start, degrees));
  }
  plan.TurnRun = turns.RunLength;
  if (settings.WithOtherWindows && !entry.IsHeavy)
  {
    plan.Others = OtherWindowsOf(plan.Size);
  }
  return plan;
}

/** The plan's shifts: where they are few, over steps that change truth. */
void PlanShiftViews(SceneTruth& plan, const StabilitySettings& settings, TruthStage& truth)
{
  const vtkSmartPointer<vtkCamera> start = OwnView(plan.Parts, plan.Size);
  std::map<int, std::unique_ptr<vitrine::Image>> pictures;
  const auto draw = [&](int steps) -> const vitrine::Image*
  {
    const auto [place, isNew] = pictures.try_emplace(steps);
    if (isNew)
    {
      place->second = truth.Draw(Shifted(start, InPixels(steps), plan.Size.Height));
    }
    return place->second.get();
  };
  const MotionPlan shifts = PlanShifts(Steps(plan.Entry, settings.Shifts),
    [&draw](int a, int b)
    {
      const vitrine::Image* before = draw(a);
      const vitrine::Image* after = draw(b);
      return before && after && LargestDifference(*before, *after) > LargestExactError(0);
    });
  for (const double pixels : shifts.Places)
  {
    plan.Shifts.push_back(Shifted(start, pixels, plan.Size.Height));
  }
  plan.ShiftRun = shifts.RunLength;
}

/** Pictures of all the views; an empty list, and why, if truth cannot run. */
std::vector<vitrine::Image> DrawAll(
  TruthStage& truth, const std::vector<vtkSmartPointer<vtkCamera>>& cameras, std::string& skipped)
{
  std::vector<vitrine::Image> pictures;
  for (vtkCamera* camera : cameras)
  {
    const std::unique_ptr<vitrine::Image> picture = truth.Draw(camera);
    if (!picture)
    {
      skipped = truth.WhyNotRun();
      return {};
    }
    pictures.push_back(*picture);
  }
  return pictures;
}

void DrawOther(OtherTruth& other, const SceneTruth& plan, TruthStage& truth)
{
  truth.GetStage().SetScene(plan.Parts);
  truth.GetStage().SetSize(other.Size);
  const std::unique_ptr<vitrine::Image> picture = truth.Draw(OwnView(plan.Parts, other.Size));
  if (picture)
  {
    other.Picture = *picture;
  }
  else
  {
    other.Skipped = truth.WhyNotRun();
  }
}
}

vtkSmartPointer<vtkCamera> OwnView(const Scene& scene, PictureSize size)
{
  return PlaceCamera(scene, scene.Placement.DefaultView, size.Aspect());
}

void DrawAfterZoom(Stage& stage, vtkCamera* camera, const StabilityScene& entry)
{
  if (entry.ZoomBefore != 1.0)
  {
    vtkNew<vtkCamera> before;
    before->DeepCopy(camera);
    Magnify(before, entry.ZoomBefore);
    stage.Draw(before);
  }
  stage.Draw(camera);
}

SceneTruth DrawTruth(const StabilityScene& entry, const StabilitySettings& settings,
  TruthStage& single, TruthStage& multisampled)
{
  MessageCapture messages;
  SceneTruth truth = PlanViews(entry, settings);
  single.GetStage().SetScene(truth.Parts);
  single.GetStage().SetSize(truth.Size);
  PlanShiftViews(truth, settings, single);
  truth.ShiftPictures = DrawAll(single, truth.Shifts, truth.Skipped);
  truth.TurnPictures = DrawAll(single, truth.Turns, truth.Skipped);
  for (OtherTruth& other : truth.Others)
  {
    DrawOther(other, truth, other.Multisamples > 0 ? multisampled : single);
  }
  messages.ShowAllBut({ truth.Skipped }); // which the rows of all methods tell
  return truth;
}

}
