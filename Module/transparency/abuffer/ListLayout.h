/** The layout of fragment lists. Shaders are compiled for it. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_LAYOUT_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_LAYOUT_H

#include <string>
#include <vector>

namespace vitrine
{

/** Formats of a node's colour. */
enum class NodeColors
{
  HalfFloat, ///< Four 16-bit floats.
  EightBit,  ///< RGBA8.
  Compact    ///< Colour and depth together in two words, for linear 8-bit targets only.
};

struct ListLayout
{
  bool Packed = false; ///< Lists are consecutive nodes of one buffer, not linked pages of a pool.
  NodeColors Colors = NodeColors::HalfFloat;
  bool FixedPoint = true;
  bool EncodesSRGB = false; ///< The target stores colours with sRGB's curve.
  bool FramebufferFetch = false;
  bool IsSoftware = false;   ///< Shaders run on the CPU (gl/DeviceTraits).
  bool Additive = false;     ///< Some fragments are added to what is behind them.
  bool Coincidence = false;  ///< Depths are intervals, since there is a coincidence tolerance.
  bool PartNumbers = false;  ///< Nodes have a word for their part, in a buffer of its own.
  bool ErrorBounds = false;  ///< The error of each pixel is bounded (ErrorBounds).
  bool FixedBound = false;   ///< With ErrorBounds: what is stored has the same bound in all pixels.
  bool HiddenDepths = false; ///< The depths that hide what is behind are found (HiddenDepths).
  int Samples = 0;
  int PageSize = 1;

  /**
   * Returns true if a list is sorted once and composited into all samples of its pixel (SampleImages). Else each sample
   * of a multisampled pixel sorts the list. So it is with a coincidence tolerance, since each sample has groups of its
   * own, in targets of sRGB, which may or may not encode what is written, with more samples than the draw buffers that
   * OpenGL guarantees, and on devices, for whose few registers the composites of all samples have not been tried.
   */
  bool ResolvesAllSamples() const
  {
    return (this->Samples == 2 || this->Samples == 4 || this->Samples == MostDrawBuffers) &&
      !this->Coincidence && !this->EncodesSRGB && this->IsSoftware;
  }
  static constexpr int MostDrawBuffers = 8;

  /** The define that selects the colour format in shaders. It is null for 8 bits. */
  const char* ColorDefine() const;

  /** The shaders' defines for this layout. */
  std::vector<std::string> Defines() const;

  /** Bytes of a node without the word of its part: 8, 12 or 16. */
  int NodeBytes() const;

  /** 32-bit words of a node. The registers of programs for runs hold as many. */
  int NodeWords() const;

  /** Words of a fragment in the registers of a network (Shaders/Registers.glsl). */
  int FragmentWords() const;
};

}
#endif
