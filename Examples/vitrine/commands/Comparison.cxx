#include "commands/Comparison.h"

#include "Median.h"
#include "scene/OpacityAdvice.h"
#include "scene/Viewpoint.h"

#include <algorithm>
#include <memory>

namespace program
{

namespace
{
const int WarmUpFrames = 2; // shaders are built, pools take their size

struct Contestant
{
  MethodResult& Result;
  std::unique_ptr<Stage> Window;
  std::vector<std::uint8_t> LastPicture;
  std::vector<std::int64_t> GeometryPasses; ///< of the timed frames
};

/** Draws a scene by several methods, and tells what it does before it does it. */
class ComparisonRun
{
public:
  ComparisonRun(const Scene& scene, const ComparisonSettings& settings, Progress& progress,
    const ComparisonListener& changed)
    : InScene(scene)
    , Settings(settings)
    , Shown(progress)
    , Changed(changed)
    , Start(PlaceCamera(scene, settings.From, settings.Size.Aspect()))
  {
    this->Comparison.Scene = scene.Name;
    this->Comparison.Settings = settings;
    this->Comparison.Advice = OpacityAdvice(scene);
    this->Comparison.Results.resize(settings.Methods.size());
  }

  ComparisonResult Measure()
  {
    this->SetUp();
    this->WarmUp();
    this->DrawFrames();
    this->CloseWindows();
    if (this->Settings.IsJudged)
    {
      this->JudgeByTruth();
    }
    this->Comparison.Unfinished.clear();
    return std::move(this->Comparison);
  }

private:
  void SetUp();
  void WarmUp();
  void DrawFrames();
  void CloseWindows();
  void JudgeByTruth();

  double Draw(Contestant& contestant, vtkCamera* camera);
  void DrawFrame(Contestant& contestant, vtkCamera* camera);
  void Tell(const std::string& task);
  vtkSmartPointer<vtkCamera> CameraOf(int frame) const;

