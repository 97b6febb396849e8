/**
 * What shaders wrote is seen by what comes next only after a barrier, which names how it is looked at then.
 *
 * OpenGL 4.5, section 7.13.2. A frame of the linked-list method, and what stands between its steps:
 *
 *   clear heads (framebuffer)         BeforeFramebufferAccess: image atomics of the last fill
 *   fill (storage, image atomics)     BeforeFilling: fetches of the last resolve, the clear
 *   classify (fetches, storage)       BeforeReadingLists
 *   read counters (buffer)            BeforeReadingBuffers
 *   read heads (framebuffer)          BeforeFramebufferAccess
 *   sort runs (fetches, storage)      after classify nothing was written but counters
 *   resolve (fetches)                 BeforeReadingLists
 *
 * Packed lists have scans (storage, images) between the clear, or the last fill, and the next: BetweenScans before, between
 * and after them.
 *
 * llvmpipe draws one thing after the other: there, no picture shows a barrier that is missing. TestMemoryBarriers looks at the calls.
 */
#ifndef VITRINE_GL_MEMORY_BARRIERS_H
#define VITRINE_GL_MEMORY_BARRIERS_H

#include "gl/VitrineOpenGL.h"

namespace vitrine
{

/** Before an image that shaders set by atomics is cleared, or read, as an attachment of a framebuffer. */
inline void BarrierBeforeFramebufferAccess()
{
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
}

/** Before shaders store fragments where others were fetched from, or where a clear wrote. */
inline void BarrierBeforeFilling()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/** Before shaders fetch the lists that others stored, and count on in the same counters. */
inline void BarrierBeforeReadingLists()
{
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

/** Before compute shaders read what fills, clears or other compute shaders wrote, and before a fill reads theirs. */
inline void BarrierBetweenScans()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/** Before a buffer that shaders wrote is read back. */
inline void BarrierBeforeReadingBuffers()
{
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

}
#endif
