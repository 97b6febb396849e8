/**
 * Where methods fail: every method on scenes made to break some, judged by truth.
 */
#ifndef VITRINE_STABILITY_H
#define VITRINE_STABILITY_H

#include "methods/Device.h"
#include "methods/Stage.h"
#include "study/image/ImageError.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** A scene in which some methods fail. */
struct StabilityScene
{
  std::string Name;              ///< no two are alike; in the suite short, without spaces or commas
  std::string Input;             ///< a file or demo:...
  std::optional<double> Opacity; ///< multiplied into every part's own, if any
  std::function<Scene()> Load;   ///< reads or generates it, as it is drawn
  std::string Expectation;       ///< who is exact there, what breaks whom
  bool IsQuick = false;          ///< also in a quick run
  bool IsHeavy = false;          ///< drawn but a few times, and in no other window
  std::optional<PictureSize> Size; ///< of its own; the run's without
  double ZoomBefore = 1.0;         ///< each frame follows one with that zoom
};

/** The suite of them, in the order of a table. */
std::vector<StabilityScene> StabilityScenes();

/**
 * How much a picture changes from step to step. The change of a step is the largest difference of any channel,
 * in [0, 1].
 */
struct PictureChange
{
  double Largest = 0.0; ///< of all steps
  double Typical = 0.0; ///< the median of the steps
  /** The share of pixels of which a channel changes by more than 1/255: the median of the steps. */
  double ChangedPixels = 0.0;
};

/** What a moving camera does to pictures. */
struct Flicker
{
  PictureChange Method;
  PictureChange Truth;
  /** The most by which any channel of any pixel changed in a step beyond truth's own change there, at least 0. */
  double Excess = 0.0;
  double Error = 0.0; ///< the largest difference to truth of any channel in any step
};

/** The error of a method in a window of another size or with samples. */
struct OtherWindow
{
  std::string Name; ///< "half", "double", "third", "4-samples"
  PictureSize Size{};
  int Multisamples = 0;
  std::string Skipped;   ///< why the method could not run there
  std::string NotJudged; ///< why truth could not
  std::optional<vitrine::ImageError> Error;
};

/** The largest difference to truth of any channel in frames of one kind. */
struct FrameError
{
  std::string Frames; ///< "first", "redrawn", "shift", "turn", or the name of another window
  double Error = 0.0;
};

/** What is wrong with a method on a scene; the first that holds. */
enum class StabilityOutcome
{
  Refused,        ///< it could not run
  OrderDependent, ///< frames differ that draw the same
  Flickers, ///< moved or turned, a value changes by more than truth's own and what rounding explains
  Wrong,    ///< it is off by more than LargestExactError() of its window
  Exact
};

/** One method on one scene. */
struct StabilityCell
{
  std::string Scene; ///< StabilityScene::Name
  std::string Method;
  std::string Skipped; ///< why it could not run; all but the outcome is void then
  PictureSize Size{};
  std::optional<vitrine::ImageError> Error; ///< against truth, of the scene's own view
  std::int64_t RepetitionDifference =
    0;                              ///< most 8-bit values that differ when the view is drawn again
  std::int64_t OrderDifference = 0; ///< most that differ when actors come in another order
  double RedrawnError =
    0.0;         ///< the largest difference to truth of any channel in any of those frames
  Flicker Shift; ///< the camera moves by 1/100 pixel a step
  Flicker Turn;  ///< the camera turns by one degree a step
  std::vector<OtherWindow> Others;
  std::vector<std::string>
    Messages; ///< errors and warnings of VTK, each once, other than that it cannot run
  StabilityOutcome Outcome = StabilityOutcome::Exact;
  std::string Verdict; ///< all that is wrong, in words, or "exact"; windows without truth
  std::vector<std::uint8_t> Picture;      ///< 8-bit RGB, rows from the bottom
  std::vector<std::uint8_t> TruthPicture; ///< the same, rounded

  /** The largest difference to truth of any channel in any frame of the scene's own window. */
  double OwnWindowError() const;

  /** The same of all frames, those in other windows too. */
  double WorstError() const { return this->Worst().Error; }

  /** The frames with the largest error; the first of equals. */
  FrameError Worst() const;
};

/** What is drawn, and how often. */
struct StabilitySettings
{
  std::vector<std::string> Methods;
  std::vector<StabilityScene> Scenes;
  PictureSize Size{ 64, 64 }; ///< of scenes without one of their own
  Coincidence Tolerance;      ///< of truth, and of methods that have one
  int Repetitions = 100;      ///< frames that must be alike
  int Orders = 24;            ///< of actors: all orders where there are no more, else shuffled ones
  int Shifts = 100; ///< steps of 1/100 pixel; fewer are spread over a pixel, see PlanShifts()
  int Turns = 360;  ///< steps of one degree; fewer are spread over a turn, see PlanTurns()
  bool WithOtherWindows = true;
};

/**
 * Reduce the settings to a quick run: fewer frames of each kind, and fewer scenes. Motion then has one step in each
 * quarter of a pixel and of a turn; see PlanShifts() and PlanTurns().
 */
void MakeQuick(StabilitySettings& settings);

/** What is told of cells as they are measured. */
struct StabilityListener
{
  /** Called once, before all else, with the device that draws. */
  std::function<void(const Device& device)> Opened;
  /** True if a cell is known already and not to be measured. */
  std::function<bool(const std::string& scene, const std::string& method)> IsKnown;
  /** Called before each cell. */
  std::function<void(const std::string& scene, const std::string& method)> Begins;
  /** Called with each cell that is finished. */
  std::function<void(const StabilityCell& cell)> Finished;
  /** Called after the last cell of each scene. */
  std::function<void(const StabilityScene& scene)> SceneFinished;
};

/**
 * Measure each method on each scene, scene by scene. Truth is drawn once for each scene and step. Windows are
 * shared by scenes. Any member of the listener may be empty. Throws InputError for methods that there are not,
 * RuntimeError if there is no OpenGL to draw with.
 */
void MeasureStability(const StabilitySettings& settings, const StabilityListener& listener);

}
#endif
