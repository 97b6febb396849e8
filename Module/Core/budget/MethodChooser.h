/**
 * Chooses how a frame stores its fragments, so that the picture keeps an error budget at the least cost.
 *
 * Nodes are as small as the budget allows, which is known beforehand. The rest of a choice is a guess that the frame
 * itself checks. Packed lists predict their room. Lists without what hides behind others have the error of each pixel
 * bounded while they are resolved. A wrong guess costs further geometry passes in the same frame. After a wrong guess
 * the other way is taken for a number of frames that doubles each time, so that the cost of wrong guesses is a small
 * share. All is counted, not timed, so the same frames make the same choices.
 */
#ifndef VITRINE_CORE_BUDGET_METHOD_CHOOSER_H
#define VITRINE_CORE_BUDGET_METHOD_CHOOSER_H

#include "Core/budget/GuaranteedError.h"
#include "Core/budget/GuessDelay.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/** How a frame stores its fragments. */
struct FrameChoice
{
  bool IsPacked = true; ///< Packed lists with predicted room; else linked lists.
  StoredColors Colors = StoredColors::HalfFloat;
  /** Above 0, what is behind this little light is looked for, and not stored where the last frame found it. */
  double HiddenLight = 0.0;
  /** With HiddenLight, everything is stored all the same: the frame tells how much is hidden. */
  bool StoresAll = false;

  /** Returns true if pixels have their errors bounded, and a larger bound than the budget draws the frame again. */
  bool IsChecked() const { return this->HiddenLight > 0.0; }

  bool operator==(const FrameChoice& other) const
  {
    return this->IsPacked == other.IsPacked && this->Colors == other.Colors &&
      this->HiddenLight == other.HiddenLight && this->StoresAll == other.StoresAll;
  }
};

/** Returns the name of a choice as a method: "linked-list-compact" or the like. */
std::string NameOf(const FrameChoice& choice);

/** Statistics of a frame, which are counted anyway. */
struct StoredFrame
{
  std::int64_t Fragments = 0;
  std::int64_t LayersMax = 0;
  int GeometryPasses = 0;
  int Bands = 1;      ///< of the screen, in which the frame was drawn for want of memory
  bool IsCut = false; ///< Fragments behind what hides them were not stored.
  /** Fragments behind what hides them, if it was looked for and the frame is not cut. */
  std::int64_t Hidden = 0;
};

/** One way of drawing the next frame, for a plan that people read. */
struct PlannedMethod
{
  std::string Method;
  double Error = 0.0;     ///< The largest that it can have, see GuaranteedError().
  double Passes = 1.0;    ///< Geometry passes a frame, as expected from the frames so far.
  std::int64_t Bytes = 0; ///< Bytes of fragments that are written and read a frame, as expected.
  bool IsChosen = false;
  std::string Reason;
};

class MethodChooser
{
public:
  /** Choose for a frame. `budget` is at least LeastBudget. */
  FrameChoice Choose(double budget, const PictureKind& kind);

  /** Note that some pixel of a frame might exceed the budget for what was not stored. The next frame stores all. */
  void NoteExceeded();

  /** Note a finished frame of a choice. */
  void NoteFrame(const FrameChoice& choice, const StoredFrame& facts);

  /** Returns true if the budget is kept by some way of drawing pictures of the kind. */
  static bool CanKeep(double budget, const PictureKind& kind);

  /** Returns all ways of drawing the next frame, the chosen one first. */
  std::vector<PlannedMethod> Plan(double budget, const PictureKind& kind);

private:
  std::string ReasonOf(const FrameChoice& candidate, const FrameChoice& chosen, double budget,
    const PictureKind& kind) const;
  double ExpectedPasses(const FrameChoice& candidate) const;

  bool MayHide(double spare, const PictureKind& kind) const;
  void NoteHidden(const FrameChoice& choice, const StoredFrame& facts);

  GuessDelay Hiding;
  std::int64_t FragmentsUncut = 0; // Of the last frame that was not cut.
  int CutFrames = 0;               // Cut frames since then.
  GuessDelay Prediction;
  double MissedShare = 0.0; // Share of the last frames whose prediction was wrong.
  bool HasFrame = false;
  StoredFrame Last;
  FrameChoice LastChoice;
};

}
#endif
