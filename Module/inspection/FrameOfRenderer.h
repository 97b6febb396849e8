/** The last frame that a renderer drew into its window. */
#ifndef VITRINE_INSPECTION_FRAME_OF_RENDERER_H
#define VITRINE_INSPECTION_FRAME_OF_RENDERER_H

#include "inspection/LayerCapture.h"

#include <string>
#include <vector>

class vtkRenderer;

namespace vitrine
{

class FrameOfRenderer
{
public:
  /**
   * Find the frame, and make the window's context current. Returns why there is none, or an empty string.
   */
  std::string Find(vtkRenderer* renderer);

  /** Returns a message if a corner of a rectangle is outside of the renderer's viewport, or an empty string. */
  std::string FindPixelOutside(int left, int bottom, int right, int top) const;

  /** Returns what to capture of the frame. */
  LayerCapture::Request RequestOf(const PixelRegion& pixels, bool translucent) const;

  /**
   * Append the translucent fragments of a rectangle from the lists of the frame. Returns false if there are no lists
   * with the numbers of parts, or if they are not complete. Then nothing is appended.
   */
  bool ReadLists(const PixelRegion& pixels, std::vector<LayerFragment>& fragments) const;

  int Width = 0; ///< size of the framebuffer
  int Height = 0;
  int Samples = 0; ///< samples of its pixels, 0 if it is single-sampled

private:
  vtkRenderer* Renderer = nullptr;
  PixelRegion Viewport;
  bool FixedPoint = true;
};

}

#endif
