/** Interface of the stores that keep a frame's fragments on the device, a list for each pixel, until the resolve. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_STORE_H
#define VITRINE_TRANSPARENCY_ABUFFER_FRAGMENT_STORE_H

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "transparency/abuffer/FragmentCounters.h"
#include "transparency/abuffer/ListHeads.h"
#include "transparency/abuffer/ListLayout.h"
#include "transparency/abuffer/NodeBuffers.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

class FragmentStore
{
public:
  virtual ~FragmentStore() = default;

  /**
   * Begin a frame. Sets the members of `layout` that the store decides; the others are input.
   * `limit` bounds the bytes of the nodes; with 0, only the driver bounds them. Changes the framebuffer binding.
   * Returns an error message, empty on success.
   */
  virtual std::string BeginFrame(
    vtkOpenGLState* state, const RenderTarget& target, std::int64_t limit, ListLayout& layout) = 0;

  /**
   * Empty the lists of `region`, so that they can be filled. May change the page size in `layout`. Returns an error
   * message, empty on success.
   */
  virtual std::string BeginFill(
    vtkOpenGLRenderWindow* window, const PixelRegion& region, ListLayout& layout) = 0;

  /** Set the store's uniforms of the fill shader. */
  virtual void SetFillUniforms(vtkShaderProgram* program) const = 0;

  /** Returns true if the driver could not compile one of the store's own shaders. The store is unusable then. */
  virtual bool HasFailed() const { return false; }

  enum FitType
  {
    FITS, ///< All drawn fragments are in the store.
    GREW, ///< Fragments are missing, but there is room now: draw again.
    /** The limit or the driver forbids enough room. The store is as large as they allow. */
    TOO_LARGE,
    TOO_DEEP ///< A pixel has more fragments than the store can count.
  };

  /**
   * Returns true after a fill that only counted, if the store expects room for all fragments. The next fill stores them
   * then, and the counters need not be read in between.
   */
  virtual bool GoesOnToStore() { return false; }

  /**
   * Begin to fill bands that were planned by another frame. Returns true if the store needs a fill of all bands before
   * that, which only counts.
   */
  virtual bool BeginPlannedBands() { return false; }

  /** Check whether the store holds all fragments that the last fill counted. If not, make room for them. */
  virtual FitType Fit(const FragmentStatistics& needed) = 0;

  /** Returns true if the limit, and the driver as far as is known, allow room for so much. */
  virtual bool HasRoomFor(const FragmentStatistics& needed) const = 0;

  /**
   * After TOO_LARGE: the number of units that the store may hold. A unit has UnitNodes() nodes and UnitBytes() bytes.
   */
  virtual std::int64_t CapacityUnits() const = 0;
  virtual int UnitNodes() const = 0;
  virtual std::int64_t UnitBytes() const = 0;

  /** Returns what bounds the store: "its limit is N bytes", or for how much the driver has memory. */
  virtual std::string DescribeLimit() const = 0;

  /**
   * Read the number of fragments that the last fill counted in each pixel, by rows from the bottom. Waits for the
   * device.
   */
  virtual std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state) = 0;

  /** End a finished frame that took `bands` bands. A frame without fragments counts too. */
  virtual void EndFrame(const FragmentStatistics& used, int bands) = 0;

  virtual const NodeBuffers& Nodes() const = 0;

  ///@{
  /** GL names. They are 0 for objects that the store lacks. */
  virtual GLuint LinkTexture() const { return 0; }
  virtual GLuint BlockImage() const { return 0; }
  GLuint CounterBuffer() const { return this->Counters.Handle(); }
  ///@}

  ListHeads& Heads() { return this->ListsOfPixels; }

  ///@{
  /** Copy the counters of a fill on the device. Several fills may do so before the first `count` copies are read. */
  bool ReserveCopies(int count) { return this->Counters.ReserveCopies(count); }
  virtual void CopyCounters(int copy) { this->Counters.Copy(copy); }
  std::vector<FragmentStatistics> ReadCounters(int count) const
  {
    return this->Counters.Read(count);
  }
  ///@}

  /** Bytes of the nodes and their links, and bytes of everything else that the store holds. */
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

/** Binds the buffers that a fill of `store` writes while the object lives. */
class ScopedFillBuffers
{
public:
  explicit ScopedFillBuffers(const FragmentStore& store)
    : Counters(VITRINE_BINDING_COUNTERS, store.CounterBuffer())
    , Nodes(store.Nodes())
    , Links(VITRINE_IMAGE_LINKS, store.LinkTexture())
  {
  }

private:
  ScopedStorageBuffer Counters;
  ScopedNodeImages Nodes;
  ScopedImage Links;
};

}
#endif
