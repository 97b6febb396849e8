#include "culling/RendererView.h"

#include "culling/SceneParts.h"
#include "gl/Capabilities.h"
#include "scene/Matrices.h"
#include "scene/PassTraits.h"
#include "scene/ViewMatrices.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

/** Returns by how many pixels the rasteriser of the window may move corners. */
float SnappedPixelsOf(vtkRenderer* renderer)
{
  const int bits = renderer->GetRenderWindow()->IsCurrent() ? SubpixelBits() : LeastSubpixelBits;
  return std::ldexp(SnappedSteps, -std::clamp(bits, LeastSubpixelBits, MostSubpixelBits));
}

/** The size of lines and columns of an s-buffer, and the sample positions in them. */
struct LineScale
{
  double Pixels; ///< pixels per line, and per column
  SampleGrid Samples;
};

/** Returns the pixels per line for which there are at most `mostLines` lines. */
int PixelsPerLine(int mostLines, int height)
{
  return (height + mostLines - 1) / mostLines;
}

/**
 * Returns the cells per line for which there are at most `mostLines` lines, if each pixel is cut into `cells` cells
 * across. No line holds parts of several pixels.
 */
int CellsPerLine(int cells, int mostLines, int height)
{
  int ofLine = 1;
  while (ofLine < cells && height * cells > mostLines * ofLine)
  {
    ofLine *= 2;
  }
  return ofLine < cells ? ofLine : cells * PixelsPerLine(mostLines, height);
}

/**
 * Finds the scale of a view. Passes may draw translucent props at the centres of pixels with several samples.
 * HiddenVerifier takes care of that.
 */
LineScale ScaleOf(vtkRenderer* renderer, int mostLines, int height)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const int pixels = PixelsPerLine(mostLines, height);
  const bool hasPixels = HasPixelsOfWindow(renderer);
  if (hasPixels && window->GetMultiSamples() <= 1)
  {
    return { static_cast<double>(pixels), SampleGrid::AtCentres(pixels) };
  }
  const int cells = hasPixels && window->IsCurrent() ? SampleCells() : 0;
  if (cells == 0)
  {
    return { static_cast<double>(pixels), SampleGrid() };
  }
  const int ofLine = CellsPerLine(cells, mostLines, height);
  return { static_cast<double>(ofLine) / cells, SampleGrid::InCells(ofLine, cells) };
}
}

void RendererView::Read(vtkRenderer* renderer, int mostLines, const SceneParts& parts)
{
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const LineScale scale = ScaleOf(renderer, mostLines, height);
  this->Lines = static_cast<int>(std::ceil(height / scale.Pixels));
  this->Columns = static_cast<int>(std::ceil(width / scale.Pixels));
  this->Samples = scale.Samples;

  const ViewMatrices matrices = ViewMatricesOf(renderer);
  const glm::dmat4 toView = MatrixOf(matrices.data());
  const glm::dmat4 toClip = MatrixOf(matrices.data() + 16) * glm::translate(toView, parts.Origin());
  const float snapped = SnappedPixelsOf(renderer);
  const auto pixels = static_cast<float>(scale.Pixels);
  const ScreenMargin snapping{ (snapped + RoundingOfPlaces * static_cast<float>(left + width)) /
      pixels,
    (snapped + RoundingOfPlaces * static_cast<float>(bottom + height)) / pixels, SnappedDepth };
  const glm::vec2 before = glm::vec2(left, bottom) / pixels;
  const auto projectionOf = [&](const SceneParts::Extremes& all)
  {
    return ScreenProjection(toClip, width / scale.Pixels, height / scale.Pixels, all.Reach,
      snapping, glm::vec2(all.Growth / pixels), before);
  };
  this->Known.emplace(projectionOf(parts.OfHideable()));
  this->KnownOfViewAlone.emplace(projectionOf(parts.OfViewAlone()));
}

}
