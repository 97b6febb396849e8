/**
 * Facts about the render passes of a renderer, for the culler, the lights and the frame.
 *
 * A pass of Vitrine states its traits in its own source file, by a PassStatement. VTK's passes are in one table
 * (PassTraits.cxx). Other classes are not known. A class derived from a known one is not known either, but is taken to
 * have its delegates.
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

/** The things that a pass does itself, besides the work of its delegates. */
struct PassTraits
{
  /** Why the picture depends on more than the camera sees, as a clause. It is empty if it does not. */
  std::string Beyond;

  bool DrawsOpaque = false;      ///< It draws opaque geometry.
  bool DrawsTranslucent = false; ///< It draws translucent polygonal geometry, and nothing else.
  /** It draws at the samples of the window's pixels, not into a target of its own. */
  bool HasWindowPixels = false;
  /** Its delegate draws into a target, and it processes that picture. */
  bool ProcessesPicture = false;

  std::vector<vtkRenderPass*> Delegates{}; ///< Passes that it hands work to, in order.
};

/** States the traits of passes of exactly one class. Define one at file scope in the source of that class. */
class PassStatement
{
public:
  using Function = PassTraits (*)(vtkRenderPass*);
  PassStatement(const char* className, Function traits);
};

/** States the traits of a class, at file scope: vitrinePassTraitsMacro(vtkMyPass, vitrine::TranslucentTraits). */
#define vitrinePassTraitsMacro(thisClass, function)                                                \
  static const vitrine::PassStatement thisClass##Traits(#thisClass, function)

/** Traits of a transparency method whose fragments are those of the window's pixels. */
PassTraits TranslucentTraits(vtkRenderPass*);

/** Traits of a transparency method that draws into a target of another size. */
PassTraits TranslucentTraitsOfOwnTarget(vtkRenderPass*);

/** Traits of a pass that lights what its delegate draws, into the delegate's pixels. */
template <class Class>
PassTraits LightsTraits(vtkRenderPass* pass)
{
  return { "", false, false, true, false, { static_cast<Class*>(pass)->GetDelegatePass() } };
}

/** Returns the traits of a pass. `Beyond` says so if its class is not known. */
PassTraits TraitsOf(vtkRenderPass* pass);

/** Returns true if `pass`, or a pass below it, is of class `className` or derived from it. */
bool HasPass(vtkRenderPass* pass, const char* className);

/** Returns true if `test` holds for `pass` and all passes below it. */
bool AllPasses(vtkRenderPass* pass, const std::function<bool(vtkRenderPass*)>& test);

/** Returns true if `pass`, or a pass below it, draws opaque geometry. */
bool DrawsOpaqueParts(vtkRenderPass* pass);

/**
 * Finds a pass of the renderer whose picture depends on more than the camera sees, or whose class is not known. Returns
 * its class and the reason, as in "vtkEDLShading depends on the bounds of all props", or an empty string.
 * @param known  the user's pass classes whose pictures depend only on what the camera sees
 */
std::string FindPassBeyondView(vtkRenderer* renderer, const std::set<std::string>& known);

/**
 * Returns true if a pass that processes the picture (vtkImageProcessingPass) draws by a copy of the camera that lacks
 * one of its settings, such as an explicit projection.
 */
bool IsDrawnByAnotherCamera(vtkRenderer* renderer);

/** Returns true if all opaque geometry is drawn at the samples of the window's pixels. */
bool HasPixelsOfWindow(vtkRenderer* renderer);

/**
 * Returns true if the renderer computes ambient occlusion (vtkSSAOPass). Positions and normals are then blended into
 * extra targets. Where the front face writes none, those of a hidden face remain.
 */
bool FindsAmbientOcclusion(vtkRenderer* renderer);

/**
 * Returns true if the renderer peels translucent geometry (vtkDepthPeelingPass). The picture's alpha and the drawing of
 * volumes then depend on whether there is translucent geometry, visible or not.
 */
bool PeelsDepth(vtkRenderer* renderer);

/** Returns true if drawing any prop makes the renderer smooth or store the whole picture. */
bool DoesMoreWhereAnyIsDrawn(vtkRenderer* renderer);

/** Returns true if the renderer draws shadow maps, by its flag or by a pass. */
bool DrawsShadows(vtkRenderer* renderer);

}

#endif
