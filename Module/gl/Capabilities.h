/** Queries of what the current context offers. */
#ifndef VITRINE_GL_CAPABILITIES_H
#define VITRINE_GL_CAPABILITIES_H

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * Remembers the limits of a context. While an InUse object lives, the functions below ask the driver once for each
 * limit, and later answer from memory. That context must be current. Otherwise they ask each time.
 */
class KnownLimits
{
public:
  class InUse
  {
  public:
    explicit InUse(KnownLimits& limits);
    ~InUse();
    InUse(const InUse&) = delete;
    void operator=(const InUse&) = delete;

  private:
    KnownLimits* Previous;
  };

  /** Forget all limits. Call this when the context changes. */
  void Clear() { this->Values.clear(); }

  /** Returns the value of this name. Calls `ask` unless it is remembered. */
  static std::int64_t Recall(unsigned int name, const std::function<std::int64_t()>& ask);

private:
  std::map<unsigned int, std::int64_t> Values;
  static KnownLimits* Current;
};

/** Returns an integer limit of the current context, such as GL_MAX_DRAW_BUFFERS. */
std::int64_t Limit(unsigned int name);

/** Returns true if the current context has the extension ("GL_ARB_..."). */
bool HasExtension(const char* name);

/**
 * Returns, in words, what the current context lacks of OpenGL `major`.`minor` and the extensions. The result is empty
 * if it lacks nothing.
 */
std::string MissingFeatures(int major, int minor, const std::vector<const char*>& extensions);

/** Returns true on Mesa's llvmpipe and softpipe, which run shaders on the CPU. */
bool IsSoftwareRasteriser();

/** Returns true if the current context counts time in queries of this target: GL_TIMESTAMP or GL_TIME_ELAPSED. */
bool HasTimeQueries(unsigned int target);

/** Returns GL_SUBPIXEL_BITS: the rasteriser snaps vertices to 2^-bits of a pixel. */
int SubpixelBits();

/**
 * Returns the smallest n of 2, 4 and 8 for which all samples lie in the centres of n x n cells of a pixel. The samples
 * are those of the current framebuffer. Returns 0 if there is no such n, or if pixels have one sample.
 */
int SampleCells();

/** Returns the size in bytes of the largest shader storage block. */
std::int64_t LargestStorageBlock();

/** Returns the width and height in pixels of the largest viewport. */
std::array<std::int64_t, 2> LargestViewport();

/** Returns the largest number of texels of a buffer texture. */
std::int64_t LargestBufferTexture();

}
#endif
