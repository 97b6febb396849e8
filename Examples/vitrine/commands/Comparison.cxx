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
  MethodResult Result;
  std::unique_ptr<Stage> Window;
  std::vector<std::uint8_t> LastPicture;
  std::vector<std::int64_t> GeometryPasses; ///< of the timed frames
};

std::vector<Contestant> SetUp(const Scene& scene, const ComparisonSettings& settings)
{
  std::vector<Contestant> contestants;
  for (const std::string& method : settings.Methods)
  {
    Contestant contestant;
    contestant.Result.Method = method;
    std::unique_ptr<Method> drawing = MakeMethod(method);
    contestant.Result.Skipped = drawing->SetCoincidence(settings.Tolerance);
    contestant.Window =
      std::make_unique<Stage>(scene, std::move(drawing), settings.Size, settings.Multisamples);
    contestants.push_back(std::move(contestant));
  }
  return contestants;
}

/** Draw a frame; the first that the method does not draw itself makes its row a skipped one. */
double Draw(Contestant& contestant, vtkCamera* camera)
{
  const double milliseconds = contestant.Window->Draw(camera);
  if (contestant.Result.Skipped.empty())
  {
    contestant.Result.Skipped = contestant.Window->GetMethod().WhyNotRun();
  }
  return milliseconds;
}

/** Draw untimed frames, and learn who else cannot. */
void WarmUp(std::vector<Contestant>& contestants, vtkCamera* camera, Progress& progress)
{
  for (Contestant& contestant : contestants)
  {
    progress.Show("warming up " + contestant.Result.Method);
    for (int i = 0; i < WarmUpFrames && contestant.Result.Skipped.empty(); ++i)
    {
      Draw(contestant, camera);
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
void DrawFrame(Contestant& contestant, vtkCamera* camera)
{
  MethodResult& result = contestant.Result;
  result.FrameMilliseconds.push_back(Draw(contestant, camera));
  if (const auto passes = contestant.Window->GetMethod().Statistics().GeometryPasses)
  {
    contestant.GeometryPasses.push_back(*passes);
  }
  contestant.LastPicture = contestant.Window->ReadPixels();
  if (result.Picture.empty())
  {
    result.Picture = contestant.LastPicture;
  }
  Draw(contestant, camera);
  if (contestant.Window->ReadPixels() != contestant.LastPicture)
  {
    result.IsDeterministic = false;
  }
}

double OrbitStep(const ComparisonSettings& settings)
{
  return settings.Frames > 1 ? settings.Orbit / (settings.Frames - 1) : 0.0;
}

void DrawFrames(std::vector<Contestant>& contestants, vtkCamera* start,
  const ComparisonSettings& settings, Progress& progress)
{
  for (int frame = 0; frame < settings.Frames; ++frame)
  {
    const vtkSmartPointer<vtkCamera> camera = Orbit(start, frame * OrbitStep(settings));
    for (Contestant& contestant : contestants)
    {
      if (contestant.Result.Skipped.empty())
      {
        progress.Show("frame " + std::to_string(frame + 1) + " of " +
          std::to_string(settings.Frames) + ", " + contestant.Result.Method);
        DrawFrame(contestant, camera);
      }
    }
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

/** Compare pictures with truth's, and return truth's first; nothing if truth cannot run here. */
std::vector<std::uint8_t> Judge(std::vector<Contestant>& contestants, TruthStage& truth,
  vtkCamera* start, const ComparisonSettings& settings, Progress& progress)
{
  progress.Show("drawing truth");
  const std::unique_ptr<vitrine::Image> first = truth.Draw(start);
  const std::unique_ptr<vitrine::Image> last =
    truth.Draw(Orbit(start, (settings.Frames - 1) * OrbitStep(settings)));
  for (Contestant& contestant : contestants)
  {
    MethodResult& result = contestant.Result;
    if (!first || !last || !result.Skipped.empty())
    {
      continue;
    }
    progress.Show("judging " + result.Method);
    result.Error = Worse(vitrine::CompareImages(ToImage(result.Picture, settings.Size), *first),
      vitrine::CompareImages(ToImage(contestant.LastPicture, settings.Size), *last));
    FillIn(result.Statistics, truth.Statistics());
  }
  return first ? ToPixels(*first) : std::vector<std::uint8_t>{};
}
}

double MethodResult::Median() const
{
  return program::Median(this->FrameMilliseconds);
}

ComparisonResult CompareMethods(
  const Scene& scene, const ComparisonSettings& settings, Progress& progress)
{
  const vtkSmartPointer<vtkCamera> start =
    PlaceCamera(scene, settings.From, settings.Size.Aspect());
  std::vector<Contestant> contestants = SetUp(scene, settings);
  WarmUp(contestants, start, progress);
  DrawFrames(contestants, start, settings, progress);

  ComparisonResult comparison;
  comparison.Scene = scene.Name;
  comparison.Settings = settings;
  comparison.Advice = OpacityAdvice(scene);
  for (Contestant& contestant : contestants)
  {
    contestant.Result.Statistics = contestant.Window->GetMethod().Statistics();
    contestant.Result.Statistics.GeometryPasses = MedianPasses(contestant);
    contestant.Window.reset();
  }
  TruthStage truth(scene, settings.Size, settings.Multisamples, settings.Tolerance);
  comparison.TruthPicture = Judge(contestants, truth, start, settings, progress);
  comparison.GL = truth.GetStage().GetDevice(); // even where all methods are skipped
  for (Contestant& contestant : contestants)
  {
    comparison.Results.push_back(std::move(contestant.Result));
  }
  return comparison;
}

}
