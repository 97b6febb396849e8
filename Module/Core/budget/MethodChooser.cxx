#include "Core/budget/MethodChooser.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vitrine
{
namespace
{

// Linked lists take about a tenth longer than packed lists, and a wrong prediction a second pass.
constexpr double MostMisses = 0.12;
constexpr double WeightOfLastFrame = 0.1;
// Light that can be spared, and layers from which on something may hide behind it.
constexpr double LeastLight = 0.2 / 255.0;
constexpr int LeastLayersThatHide = 8;
// Depths are looked for where a 16th of the light that can be spared passes: the picture may move.
constexpr double ReserveOfLight = 1.0 / 16.0;
// At least this share of the fragments must be hidden. A frame that is not cut tells how many are, and after so many
// cut frames their own fragments tell. After more of them it is asked again, as the view may be another one.
constexpr double LeastHidden = 0.15;
constexpr int CutFramesOfTrial = 3;
constexpr int CutFramesUntilAsked = 256;

// A link of 4 bytes serves a page of up to 8 nodes.
constexpr int LinkBytes = 1;

std::string InSteps(double error)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f/255", 255.0 * error);
  return text;
}

int NodeBytes(StoredColors colors)
{
  return colors == StoredColors::Compact ? 8 : 12;
}

}

//------------------------------------------------------------------------------
std::string NameOf(const FrameChoice& choice)
{
  return std::string(choice.IsPacked ? "prefix-sum-predicted" : "linked-list") +
    (choice.Colors == StoredColors::Compact ? "-compact" : "");
}

//------------------------------------------------------------------------------
bool MethodChooser::CanKeep(double budget, const PictureKind& kind)
{
  return GuaranteedError(StoredColors::HalfFloat, kind) <= budget;
}

//------------------------------------------------------------------------------
FrameChoice MethodChooser::Choose(double budget, const PictureKind& kind)
{
  FrameChoice choice;
  const bool isCompact = GuaranteedError(StoredColors::Compact, kind) <= budget;
  choice.Colors = isCompact ? StoredColors::Compact : StoredColors::HalfFloat;
  const double spare = budget - GuaranteedError(choice.Colors, kind);
  choice.HiddenLight = this->MayHide(spare, kind) ? ReserveOfLight * spare : 0.0;
  choice.StoresAll = choice.HiddenLight > 0.0 && this->CutFrames >= CutFramesUntilAsked;
  choice.IsPacked = this->Prediction.IsOver() && this->Last.Bands == 1;
  return choice;
}

//------------------------------------------------------------------------------
// The depths of the last frame that hide what is behind are worth their cost in deep pixels.
bool MethodChooser::MayHide(double spare, const PictureKind& kind) const
{
  return kind.HasBoundsOfPixels() && !kind.KeepsAll && this->Hiding.IsOver() && this->HasFrame &&
    this->Last.Bands == 1 && (this->Last.IsCut || this->Last.LayersMax >= LeastLayersThatHide) &&
    spare >= LeastLight;
}

//------------------------------------------------------------------------------
void MethodChooser::NoteExceeded()
{
  this->Hiding.Begin();
}

//------------------------------------------------------------------------------
void MethodChooser::NoteFrame(const FrameChoice& choice, const StoredFrame& facts)
{
  this->Prediction.CountFrame();
  this->Hiding.CountFrame();
  this->NoteHidden(choice, facts);
  const bool isLikeLast =
    this->HasFrame && choice == this->LastChoice && facts.IsCut == this->Last.IsCut;
  if (choice.IsPacked && !this->LastChoice.IsPacked)
  {
    this->MissedShare = 0.0;
  }
  if (choice.IsPacked && isLikeLast && facts.Bands == 1)
  {
    const double missed = facts.GeometryPasses > 1 ? 1.0 : 0.0;
    this->MissedShare += WeightOfLastFrame * (missed - this->MissedShare);
    if (this->MissedShare > MostMisses)
    {
      this->Prediction.Begin();
    }
  }
  this->Last = facts;
  this->LastChoice = choice;
  this->HasFrame = true;
}

