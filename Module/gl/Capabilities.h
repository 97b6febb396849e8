/**
 * What the current context offers.
 */
#ifndef VITRINE_GL_CAPABILITIES_H
#define VITRINE_GL_CAPABILITIES_H

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/** True if the current context names the extension ("GL_ARB_..."). */
bool HasExtension(const char* name);

/**
 * What the current context lacks of OpenGL `major`.`minor` and the named extensions, in words; empty if nothing.
 */
std::string MissingFeatures(int major, int minor, const std::vector<const char*>& extensions);

/** True on Mesa's llvmpipe and softpipe, which run shaders on the CPU. */
bool IsSoftwareRasteriser();

/** A rasteriser moves corners to steps of a pixel, of which its side has 2 to the power of that many (GL_SUBPIXEL_BITS). */
int SubpixelBits();

/**
 * Into how many cells, 2, 4 or 8, a pixel's side is cut, so that all samples of the current framebuffer lie in the middles of such cells; 0 if they do not, or if pixels have one sample.
 */
int SampleCells();

/** The largest shader storage block in bytes that a shader may see. */
std::int64_t LargestStorageBlock();

/** The most texels that a buffer texture may have. */
std::int64_t LargestBufferTexture();

}
#endif
