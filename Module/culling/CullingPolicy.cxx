#include "culling/CullingPolicy.h"

#include "culling/SceneParts.h"
#include "scene/ClassName.h"
#include "scene/PassTraits.h"

#include "vtkCamera.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace vitrine
{

namespace
{

bool HasNoPixels(vtkRenderer* renderer)
{
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  return width < 1 || height < 1;
}

bool BlendsEdges(vtkRenderWindow* window)
{
  return window->GetLineSmoothing() || window->GetPointSmoothing() || window->GetPolygonSmoothing();
}

const std::vector<FrameRow> AllFrameRows = {
  { CullingMode::Off, "the culler is switched off (CullingOff)", "it was told to",
    [](const FrameFacts& facts) { return !facts.IsSwitchedOn; } },
  { CullingMode::Off, "a pipeline is yet to make the image of a texture (give it by SetInputData)",
    "VTK finds out what is translucent as it draws",
    [](const FrameFacts& facts) { return !facts.AreImagesMade; } },
  { CullingMode::Off, "the renderer draws shadows (UseShadows)",
    "what is hidden from the camera, or outside of its view, casts shadows",
    [](const FrameFacts& facts) { return facts.Renderer->GetUseShadows() != 0; } },
  { CullingMode::Off,
    "the renderer has both hidden line removal and ambient occlusion (UseHiddenLineRemoval, "
    "UseSSAO)",
    "VTK leaves out ambient occlusion where there is a wireframe, in the view or not",
    [](const FrameFacts& facts)
    { return facts.Renderer->GetUseHiddenLineRemoval() && facts.Renderer->GetUseSSAO(); } },
  { CullingMode::Off,
    "a render pass looks beyond the view, or its class is not known (see AddKnownPass)",
    "its picture may depend on what the camera does not see",
    [](const FrameFacts& facts)
    { return !FindPassBeyondView(facts.Renderer, facts.KnownPasses).empty(); },
    [](const FrameFacts& facts) { return FindPassBeyondView(facts.Renderer, facts.KnownPasses); } },
  { CullingMode::Off, "no render pass draws opaque geometry", "what would hide is not drawn",
    [](const FrameFacts& facts)
    { return facts.Renderer->GetPass() && !DrawsOpaqueParts(facts.Renderer->GetPass()); } },
  { CullingMode::Off, "the renderer has no camera yet", "the view is not known",
    [](const FrameFacts& facts) { return !facts.Renderer->IsActiveCameraCreated(); } },
  // The rows from here on ask for the camera, which would create it.
  { CullingMode::Off,
    "a render pass that works on the picture has a projection matrix or aspect ratio of the "
    "camera's own below it",
    "VTK draws by a copy of the camera that lacks it",
    [](const FrameFacts& facts) { return IsDrawnByAnotherCamera(facts.Renderer); } },
  { CullingMode::Off, "the class of the camera is not known",
    "it may have matrices other than those that it tells",
    [](const FrameFacts& facts)
    { return !IsExactly<vtkOpenGLCamera>(facts.Renderer->GetActiveCamera()); },
    [](const FrameFacts& facts)
    { return std::string(facts.Renderer->GetActiveCamera()->GetClassName()); } },
  { CullingMode::Off, "stereo rendering is being switched on or off",
    "the camera has yet to be told, and its matrices will change",
    [](const FrameFacts& facts)
    {
      return facts.Renderer->GetActiveCamera()->GetStereo() !=
        facts.Renderer->GetRenderWindow()->GetStereoRender();
    } },
  { CullingMode::Off, "the viewport has no pixel", "there is nothing to draw",
    [](const FrameFacts& facts) { return HasNoPixels(facts.Renderer); } },
  { CullingMode::ViewOnly, "a selector renders",
    "it draws several times, and may want what lies behind a part that cannot be picked",
    [](const FrameFacts& facts) { return facts.Renderer->GetSelector() != nullptr; } },
  { CullingMode::ViewOnly,
    "the window smooths lines, points or polygons (LineSmoothing, PointSmoothing, "
    "PolygonSmoothing)",
    "edges are blended with what was drawn before",
    [](const FrameFacts& facts) { return BlendsEdges(facts.Renderer->GetRenderWindow()); } },
  { CullingMode::ViewOnly,
    "a prop is blended among what is opaque, and may be drawn beside its bounds",
    "parts anywhere may shine through it",
    [](const FrameFacts& facts) { return facts.Parts.BlendsAnywhere(); }, nullptr,
    &SceneParts::DescribeBlended },
  { CullingMode::ViewOnly, "the renderer finds ambient occlusion (UseSSAO, vtkSSAOPass)",
    "what lies behind counts where a part in front has no normals",
    [](const FrameFacts& facts) { return FindsAmbientOcclusion(facts.Renderer); } },
  { CullingMode::AroundBlended, "a prop is blended among what is opaque",
    "parts behind it may shine through it",
    [](const FrameFacts& facts) { return facts.Parts.BlendsSomewhere(); }, nullptr,
    &SceneParts::DescribeBlended },
};

const std::vector<KeepRow> AllKeepRows = {
  { "one translucent prop", "depth is peeled (UseDepthPeeling, vtkDepthPeelingPass)",
    "without any VTK draws volumes, and the alpha of the picture, another way", true,
    [](const FrameFacts& facts) { return PeelsDepth(facts.Renderer); } },
  { "one translucent prop", "there are props that are always drawn",
    "some draw more where there is any, as vtkPolarAxesActor does", true,
    [](const FrameFacts& facts) { return facts.Parts.HasOthersThanParts(); } },
  { "one prop", "the renderer smooths or keeps the picture (UseFXAA, UseSSAO, BackingStore)",
    "VTK does so only where it draws any", false,
    [](const FrameFacts& facts) { return DoesMoreWhereAnyIsDrawn(facts.Renderer); } },
};
}

const char* NameOf(CullingMode mode)
{
  switch (mode)
  {
    case CullingMode::Off:
      return "off";
    case CullingMode::ViewOnly:
      return "view only";
    case CullingMode::AroundBlended:
      return "around blended";
    case CullingMode::Occlusion:
      break;
  }
  return "occlusion";
}

const char* EffectOf(CullingMode mode)
{
  switch (mode)
  {
    case CullingMode::Off:
      return "nothing is left out";
    case CullingMode::ViewOnly:
      return "only what lies outside of the view is left out";
    case CullingMode::AroundBlended:
      return "what may shine through is drawn";
    case CullingMode::Occlusion:
      break;
  }
  return "all that is hidden is left out";
}

const std::vector<FrameRow>& FrameRows()
{
  return AllFrameRows;
}

CullingDecision DecideFrame(const FrameFacts& facts)
{
  for (const FrameRow& row : AllFrameRows)
  {
    if (row.Applies(facts))
    {
      return { row.Mode, "", &row, row.Detail ? row.Detail(facts) : std::string(), &facts.Parts };
    }
  }
  return {};
}

std::string CullingDecision::Reason() const
{
  if (!this->Row)
  {
    return this->NoFrame;
  }
  const std::string detail =
    this->Row->PartDetail ? (this->Parts->*this->Row->PartDetail)() : this->Detail;
  return Sentence(this->Row->Condition, detail, this->Row->Why);
}

const std::vector<KeepRow>& KeepRows()
{
  return AllKeepRows;
}

std::string Sentence(const char* condition, const std::string& detail, const char* why)
{
  return condition + (detail.empty() ? std::string() : " (" + detail + ")") + ": " + why;
}

}
