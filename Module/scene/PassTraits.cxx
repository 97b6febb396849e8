#include "scene/PassTraits.h"

#include "scene/ClassName.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkClearZPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkEDLShading.h"
#include "vtkGaussianBlurPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkLightsPass.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkPanoramicProjectionPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSimpleMotionBlurPass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <algorithm>
#include <mutex>
#include <typeindex>
#include <unordered_map>
#include <utility>

namespace vitrine
{

namespace
{

using Passes = std::vector<vtkRenderPass*>;

Passes NoDelegates(vtkRenderPass*)
{
  return {};
}

template <class Class>
Passes DelegateOf(vtkRenderPass* pass)
{
  return { static_cast<Class*>(pass)->GetDelegatePass() };
}

Passes PassesOf(vtkSequencePass* sequence)
{
  Passes passes;
  vtkRenderPassCollection* const collection = sequence->GetPasses();
  for (int i = 0; collection && i < collection->GetNumberOfItems(); ++i)
  {
    passes.push_back(static_cast<vtkRenderPass*>(collection->GetItemAsObject(i)));
  }
  return passes;
}

/** Traits of a class of VTK's passes. Passes of derived classes are taken to have its delegates. */
struct Row
{
  bool (*IsOf)(vtkRenderPass*); ///< Tests for this class and derived ones.
  bool (*IsExactly)(vtkRenderPass*);
  PassTraits Traits; ///< Its Delegates are empty.
  Passes (*Delegates)(vtkRenderPass*);
};

const bool Opaque = true;
const bool Translucent = true;
const bool OfWindow = true;
const bool Picture = true;

template <class Class>
Row RowOf(PassTraits traits, Passes (*delegates)(vtkRenderPass*) = NoDelegates)
{
  return { [](vtkRenderPass* pass) { return Class::SafeDownCast(pass) != nullptr; },
    [](vtkRenderPass* pass) { return IsExactly<Class>(pass); }, std::move(traits), delegates };
}

/** A pass that processes the picture of its delegate. */
template <class Class>
Row Processing(const char* beyond = "")
{
  return RowOf<Class>({ beyond, !Opaque, !Translucent, !OfWindow, Picture }, DelegateOf<Class>);
}

/** The rows for VTK's classes. Derived classes come before their base classes. */
const std::vector<Row>& RowsOfVTK()
{
  const auto one = [](bool opaque, bool translucent) {
    return PassTraits{ "", opaque, translucent, OfWindow, !Picture };
  };
  static const std::vector<Row> rows = {
    Processing<vtkDepthOfFieldPass>("blurs what lies beside the view"),
    Processing<vtkEDLShading>("depends on the bounds of all props"),
    Processing<vtkGaussianBlurPass>("blurs what lies beside the view"),
    Processing<vtkOpenGLFXAAPass>(),
    Processing<vtkPanoramicProjectionPass>("looks all around"),
    Processing<vtkSSAAPass>(),
    Processing<vtkSSAOPass>(),
    Processing<vtkSimpleMotionBlurPass>("depends on frames before"),
    Processing<vtkSobelGradientMagnitudePass>("looks beside the view"),
    Processing<vtkToneMappingPass>(),
    Processing<vtkImageProcessingPass>("is not known"),
    RowOf<vtkCameraPass>(one(!Opaque, !Translucent), DelegateOf<vtkCameraPass>),
    RowOf<vtkSequencePass>(one(!Opaque, !Translucent),
      [](vtkRenderPass* pass) { return PassesOf(static_cast<vtkSequencePass*>(pass)); }),
    RowOf<vtkRenderStepsPass>(one(!Opaque, !Translucent),
      [](vtkRenderPass* pass)
      {
        auto* const steps = static_cast<vtkRenderStepsPass*>(pass);
        return Passes{ steps->GetOpaquePass(), steps->GetTranslucentPass(),
          steps->GetPostProcessPass() };
      }),
    RowOf<vtkTranslucentPass>(one(!Opaque, Translucent)),
    RowOf<vtkOrderIndependentTranslucentPass>(one(!Opaque, Translucent)),
    RowOf<vtkDualDepthPeelingPass>(one(!Opaque, Translucent),
      [](vtkRenderPass* pass)
      { return Passes{ static_cast<vtkDualDepthPeelingPass*>(pass)->GetVolumetricPass() }; }),
    RowOf<vtkDepthPeelingPass>({ "", !Opaque, Translucent, !OfWindow, !Picture }),
    RowOf<vtkVolumetricPass>(one(!Opaque, !Translucent)),
    RowOf<vtkOverlayPass>(one(!Opaque, !Translucent)),
    RowOf<vtkLightsPass>(one(!Opaque, !Translucent)),
    RowOf<vtkOpaquePass>(one(Opaque, !Translucent)),
    RowOf<vtkDefaultPass>(one(Opaque, !Translucent)),
    RowOf<vtkShadowMapBakerPass>(
      { "draws what the lights see", !Opaque, !Translucent, !OfWindow, !Picture }),
    RowOf<vtkShadowMapPass>(
      { "draws shadows of what the lights see", Opaque, !Translucent, OfWindow, !Picture },
      [](vtkRenderPass* pass)
      { return Passes{ static_cast<vtkShadowMapPass*>(pass)->GetOpaqueSequence() }; }),
    RowOf<vtkClearZPass>({ "clears depths", !Opaque, !Translucent, OfWindow, !Picture }),
  };
  return rows;
}

/** The traits that Vitrine's passes have stated, by class name. */
std::vector<std::pair<std::string, PassStatement::Function>>& Statements()
{
  static std::vector<std::pair<std::string, PassStatement::Function>> statements;
  return statements;
}

const char* const IsNotKnown = "is of a class that is not known";

/** Where the traits of all passes of one C++ type come from. */
struct Origin
{
  PassStatement::Function Stated = nullptr; ///< null where no class of Vitrine has stated them
  const Row* OfVTK = nullptr; ///< null where VTK's table does not have the class either
  bool IsExact = false;       ///< It is that class, and not one derived from it.
};

Origin FindStated(vtkRenderPass* pass)
{
  Origin derived;
  for (const auto& [name, traits] : Statements())
  {
    if (IsExactlyOfClass(pass, name))
    {
      return { traits, nullptr, true };
    }
    if (!derived.Stated && pass->IsA(name.c_str()))
    {
      derived.Stated = traits;
    }
  }
  return derived;
}

Origin FindOrigin(vtkRenderPass* pass)
{
  const Origin stated = FindStated(pass);
  if (stated.Stated)
  {
    return stated;
  }
  for (const Row& row : RowsOfVTK())
  {
    if (row.IsOf(pass))
    {
      return { nullptr, &row, row.IsExactly(pass) };
    }
  }
  return {};
}

/** Looks the origin up once for each type: names of classes are compared, and a frame asks many times. */
Origin OriginOf(vtkRenderPass* pass)
{
  static std::mutex access;
  static std::unordered_map<std::type_index, Origin> known;
  const std::lock_guard<std::mutex> lock(access);
  const auto [entry, isNew] = known.try_emplace(typeid(*pass));
  if (isNew)
  {
    entry->second = FindOrigin(pass);
  }
  return entry->second;
}

PassTraits FindTraits(vtkRenderPass* pass, const Origin& origin)
{
  if (origin.Stated)
  {
    return origin.Stated(pass);
  }
  if (!origin.OfVTK)
  {
    // An unknown pass may draw anything.
    return { IsNotKnown, Opaque, !Translucent, !OfWindow, !Picture };
  }
  PassTraits traits = origin.OfVTK->Traits;
  traits.Delegates = origin.OfVTK->Delegates(pass);
  return traits;
}

void AddWithDelegates(vtkRenderPass* pass, Passes& all)
{
  // Chains may be cyclic while a frame is drawn.
  if (std::find(all.begin(), all.end(), pass) == all.end())
  {
    all.push_back(pass);
    for (vtkRenderPass* const below : TraitsOf(pass).Delegates)
    {
      AddWithDelegates(below, all);
    }
  }
}

/** Returns a pass and all passes below it. */
Passes WithDelegates(vtkRenderPass* pass)
{
  Passes all;
  AddWithDelegates(pass, all);
  return all;
}
}

PassStatement::PassStatement(const char* className, Function traits)
{
  Statements().emplace_back(className, traits);
}

PassTraits TranslucentTraits(vtkRenderPass*)
{
  return { "", !Opaque, Translucent, OfWindow, !Picture };
}

PassTraits TranslucentTraitsOfOwnTarget(vtkRenderPass*)
{
  return { "", !Opaque, Translucent, !OfWindow, !Picture };
}

PassTraits TraitsOf(vtkRenderPass* pass)
{
  const Origin origin = OriginOf(pass);
  PassTraits traits = FindTraits(pass, origin);
  if (!origin.IsExact)
  {
    traits.Beyond = IsNotKnown;
  }
  Passes& delegates = traits.Delegates;
  delegates.erase(std::remove(delegates.begin(), delegates.end(), nullptr), delegates.end());
  return traits;
}

bool AllPasses(vtkRenderPass* pass, const std::function<bool(vtkRenderPass*)>& test)
{
  const Passes all = WithDelegates(pass);
  return std::all_of(all.begin(), all.end(), test);
}

bool HasPass(vtkRenderPass* pass, const char* className)
{
  return !AllPasses(pass, [className](vtkRenderPass* one) { return !one->IsA(className); });
}

bool DrawsOpaqueParts(vtkRenderPass* pass)
{
  return !AllPasses(pass, [](vtkRenderPass* one) { return !TraitsOf(one).DrawsOpaque; });
}

std::string FindPassBeyondView(vtkRenderer* renderer, const std::set<std::string>& known)
{
  vtkRenderPass* const root = renderer->GetPass();
  for (vtkRenderPass* const pass : root ? WithDelegates(root) : Passes())
  {
    const std::string beyond = TraitsOf(pass).Beyond;
    const bool isUsers = std::any_of(known.begin(), known.end(),
      [pass](const std::string& name) { return IsOfClass(pass, name.c_str()); });
    if (!beyond.empty() && !isUsers)
    {
      return std::string(pass->GetClassName()) + " " + beyond;
    }
  }
  return {};
}

bool IsDrawnByAnotherCamera(vtkRenderer* renderer)
{
  if (!renderer->GetPass() || !HasPass(renderer->GetPass(), "vtkImageProcessingPass"))
  {
    return false;
  }
  vtkCamera* const camera = renderer->GetActiveCamera();
  vtkNew<vtkCamera> copy;
  copy->DeepCopy(camera);
  const double aspect = renderer->GetTiledAspectRatio();
  const auto* own = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  const auto* copied = copy->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  return !std::equal(own->GetData(), own->GetData() + 16, copied->GetData());
}

bool HasPixelsOfWindow(vtkRenderer* renderer)
{
  vtkRenderPass* const pass = renderer->GetPass();
  return !pass || AllPasses(pass, [](vtkRenderPass* one) { return TraitsOf(one).HasWindowPixels; });
}

bool FindsAmbientOcclusion(vtkRenderer* renderer)
{
  return renderer->GetUseSSAO() ||
    (renderer->GetPass() && HasPass(renderer->GetPass(), "vtkSSAOPass"));
}

bool PeelsDepth(vtkRenderer* renderer)
{
  return renderer->GetUseDepthPeeling() ||
    (renderer->GetPass() && HasPass(renderer->GetPass(), "vtkDepthPeelingPass"));
}

bool DoesMoreWhereAnyIsDrawn(vtkRenderer* renderer)
{
  return renderer->GetUseFXAA() || renderer->GetUseSSAO() || renderer->GetBackingStore();
}

bool DrawsShadows(vtkRenderer* renderer)
{
  return renderer->GetUseShadows() ||
    (renderer->GetPass() && HasPass(renderer->GetPass(), "vtkShadowMapPass"));
}

}
