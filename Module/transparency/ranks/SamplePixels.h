/** The samples of a multisampled render target on the CPU, and back. */
#ifndef VITRINE_TRANSPARENCY_RANKS_SAMPLE_PIXELS_H
#define VITRINE_TRANSPARENCY_RANKS_SAMPLE_PIXELS_H

#include "Core/geometry/PixelRegion.h"
#include "gl/BackdropCopy.h"
#include "gl/DepthCopy.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"
#include "transparency/common/SamplePlane.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

struct RenderTarget;

/**
 * Reads and writes what TargetPixels does, for each sample: first sample 0 of all pixels of the target, then sample 1,
 * and so on. Depths are the bits of floats. Pixels outside of the target's region are undefined. Each call changes the
 * framebuffer bindings, tests and masks. It returns an error message, empty on success.
 *
 * A sampler may lose bits of depth, and a blit takes one sample of its choice. So depths are found by the depth test:
 * the float is searched that equals the depth of the sample. A depth that equals no float is an error.
 */
class SamplePixels
{
public:
  std::string ReadColors(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, std::vector<std::uint32_t>& words);
  std::string ReadDepths(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, std::vector<std::uint32_t>& words);
  std::string WriteColors(vtkOpenGLRenderWindow* window, const RenderTarget& target,
    const std::vector<std::uint32_t>& words);
  std::string WriteDepths(vtkOpenGLRenderWindow* window, const RenderTarget& target,
    const std::vector<std::uint32_t>& words);

  std::int64_t Bytes() const;
  void Release();

private:
  // A depth for each sample.
  struct DepthImage
  {
    Image2D Depths;
    Framebuffer Target; // of Depths, with the depth of the render target to test against
  };

  std::string PrepareColors(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  std::string PrepareDepths(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  std::string PrepareSearch(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  bool Search(vtkOpenGLRenderWindow* window, const RenderTarget& target, int copy,
    std::vector<std::uint32_t>& words);
  PixelRegion ReadFound(vtkOpenGLRenderWindow* window, const RenderTarget& target,
    const PixelRegion& region, std::uint32_t nearest, std::vector<std::uint32_t>& words);
  vtkShaderProgram* ReadyCompare(vtkOpenGLRenderWindow* window);
  void Compare(vtkOpenGLRenderWindow* window, const RenderTarget& target, const PixelRegion& region,
    int source, double offset, unsigned int test);
  void CopyToNext(vtkOpenGLState* state, const PixelRegion& region);
  void ClearNext(vtkOpenGLState* state, const PixelRegion& region);

  SamplePlane Colors;
  SamplePlane Depths;
  BackdropCopy ColorCopy;
  DepthCopy DepthToSample;
  DepthImage Found;
  DepthImage Next; // what Compare() draws
  EmptyVertexArray VertexArray;
  ProgramCache Programs;
};

}
#endif
