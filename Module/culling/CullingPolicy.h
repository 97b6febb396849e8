/**
 * The rules of the culler for a frame, as a table: what keeps it from leaving out all hidden parts, and why.
 *
 * The rules for single props are in PropPolicy.h.
 */
#ifndef VITRINE_CULLING_CULLING_POLICY_H
#define VITRINE_CULLING_CULLING_POLICY_H

#include <set>
#include <string>
#include <vector>

class vtkRenderer;

namespace vitrine
{

class SceneParts;

/** The modes of culling a frame. Each mode leaves out more than the ones before it. */
enum class CullingMode
{
  Off,           ///< Nothing is left out.
  ViewOnly,      ///< Parts outside of the view are left out.
  AroundBlended, ///< Hidden parts are left out, too, unless they may shine through a blended prop.
  Occlusion      ///< All parts that are outside of the view or hidden are left out.
};

/** Returns the name of the mode, as "view only". */
const char* NameOf(CullingMode mode);

/** Returns the effect of the mode as a clause, as "only what lies outside of the view is left out". */
const char* EffectOf(CullingMode mode);

/** The facts that the rules for a frame look at. */
struct FrameFacts
{
  vtkRenderer* Renderer;
  const std::set<std::string>& KnownPasses; ///< classes of passes that the user has named
  const SceneParts& Parts;                  ///< up to date if IsSwitchedOn and AreImagesMade
  bool IsSwitchedOn;                        ///< vtkHierarchicalSBufferCuller::GetCulling()
  bool AreImagesMade; ///< what SceneParts::Update() returned; true if switched off
};

/** A rule for frames. It is asked only if no row above it applies. */
struct FrameRow
{
  CullingMode Mode;      ///< the mode may not exceed this one
  const char* Condition; ///< where the rule applies, as a clause
  const char* Why;       ///< the reason, as a clause
  bool (*Applies)(const FrameFacts&);
  /** Returns the name of the class that the rule found. */
  std::string (*Detail)(const FrameFacts&) = nullptr;
  /** Returns what the rule found among the parts. It is called when the reason is asked for, and not in the frame. */
  std::string (SceneParts::*PartDetail)() const = nullptr;
};

/** Returns all rules for frames. Those that leave out least come first. */
const std::vector<FrameRow>& FrameRows();

/** The mode of a frame, and what its reason is made from. */
struct CullingDecision
{
  CullingMode Mode = CullingMode::Occlusion;
  const char* NoFrame = ""; ///< The reason if no row decided. It is empty if the mode is Occlusion.
  const FrameRow* Row = nullptr; ///< the row that decided
  std::string Detail{};          ///< the result of the row's Detail, found in the frame
  const SceneParts* Parts =
    nullptr; ///< for the row's PartDetail; it must live until the next decision

  /** Returns in words why the mode is not Occlusion. It is empty if the mode is Occlusion. */
  std::string Reason() const;
};

/** Decides what may be left out of a frame. The first row that applies decides. */
CullingDecision DecideFrame(const FrameFacts& facts);

/** A rule for a prop that is drawn though it is hidden, so that VTK draws the rest as if nothing was left out. */
struct KeepRow
{
  const char* Kept; ///< what is kept: "one translucent prop" or "one prop"
  const char* Condition;
  const char* Why;
  bool IsForTranslucent; ///< The rule keeps a translucent prop. Otherwise it keeps any prop.
  bool (*Applies)(const FrameFacts&);
};

/** Returns all rules of this kind, in the order in which they are applied. */
const std::vector<KeepRow>& KeepRows();

/** Returns a rule in words: "condition (detail): why". */
std::string Sentence(const char* condition, const std::string& detail, const char* why);

}

#endif
