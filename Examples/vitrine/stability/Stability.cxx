#include "stability/Stability.h"

#include "VTKMessages.h"
#include "stability/PictureChanges.h"
#include "stability/SceneTruth.h"
#include "stability/Verdict.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

namespace program
{

namespace
{
const int SamplesOfOthers = 4;

using Pixels = std::vector<std::uint8_t>;

/** A method's windows, which all scenes share. */
struct Windows
{
  std::unique_ptr<Stage> Single;
  std::unique_ptr<Stage> Multisampled;
  std::string WhyNone; ///< why the method is not to be judged by this truth at all
};

Windows OpenWindows(const std::string& name, const StabilitySettings& settings)
{
  Windows windows;
  const auto open = [&](int multisamples)
  {
    std::unique_ptr<Method> method = MakeMethod(name);
    windows.WhyNone = method->SetCoincidence(settings.Tolerance);
    return std::make_unique<Stage>(Scene(), std::move(method), settings.Size, multisamples);
  };
  windows.Single = open(0);
  windows.Multisampled = open(SamplesOfOthers);
  return windows;
}

std::int64_t CountDifferences(const Pixels& a, const Pixels& b)
{
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += a[i] != b[i];
  }
  return count;
}

/** Measures one cell. */
class CellStudy
{
public:
  CellStudy(const SceneTruth& truth, Windows& windows, const std::string& method)
    : Truth(truth)
    , Own(windows)
  {
    this->Cell.Scene = truth.Entry.Name;
    this->Cell.Method = method;
    this->Cell.Size = truth.Size;
  }

  StabilityCell Measure()
  {
    const MessageCapture messages;
    this->Cell.Skipped = this->Own.WhyNone;
    if (!this->Truth.Skipped.empty())
    {
      this->Cell.Skipped = "there is no truth to compare with: " + this->Truth.Skipped;
    }
    if (this->Cell.Skipped.empty())
    {
      this->Begin();
    }
    if (this->Cell.Skipped.empty())
    {
      this->CompareWithTruth();
      this->Repeat();
      this->Cell.Shift =
        this->Follow(this->Truth.Shifts, this->Truth.ShiftPictures, this->Truth.ShiftRun);
      this->Cell.Turn =
        this->Follow(this->Truth.Turns, this->Truth.TurnPictures, this->Truth.TurnRun);
      this->Shuffle();
      this->MeasureOtherWindows();
    }
    this->TakeMessages(messages);
    Judge(this->Cell);
    return std::move(this->Cell);
  }

private:
  void Begin()
  {
    this->Own.Single->SetScene(this->Truth.Parts);
    this->Own.Single->SetSize(this->Truth.Size);
    this->Cell.Picture = this->Draw(this->Truth.Shifts.front());
  }

  /** The first frame that the method refuses refuses the cell. */
  Pixels Draw(vtkCamera* camera)
  {
    DrawAfterZoom(*this->Own.Single, camera, this->Truth.Entry);
    if (this->Cell.Skipped.empty())
    {
      this->Cell.Skipped = this->Own.Single->GetMethod().WhyNotRun();
    }
    return this->Own.Single->ReadPixels();
  }

  /** Draw the scene's own view once more, and raise `difference` to the values that differ. */
  void DrawAgain(std::int64_t& difference)
  {
    const Pixels again = this->Draw(this->Truth.Shifts.front());
    difference = std::max(difference, CountDifferences(again, this->Cell.Picture));
    this->Cell.RedrawnError = std::max(this->Cell.RedrawnError,
      LargestDifference(ToImage(again, this->Truth.Size), this->Truth.ShiftPictures.front()));
  }

  void CompareWithTruth()
  {
    const vitrine::Image& truth = this->Truth.ShiftPictures.front();
    this->Cell.TruthPicture = ToPixels(truth);
    this->Cell.Error = vitrine::CompareImages(ToImage(this->Cell.Picture, this->Truth.Size), truth);
  }

  void Repeat()
  {
    for (int i = 1; i < this->Truth.Repetitions; ++i)
    {
      this->DrawAgain(this->Cell.RepetitionDifference);
    }
  }

  void Shuffle()
  {
    for (const std::vector<std::size_t>& order : this->Truth.Orders)
    {
      this->Own.Single->SetPartOrder(order);
      this->DrawAgain(this->Cell.OrderDifference);
    }
    std::vector<std::size_t> own(this->Truth.Parts.Parts.size());
    std::iota(own.begin(), own.end(), 0);
    this->Own.Single->SetPartOrder(own);
  }

