/**
 * Facts about a renderer's tree of render passes: what the culler, the lights and the frame have to know of each pass.
 *
 * A pass of Vitrine states its own traits in its own source, by a PassStatement. Passes of VTK stand in one table
 * (PassTraits.cxx). Nothing is known of any other class, and so nothing of one that is derived from a known one.
 */
#ifndef VITRINE_SCENE_PASS_TRAITS_H
#define VITRINE_SCENE_PASS_TRAITS_H

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkRenderPass;
class vtkRenderer;

namespace vitrine
{

/** What a pass does by itself, in frames in which it hands the rest to its delegates. */
struct PassTraits
{
  /** Why the picture depends on more than what the camera sees, as a clause; empty if it does not. */
  std::string Beyond;

  bool DrawsOpaque = false;      ///< It draws opaque geometry.
  bool DrawsTranslucent = false; ///< It draws translucent polygonal geometry, and nothing else.
  bool HasWindowPixels =
    false; ///< It draws at the samples of the window's pixels, and not into a target of its own.
  bool ProcessesPicture =
    false; ///< It draws by its delegate into a target, and works on that picture.

  std::vector<vtkRenderPass*> Delegates{}; ///< Passes that it hands work to, in their order.
};

/** States the traits of passes of exactly one class. It is made once, at file scope, in the source of that class. */
class PassStatement
{
public:
  using Function = PassTraits (*)(vtkRenderPass*);
  PassStatement(const char* className, Function traits);
};

/** States the traits of a class, at file scope: vitrinePassTraitsMacro(vtkMyPass, vitrine::TranslucentTraits). */
#define vitrinePassTraitsMacro(thisClass, function)                                                \
  static const vitrine::PassStatement thisClass##Traits(#thisClass, function)

/** A method for translucent geometry whose fragments are those of the window's pixels. */
PassTraits TranslucentTraits(vtkRenderPass*);

/** A method for translucent geometry that draws into a target of another size. */
PassTraits TranslucentTraitsOfOwnTarget(vtkRenderPass*);

/** A pass that lights what its delegate draws, into the pixels of that one. */
template <class Class>
PassTraits LightsTraits(vtkRenderPass* pass)
{
  return { "", false, false, true, false, { static_cast<Class*>(pass)->GetDelegatePass() } };
}

/** The traits of a pass; `Beyond` says so where its class is not known. */
PassTraits TraitsOf(vtkRenderPass* pass);

/** Whether `pass`, or a pass below it, is of a class or derived from it. */
bool HasPass(vtkRenderPass* pass, const char* className);

/** Whether `test` holds for `pass` and all passes below it. */
bool AllPasses(vtkRenderPass* pass, const std::function<bool(vtkRenderPass*)>& test);

/** Whether `pass`, or a pass below it, draws opaque geometry. */
bool DrawsOpaqueParts(vtkRenderPass* pass);

/**
 * Which pass of a renderer has a picture that depends on more than what the camera sees, and why, or that its class is
 * not known: "vtkEDLShading depends on the bounds of all props". Empty if there is none.
 * @param known  classes of passes of users, whose pictures do not
 */
std::string FindPassBeyondView(vtkRenderer* renderer, const std::set<std::string>& known);

/**
 * Whether passes that process the picture draw by a copy of the camera (vtkImageProcessingPass) that lacks a setting of
 * it, as an explicit projection.
 */
bool IsDrawnByAnotherCamera(vtkRenderer* renderer);

/** Whether all that is opaque is drawn at the samples of the window's pixels. */
bool HasPixelsOfWindow(vtkRenderer* renderer);

/**
 * Whether the renderer finds ambient occlusion (vtkSSAOPass). Positions and normals are then blended into targets of
 * their own, and those of a hidden face stay where the face in front has none.
 */
bool FindsAmbientOcclusion(vtkRenderer* renderer);

/**
 * Whether the renderer peels translucent geometry (vtkDepthPeelingPass). The alpha of the picture, and how volumes are
 * drawn, then depend on whether there is any, seen or not.
 */
bool PeelsDepth(vtkRenderer* renderer);

/** Whether the renderer does more in frames in which it draws any prop: it smooths or keeps the whole picture then. */
bool DoesMoreWhereAnyIsDrawn(vtkRenderer* renderer);

/** Whether the renderer draws shadow maps, by its own flag or by a pass. */
bool DrawsShadows(vtkRenderer* renderer);

}

#endif
