/**
 * The rules of the culler for a frame, as a table: what keeps it from leaving out all that is hidden, and why.
 *
 * The rules for single props stand in PropPolicy.h.
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

/** What may be left out of a frame: each mode leaves out more than the ones before it. */
enum class CullingMode
{
  Off,           ///< Nothing is left out.
  ViewOnly,      ///< Parts outside of the view are left out.
  AroundBlended, ///< Hidden parts are, too, but for those that may shine through what is blended.
  Occlusion      ///< All parts that are outside of the view or hidden are left out.
};

/** The mode in words, as "view only". */
const char* NameOf(CullingMode mode);

/** What the mode does, as a clause: "only what lies outside of the view is left out". */
const char* EffectOf(CullingMode mode);

/** What is left out of a frame. */
struct CullingDecision
{
  CullingMode Mode = CullingMode::Occlusion;
  std::string Reason; ///< why it is not Occlusion; empty if it is
};

/** What is known of a frame before anything is left out. */
struct FrameFacts
{
  vtkRenderer* Renderer;
  const std::set<std::string>& KnownPasses; ///< classes that users have named
  const SceneParts& Parts;                  ///< up to date where AreImagesMade
  bool IsSwitchedOn;                        ///< vtkHierarchicalSBufferCuller::GetCulling()
  bool AreImagesMade;                       ///< as SceneParts::Update() says
};

/** A rule for frames. It is asked only where no row above it applies. */
struct FrameRow
{
  CullingMode Mode;      ///< at most
  const char* Condition; ///< where it applies, as a clause
  const char* Why;       ///< as a clause
  bool (*Applies)(const FrameFacts&);
  std::string (*Detail)(const FrameFacts&) = nullptr; ///< what it is that applies, as a class
};

/** All rules for frames, those that leave out least first. */
const std::vector<FrameRow>& FrameRows();

/** The first row that applies decides. */
CullingDecision DecideFrame(const FrameFacts& facts);

/** A rule for what is drawn besides, so that VTK draws the rest as it does where nothing is left out. */
struct KeepRow
{
  const char* Kept; ///< "one translucent prop" or "one prop"
  const char* Condition;
  const char* Why;
  bool IsForTranslucent; ///< It keeps a prop that is translucent, and not just any.
  bool (*Applies)(const FrameFacts&);
};

/** All of them, in the order in which they are applied. */
const std::vector<KeepRow>& KeepRows();

/** A rule in words: "condition (detail): why". */
std::string Sentence(const char* condition, const std::string& detail, const char* why);

}

#endif
