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

/** What a renderer is about to show: of its eye, viewport and tile, as its mappers will draw it. */
class RendererView
{
public:
  int Columns = 0; ///< of the s-buffer
  int Lines = 0;
  SampleGrid Samples;

  /**
   * Reads the view of a renderer that has pixels, and a camera of VTK's own class.
   * @param mostLines  of the s-buffer
   */
  void Read(vtkRenderer* renderer, int mostLines, const SceneParts& parts);

  /** What an s-buffer for the view differs by from others. */
  std::array<float, 5> Shape() const
  {
    return { static_cast<float>(this->Columns), static_cast<float>(this->Lines),
      this->Samples.Inset(), this->Samples.Width(), this->Samples.PixelSize() };
  }

  const ScreenProjection& Projection() const { return *this->Known; }

  /** The same for parts that the view alone hides, which may be drawn wider. */
  const ScreenProjection& ProjectionOfViewAlone() const { return *this->KnownOfViewAlone; }

private:
  std::optional<ScreenProjection> Known;
  std::optional<ScreenProjection> KnownOfViewAlone;
};

}

#endif
