#include "culling/RendererView.h"

#include "culling/ClassName.h"
#include "culling/Matrices.h"
#include "culling/RenderPasses.h"
#include "culling/SceneParts.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/gtc/matrix_transform.hpp>

namespace vitrine
{

namespace
{

// In pixels: rasterisers put corners on a grid of 1/256 of a pixel, and samples anywhere within one.
const float SnappedPixels = 1.0f / 64.0f;

// Of reversed depth: a few steps of a depth buffer of 24 bits.
const float SnappedDepth = 0x1p-21f;

/** Whether VTK draws with the matrices that the camera tells now, and nothing else. */
bool IsKnown(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return IsOfClass(camera, "vtkOpenGLCamera") &&
    camera->GetStereo() == renderer->GetRenderWindow()->GetStereoRender() &&
    ShowsTheViewAlone(renderer->GetPass());
}

/** Of passes that draw into targets of the window's size. Stencil masks have a larger one, and who knows what others have. */
bool IsOfWindowSize(vtkRenderPass* translucent)
{
  return translucent->IsA("vtkTranslucentPass") ||
    translucent->IsA("vtkOrderIndependentTranslucentPass") ||
    translucent->IsA("vtkDualDepthPeelingPass") ||
    (translucent->IsA("vtkTransparencyPass") &&
      !translucent->IsA("vtkStencilMaskTransparencyPass"));
}

bool IsSampledAtCentres(vtkRenderer* renderer)
{
  if (renderer->GetRenderWindow()->GetMultiSamples() > 1)
  {
    return false;
  }
  auto* steps = vtkRenderStepsPass::SafeDownCast(renderer->GetPass());
  return !renderer->GetPass() ||
    (steps && !steps->GetPostProcessPass() && steps->GetOpaquePass() &&
      IsOfClass(steps->GetOpaquePass(), "vtkOpaquePass") && steps->GetTranslucentPass() &&
      IsOfWindowSize(steps->GetTranslucentPass()));
}
}

bool RendererView::Read(vtkRenderer* renderer, int mostLines, const SceneParts& parts)
{
  if (!renderer->IsActiveCameraCreated() || !IsKnown(renderer))
  {
    return false;
  }
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  if (width < 1 || height < 1)
  {
    return false;
  }
  const int pixels = (height + mostLines - 1) / mostLines;
  this->Lines = (height + pixels - 1) / pixels;
  this->Columns = (width + pixels - 1) / pixels;
  this->Samples = IsSampledAtCentres(renderer) ? SampleGrid::AtCentres(pixels) : SampleGrid();

  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 toView = MatrixOf(camera->GetModelViewTransformMatrix());
  const glm::dmat4 toClip =
    MatrixOf(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1)) *
    glm::translate(toView, parts.Origin());
  const ScreenMargin snapping{ SnappedPixels / pixels, SnappedPixels / pixels, SnappedDepth };
  const glm::vec2 growth(parts.LargestGrowth() / pixels);
  this->Known.emplace(toClip, static_cast<double>(width) / pixels,
    static_cast<double>(height) / pixels, parts.Reach(), snapping, growth);
  return true;
}

}