  const Scene& InScene;
  const ComparisonSettings& Settings;
  Progress& Shown;
  const ComparisonListener& Changed;
  vtkSmartPointer<vtkCamera> Start;
  ComparisonResult Comparison;
  std::vector<Contestant> Contestants;
};

void ComparisonRun::Tell(const std::string& task)
{
  this->Shown.Show(task);
  this->Comparison.Unfinished = task;
  if (this->Changed)
  {
    this->Changed(this->Comparison);
  }
}

/** The last frame is `Settings.Orbit` from the first. */
vtkSmartPointer<vtkCamera> ComparisonRun::CameraOf(int frame) const
{
  const int steps = this->Settings.Frames - 1;
  return Orbit(this->Start, steps > 0 ? frame * (this->Settings.Orbit / steps) : 0.0);
}

void ComparisonRun::SetUp()
{
  for (std::size_t i = 0; i < this->Settings.Methods.size(); ++i)
  {
    Contestant contestant{ this->Comparison.Results[i], nullptr, {}, {} };
    contestant.Result.Method = this->Settings.Methods[i];
    std::unique_ptr<Method> drawing = MakeMethod(contestant.Result.Method);
    contestant.Result.Skipped = drawing->SetCoincidence(this->Settings.Tolerance);
    if (this->Settings.ErrorBudget && contestant.Result.Method == AutomaticName)
    {
      contestant.Result.Skipped += drawing->SetErrorBudget(*this->Settings.ErrorBudget);
    }
    if (this->Settings.MeasuresStages)
    {
      drawing->MeasureStages();
    }
    contestant.Window = std::make_unique<Stage>(
      this->InScene, std::move(drawing), this->Settings.Size, this->Settings.Multisamples);
    this->Contestants.push_back(std::move(contestant));
  }
}

/** Draw a frame; the first that the method does not draw itself makes its row a skipped one. */
double ComparisonRun::Draw(Contestant& contestant, vtkCamera* camera)
{
  const double milliseconds = contestant.Window->Draw(camera);
  if (contestant.Result.Skipped.empty())
  {
    contestant.Result.Skipped = contestant.Window->GetMethod().WhyNotRun();
  }
  if (this->Comparison.GL.Renderer.empty())
  {
    this->Comparison.GL = contestant.Window->GetDevice();
  }
  return milliseconds;
}

/** Draw untimed frames, and learn who else cannot. */
void ComparisonRun::WarmUp()
{
  for (Contestant& contestant : this->Contestants)
  {
    for (int i = 0; i < WarmUpFrames && contestant.Result.Skipped.empty(); ++i)
    {
      this->Tell("warming up " + contestant.Result.Method);
      const double milliseconds = this->Draw(contestant, this->Start);
      contestant.Result.FirstFrameMilliseconds =
        contestant.Result.FirstFrameMilliseconds.value_or(milliseconds);
    }
  }
}

/** A frame that is drawn again from where it was may take fewer passes than the one that is timed. */
std::optional<std::int64_t> MedianPasses(Contestant& contestant)
{
  std::vector<std::int64_t>& passes = contestant.GeometryPasses;
  if (passes.empty())
  {
    return std::nullopt;
  }
  const auto middle = passes.begin() + passes.size() / 2;
  std::nth_element(passes.begin(), middle, passes.end());
  return *middle;
}

/** Draw one frame twice: once for the time, once for whether it comes out the same. */
void ComparisonRun::DrawFrame(Contestant& contestant, vtkCamera* camera)
{
  MethodResult& result = contestant.Result;
  result.FrameMilliseconds.push_back(this->Draw(contestant, camera));
  result.Statistics = contestant.Window->GetMethod().Statistics();
  if (this->Settings.MeasuresStages)
  {
    result.Stages.push_back(result.Statistics.Stages);
  }
  if (const auto passes = result.Statistics.GeometryPasses)
  {
    contestant.GeometryPasses.push_back(*passes);
  }
  contestant.LastPicture = contestant.Window->ReadPixels();
  if (result.Picture.empty())
  {
    result.Picture = contestant.LastPicture;
  }
  this->Draw(contestant, camera);
  if (contestant.Window->ReadPixels() != contestant.LastPicture)
  {
    result.IsDeterministic = false;
  }
  result.Statistics = contestant.Window->GetMethod().Statistics();
  result.Statistics.GeometryPasses = MedianPasses(contestant);
}

void ComparisonRun::DrawFrames()
{
  for (int frame = 0; frame < this->Settings.Frames; ++frame)
  {
    const vtkSmartPointer<vtkCamera> camera = this->CameraOf(frame);
    for (Contestant& contestant : this->Contestants)
    {
      if (contestant.Result.Skipped.empty())
      {
        this->Tell("frame " + std::to_string(frame + 1) + " of " +
          std::to_string(this->Settings.Frames) + ", " + contestant.Result.Method);
        this->DrawFrame(contestant, camera);
      }
    }
  }
}

void ComparisonRun::CloseWindows()
{
  for (Contestant& contestant : this->Contestants)
  {
    contestant.Window.reset();
  }
}

vitrine::ImageError Worse(const vitrine::ImageError& a, const vitrine::ImageError& b)
{
  vitrine::ImageError worse;
  worse.Max = std::max(a.Max, b.Max);
  worse.Rmse = std::max(a.Rmse, b.Rmse);
  worse.Psnr = std::min(a.Psnr, b.Psnr);
  worse.Ssim = std::min(a.Ssim, b.Ssim);
  worse.Flip = std::max(a.Flip, b.Flip);
  worse.WrongPixels = std::max(a.WrongPixels, b.WrongPixels);
  return worse;
}

/** Layers and fragments are the scene's: truth counts them for methods that do not. */
void FillIn(MethodStatistics& statistics, const MethodStatistics& truth)
{
  statistics.Fragments = statistics.Fragments ? statistics.Fragments : truth.Fragments;
  statistics.LayersMax = statistics.LayersMax ? statistics.LayersMax : truth.LayersMax;
  statistics.LayersMean = statistics.LayersMean ? statistics.LayersMean : truth.LayersMean;
}

/** Compare pictures with truth's, if truth can run here. */
void ComparisonRun::JudgeByTruth()
{
  this->Tell("drawing truth");
  TruthStage truth(
    this->InScene, this->Settings.Size, this->Settings.Multisamples, this->Settings.Tolerance);
  const std::unique_ptr<vitrine::Image> first = truth.Draw(this->Start);
  this->Comparison.GL = truth.GetStage().GetDevice(); // even where all methods are skipped
  const std::unique_ptr<vitrine::Image> last =
    truth.Draw(this->CameraOf(this->Settings.Frames - 1));
  if (!first || !last)
  {
    return;
  }
  this->Comparison.TruthPicture = ToPixels(*first);
  for (Contestant& contestant : this->Contestants)
  {
    MethodResult& result = contestant.Result;
    if (result.Skipped.empty())
    {
      this->Tell("judging " + result.Method);
      result.Error =
        Worse(vitrine::CompareImages(ToImage(result.Picture, this->Settings.Size), *first),
          vitrine::CompareImages(ToImage(contestant.LastPicture, this->Settings.Size), *last));
      FillIn(result.Statistics, truth.Statistics());
    }
  }
}
}

double MethodResult::Median() const
{
  return program::Median(this->FrameMilliseconds);
}

std::optional<Regret> RegretOf(const ComparisonResult& comparison)
{
  const double budget = comparison.Settings.ErrorBudget.value_or(DefaultErrorBudget);
  const MethodResult* automatic = nullptr;
  const MethodResult* fastest = nullptr;
  for (const MethodResult& result : comparison.Results)
  {
    if (!result.Skipped.empty() || result.FrameMilliseconds.empty())
    {
      continue;
    }
    if (result.Method == AutomaticName)
    {
      automatic = &result;
    }
    else if (result.Error && result.Error->Max <= budget &&
      (!fastest || result.Median() < fastest->Median()))
    {
      fastest = &result;
    }
  }
  if (!automatic || !fastest)
  {
    return std::nullopt;
  }
  return Regret{ automatic->Median() / fastest->Median(), fastest->Method };
}

std::vector<std::pair<std::string, std::vector<double>>> TimesOfStages(const MethodResult& result)
{
  std::vector<std::pair<std::string, std::vector<double>>> times;
  for (const StageTimes& frame : result.Stages)
  {
    for (const auto& [stage, milliseconds] : frame)
    {
      const auto found = std::find_if(times.begin(), times.end(),
        [name = stage](const auto& each) { return each.first == name; });
      if (found == times.end())
      {
        times.push_back({ stage, { milliseconds } });
      }
      else
      {
        found->second.push_back(milliseconds);
      }
    }
  }
  return times;
}

ComparisonResult CompareMethods(const Scene& scene, const ComparisonSettings& settings,
  Progress& progress, const ComparisonListener& changed)
{
  return ComparisonRun(scene, settings, progress, changed).Measure();
}

}
