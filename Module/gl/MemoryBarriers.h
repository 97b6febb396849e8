/**
 * Memory barriers: later commands see what shaders wrote only after a barrier that names how they access it.
 *
 * OpenGL 4.5, section 7.13.2. The steps of a frame of the linked-list method, and the barrier before each:
 *
 *   clear heads (framebuffer)         BeforeFramebufferAccess, for image atomics of the last fill
 *   fill (storage, images)            BeforeFilling, for fetches of the last resolve, and for the clear
 *   classify (fetches, storage)       BeforeReadingLists
 *   read counters (buffer)            BeforeReadingBuffers
 *   read heads (framebuffer)          BeforeFramebufferAccess
 *   sort runs (fetches, images)       none, since only counters were written after classify
 *   resolve (fetches)                 BeforeReadingLists
 *
 * Packed lists have scans (storage, images) between the clear, or the last fill, and the next fill. BetweenScans stands
 * before, between and after the scans.
 *
 * llvmpipe runs draws one after the other, so a missing barrier shows in no picture there. TestMemoryBarriers checks
 * the calls.
 */
#ifndef VITRINE_GL_MEMORY_BARRIERS_H
#define VITRINE_GL_MEMORY_BARRIERS_H

#include "gl/VitrineOpenGL.h"

namespace vitrine
{

/** Call this before an image that shaders changed by atomics is cleared or read as an attachment of a framebuffer. */
inline void BarrierBeforeFramebufferAccess()
{
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
}

/** Call this before shaders store fragments where other shaders fetched, or where a clear wrote. */
inline void BarrierBeforeFilling()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

/**
 * Call this before shaders fetch, or sort in place, the lists that other shaders stored, and go on counting in the same
 * counters.
 */
inline void BarrierBeforeReadingLists()
{
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_SHADER_STORAGE_BARRIER_BIT);
}

/**
 * Call this before compute shaders read data of fills, clears or other compute shaders, and before a fill reads data of
 * compute shaders.
 */
inline void BarrierBetweenScans()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/** Call this before a buffer that shaders wrote is read back. */
inline void BarrierBeforeReadingBuffers()
{
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

}
#endif
