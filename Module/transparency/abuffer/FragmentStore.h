/**
 * Where the fragments of a frame lie on the device until they are resolved: a list for each pixel.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_STORE_H
#define VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_STORE_H

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/abuffer/FragmentCounters.h"
#include "transparency/abuffer/ListHeads.h"
#include "transparency/abuffer/ListLayout.h"

#include <cassert>
#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

/** The format of a texel that holds a node of so many bytes: 8, 12 or 16. */
inline GLenum NodeFormat(int nodeBytes)
{
  assert(nodeBytes == 8 || nodeBytes == 12 || nodeBytes == 16);
  return nodeBytes == 8 ? GL_RG32UI : nodeBytes == 12 ? GL_RGB32UI : GL_RGBA32UI;
}

/** The storage buffers that a fill writes, bound while the keeper lives; 0 for those that it has not. */
class ScopedFillBuffers
{
public:
  ScopedFillBuffers(GLuint counters, GLuint nodes, GLuint links)
    : Counters(VITRINE_BINDING_COUNTERS, counters)
    , Nodes(VITRINE_BINDING_NODES, nodes)
    , Links(VITRINE_BINDING_LINKS, links)
  {
  }

private:
  ScopedStorageBuffer Counters;
  ScopedStorageBuffer Nodes;
  ScopedStorageBuffer Links;
};

class FragmentStore
{
public:
  virtual ~FragmentStore() = default;

  /**
   * Begin a frame: sets what the store decides of `layout`, whose other members are given, and bounds the nodes to
   * `limit` bytes, 0 for no bound but the driver's. Changes the framebuffer binding. Returns an empty string, or why
   * the driver cannot.
   */
  virtual std::string BeginFrame(
    vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit, ListLayout& layout) = 0;

  /**
   * Empty the lists of `region`, so that they can be filled. May change `layout`'s page size. Returns an empty string,
   * or why the driver cannot.
   */
  virtual std::string BeginFill(
    vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout) = 0;

  /** The uniforms of the fill shader. */
  virtual void SetFillUniforms(vtkShaderProgram* program) const = 0;

  /** Whether the driver could not compile one of the store's own shaders: it is of no use then. */
  virtual bool HasFailed() const { return false; }

  enum FitType
  {
    FITS,      ///< what was drawn is in the store
    GREW,      ///< it was not, but there is room now: draw it again
    TOO_LARGE, ///< the limit, or the driver, forbids it; the store is as large as they allow
    TOO_DEEP   ///< a pixel has more fragments than the store can count
  };

  /** Whether what the last fill counted is in the store; if not, make room for it. */
  virtual FitType Fit(const FragmentStatistics& needed) = 0;

  /** Units that the store may hold, of UnitNodes() nodes and UnitBytes() bytes each, after TOO_LARGE. */
  virtual std::int64_t CapacityUnits() const = 0;
  virtual int UnitNodes() const = 0;
  virtual std::int64_t UnitBytes() const = 0;

  /** What bounds the store: "its limit is N bytes", or what the driver has memory for. */
  virtual std::string DescribeLimit() const = 0;

  /** Fragments that the last fill counted in each pixel, row by row from the bottom; waits for the device. */
  virtual std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state) = 0;

  /** After a finished frame in so many bands, or one without fragments. */
  virtual void EndFrame(const FragmentStatistics& used, int bands) = 0;

  ///@{
  /** GL names; 0 for what a store has not. */
  virtual GLuint NodeBuffer() const = 0;
  virtual GLuint NodeTexture() const = 0;
  virtual GLuint LinkBuffer() const { return 0; }
  virtual GLuint LinkTexture() const { return 0; }
  virtual GLuint BlockImage() const { return 0; }
  GLuint CounterBuffer() const { return this->Counters.Handle(); }
  ///@}

  ListHeads& Heads() { return this->ListsOfPixels; }
  FragmentStatistics ReadCounters() const { return this->Counters.Read(); }

  /** Bytes of the nodes and what links them, and of all else that the store holds. */
  virtual std::int64_t NodeBytes() const = 0;
  virtual std::int64_t OtherBytes() const { return this->ListsOfPixels.Image().Bytes(); }

  virtual void Release()
  {
    this->ListsOfPixels.Release();
    this->Counters.Release();
  }

protected:
  ListHeads ListsOfPixels;
  FragmentCounters Counters;
};

}
#endif
