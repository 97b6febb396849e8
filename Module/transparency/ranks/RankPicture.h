/** The opaque pixels of all ranks, and the picture that ranks share. */
#ifndef VITRINE_TRANSPARENCY_RANKS_RANK_PICTURE_H
#define VITRINE_TRANSPARENCY_RANKS_RANK_PICTURE_H

#include "Core/ranks/OpaquePixels.h"
#include "gl/TargetPixels.h"

#include <string>

class vtkOpenGLState;

namespace vitrine
{

class RankExchange;
struct RenderTarget;

/** Its calls are collective. They return why this rank cannot go on, or an empty string. */
class RankPicture
{
public:
  /**
   * Give the target the nearest opaque depths of all ranks, and the pixels that this rank owns the nearest opaque
   * colours. Changes the framebuffer bindings and the scissor test.
   */
  std::string CombineOpaque(RankExchange& ranks, const TileOwners& owners, vtkOpenGLState* state,
    const RenderTarget& target);

  /**
   * Put back what the target had before CombineOpaque(). Changes the framebuffer bindings and the scissor test.
   */
  void PutBack(vtkOpenGLState* state, const RenderTarget& target);

  /**
   * Send the pixels that this rank owns to `pictureRank`, or to all if it is negative. There they are drawn into the
   * target. Changes the framebuffer bindings and the scissor test.
   */
  std::string Send(RankExchange& ranks, const TileOwners& owners, vtkOpenGLState* state,
    const RenderTarget& target, int pictureRank);

  std::int64_t Bytes() const { return this->Transfer.Bytes(); }
  void Release() { this->Transfer.Release(); }

private:
  void Read(vtkOpenGLState* state, const RenderTarget& target);
  bool ExchangeOpaque(RankExchange& ranks, const TileOwners& owners);

  TargetPixels Transfer;
  OpaquePixels Pixels;
  OpaquePixels Before; // this rank's own
};

}
#endif
