#ifndef VITRINE_CULLING_RENDERER_VIEW_H
#define VITRINE_CULLING_RENDERER_VIEW_H

#include "Core/culling/screen/ScreenProjection.h"
#include "Core/geometry/SampleGrid.h"

#include <array>
#include <optional>

class vtkRenderer;

namespace vitrine
{

class SceneParts;

/**
 * The view that a renderer is about to draw: its camera, viewport and tile, as the mappers of the renderer use them.
 */
class RendererView
{
public:
  int Columns = 0; ///< columns of the s-buffer
  int Lines = 0;
  SampleGrid Samples;

  /**
   * Reads the view of a renderer. It needs a viewport with pixels, and a camera of the class of VTK.
   * @param mostLines  the most lines that the s-buffer may have
   */
  void Read(vtkRenderer* renderer, int mostLines, const SceneParts& parts);

  /** Returns the values that two views must share to share an s-buffer. */
  std::array<float, 5> Shape() const
  {
    return { static_cast<float>(this->Columns), static_cast<float>(this->Lines),
      this->Samples.Inset(), this->Samples.Width(), this->Samples.PixelSize() };
  }

  const ScreenProjection& Projection() const { return *this->Known; }

  /** The projection for parts that only the view hides. These may be drawn wider. */
  const ScreenProjection& ProjectionOfViewAlone() const { return *this->KnownOfViewAlone; }

private:
  std::optional<ScreenProjection> Known;
  std::optional<ScreenProjection> KnownOfViewAlone;
};

}

#endif
