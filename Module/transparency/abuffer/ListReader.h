/** Reads the lists of a frame back, after it was drawn. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_READER_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_READER_H

#include "Core/geometry/PixelRegion.h"
#include "Core/lists/PixelLayers.h"
#include "gl/ComputeProgram.h"
#include "gl/GLObjects.h"
#include "scene/ViewMatrices.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace vitrine
{

class FragmentStore;
struct ListLayout;
struct RenderTarget;

/** The size of a framebuffer, and the samples of its pixels, 0 if it is single-sampled. */
struct FrameSize
{
  int Width = 0;
  int Height = 0;
  int Samples = 0;

  bool operator==(const FrameSize& other) const
  {
    return this->Width == other.Width && this->Height == other.Height &&
      this->Samples == other.Samples;
  }
};

class ListReader
{
public:
  ListReader();

  /** Note that the store has all lists of a frame, with the numbers of parts. */
  void Note(vtkRenderer* renderer, const RenderTarget& target, const FragmentStore& store);

  /** Forget the frame, since its lists are about to change. */
  void Forget() { this->Drawn = nullptr; }

  /**
   * Append the fragments of a rectangle of pixels. Returns false, and appends nothing, if the store does not have lists
   * of such a frame of the renderer any more, if its camera has another view
   * now, or if the driver fails. Keeps OpenGL's state.
   */
  bool Read(vtkOpenGLRenderWindow* window, vtkRenderer* renderer, const FrameSize& size,
    const ListLayout& layout, FragmentStore& store, const PixelRegion& pixels,
    std::vector<LayerFragment>& fragments);

  void Release();

private:
  bool Run(vtkOpenGLRenderWindow* window, const ListLayout& layout, FragmentStore& store,
    const PixelRegion& pixels);

  const void* Drawn = nullptr; ///< The renderer. It is not dereferenced.
  FrameSize Size;
  PixelRegion Region;
  ViewMatrices Matrices{}; ///< with which the lists were drawn
  std::uint64_t NodesNumber = 0;
  ComputeProgram Program;
  Buffer Counter;
  Buffer Fragments;
};

}
#endif