  /** The camera goes on by steps in runs of so many frames. */
  Flicker Follow(const std::vector<vtkSmartPointer<vtkCamera>>& cameras,
    const std::vector<vitrine::Image>& truth, std::size_t run)
  {
    FlickerMeter meter;
    for (std::size_t i = 0; i < cameras.size(); ++i)
    {
      if (i % run == 0)
      {
        meter.BeginRun();
      }
      meter.Add(ToImage(this->Draw(cameras[i]), this->Truth.Size), truth[i]);
    }
    return meter.Result();
  }

  void MeasureOtherWindows()
  {
    if (!this->Truth.Others.empty())
    {
      this->Own.Multisampled->SetScene(this->Truth.Parts);
    }
    for (const OtherTruth& other : this->Truth.Others)
    {
      Stage& stage = other.Multisamples > 0 ? *this->Own.Multisampled : *this->Own.Single;
      stage.SetSize(other.Size);
      DrawAfterZoom(stage, OwnView(this->Truth.Parts, other.Size), this->Truth.Entry);
      OtherWindow window{ other.Name, other.Size, other.Multisamples, stage.GetMethod().WhyNotRun(),
        other.Skipped, std::nullopt };
      if (window.Skipped.empty() && window.NotJudged.empty())
      {
        window.Error =
          vitrine::CompareImages(ToImage(stage.ReadPixels(), other.Size), other.Picture);
      }
      this->Cell.Others.push_back(window);
    }
  }

  /** Errors and warnings, each once, but for why the method cannot run, which is told otherwise. */
  void TakeMessages(const MessageCapture& messages)
  {
    std::vector<std::string> told{ this->Cell.Skipped };
    for (const OtherWindow& other : this->Cell.Others)
    {
      told.push_back(other.Skipped);
    }
    for (const std::vector<std::string>* lines : { &messages.Errors(), &messages.Warnings() })
    {
      for (const std::string& line : LinesWithout(*lines, told))
      {
        std::vector<std::string>& kept = this->Cell.Messages;
        if (std::find(kept.begin(), kept.end(), line) == kept.end())
        {
          kept.push_back(line);
        }
      }
    }
  }

  const SceneTruth& Truth;
  Windows& Own;
  StabilityCell Cell;
};

std::vector<std::string> UnknownMethods(
  const StabilityScene& scene, const StabilitySettings& settings, const StabilityListener& listener)
{
  std::vector<std::string> unknown;
  for (const std::string& method : settings.Methods)
  {
    if (!listener.IsKnown || !listener.IsKnown(scene.Name, method))
    {
      unknown.push_back(method);
    }
  }
  return unknown;
}
}

void MakeQuick(StabilitySettings& settings)
{
  settings.Repetitions = 3;
  settings.Orders = 3;
  settings.Shifts = 4;
  settings.Turns = 4;
  settings.Scenes.erase(std::remove_if(settings.Scenes.begin(), settings.Scenes.end(),
                          [](const StabilityScene& scene) { return !scene.IsQuick; }),
    settings.Scenes.end());
}

void MeasureStability(const StabilitySettings& settings, const StabilityListener& listener)
{
  const Scene nothing;
  TruthStage single(nothing, settings.Size, 0, settings.Tolerance);
  TruthStage multisampled(nothing, settings.Size, SamplesOfOthers, settings.Tolerance);
  if (listener.Opened)
  {
    single.Draw(vtkNew<vtkCamera>()); // the device is known once something is drawn
    listener.Opened(single.GetStage().GetDevice());
  }
  std::map<std::string, Windows> windows;
  for (const StabilityScene& scene : settings.Scenes)
  {
    const std::vector<std::string> methods = UnknownMethods(scene, settings, listener);
    if (methods.empty())
    {
      continue;
    }
    const auto begins = [&](const std::string& method)
    {
      if (listener.Begins)
      {
        listener.Begins(scene.Name, method);
      }
    };
    begins("truth");
    const SceneTruth truth = DrawTruth(scene, settings, single, multisampled);
    for (const std::string& method : methods)
    {
      begins(method);
      const auto [place, isNew] = windows.try_emplace(method);
      if (isNew)
      {
        place->second = OpenWindows(method, settings);
      }
      const StabilityCell cell = CellStudy(truth, place->second, method).Measure();
      if (listener.Finished)
      {
        listener.Finished(cell);
      }
    }
    if (listener.SceneFinished)
    {
      listener.SceneFinished(scene);
    }
  }
}

}