//------------------------------------------------------------------------------
// Cuts that are made for a moving camera are wider, so they hide less than the frame before them tells.
void MethodChooser::NoteHidden(const FrameChoice& choice, const StoredFrame& facts)
{
  bool hidesEnough = true;
  if (!facts.IsCut)
  {
    this->FragmentsUncut = facts.Fragments;
    this->CutFrames = 0;
    hidesEnough = choice.HiddenLight <= 0.0 ||
      static_cast<double>(facts.Hidden) >= LeastHidden * static_cast<double>(facts.Fragments);
  }
  else if (++this->CutFrames == CutFramesOfTrial)
  {
    hidesEnough = static_cast<double>(facts.Fragments) <=
      (1.0 - LeastHidden) * static_cast<double>(this->FragmentsUncut);
  }
  if (!hidesEnough)
  {
    this->Hiding.Begin();
  }
}

//------------------------------------------------------------------------------
std::vector<PlannedMethod> MethodChooser::Plan(double budget, const PictureKind& kind)
{
  const FrameChoice chosen = this->Choose(budget, kind);
  std::vector<PlannedMethod> plan;
  for (const bool isPacked : { true, false })
  {
    for (const StoredColors colors : { StoredColors::Compact, StoredColors::HalfFloat })
    {
      const FrameChoice candidate{ isPacked, colors,
        colors == chosen.Colors ? chosen.HiddenLight : 0.0,
        colors == chosen.Colors && chosen.StoresAll };
      PlannedMethod method;
      method.Method = NameOf(candidate);
      method.Error = GuaranteedError(colors, kind);
      method.Passes = this->ExpectedPasses(candidate);
      // Each fragment is written and read once.
      method.Bytes = 2 * this->Last.Fragments * (NodeBytes(colors) + (isPacked ? 0 : LinkBytes));
      method.IsChosen = candidate == chosen;
      method.Reason = this->ReasonOf(candidate, chosen, budget, kind);
      plan.push_back(method);
    }
  }
  std::stable_partition(
    plan.begin(), plan.end(), [](const PlannedMethod& method) { return method.IsChosen; });
  return plan;
}

//------------------------------------------------------------------------------
double MethodChooser::ExpectedPasses(const FrameChoice& candidate) const
{
  return candidate.IsPacked ? 1.0 + this->MissedShare : 1.0;
}

//------------------------------------------------------------------------------
std::string MethodChooser::ReasonOf(const FrameChoice& candidate, const FrameChoice& chosen,
  double budget, const PictureKind& kind) const
{
  if (candidate.Colors == StoredColors::Compact && chosen.Colors != StoredColors::Compact)
  {
    return std::isinf(GuaranteedError(StoredColors::Compact, kind))
      ? "the error of compact nodes is not bounded in such pictures"
      : "its error may exceed " + InSteps(budget);
  }
  if (candidate.Colors != chosen.Colors)
  {
    return "a node has 12 bytes, not 8";
  }
  if (candidate.IsPacked && !chosen.IsPacked)
  {
    return this->Last.Bands > 1 ? "memory is short: bands of packed lists take one more pass"
                                : "the camera moves too fast to predict room";
  }
  if (candidate.IsPacked != chosen.IsPacked)
  {
    return "links take memory and time, and predicted room suffices";
  }
  return !CanKeep(budget, kind) ? "nothing keeps the budget here; this is the nearest to it"
    : candidate.HiddenLight > 0.0
    ? "the cheapest that keeps " + InSteps(budget) +
      ": what is hidden behind others is not stored; the bound of each pixel is checked in each "
      "frame"
    : "the cheapest that keeps " + InSteps(budget) + " for all pixels";
}

}
