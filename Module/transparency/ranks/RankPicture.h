/** The opaque pixels of all ranks, and the picture that ranks share. */
#ifndef VITRINE_TRANSPARENCY_RANKS_RANK_PICTURE_H
#define VITRINE_TRANSPARENCY_RANKS_RANK_PICTURE_H

#include "Core/ranks/OpaquePixels.h"
#include "gl/TargetPixels.h"
#include "transparency/ranks/SamplePixels.h"

#include <string>

class vtkOpenGLRenderWindow;

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
   * colours. Changes the framebuffer bindings, tests and masks.
   */
  std::string CombineOpaque(RankExchange& ranks, const TileOwners& owners,
    vtkOpenGLRenderWindow* window, const RenderTarget& target);

  /**
   * Put back what the target had before CombineOpaque(). Changes the framebuffer bindings, tests and masks.
   */
  void PutBack(vtkOpenGLRenderWindow* window, const RenderTarget& target);

  /**
   * Send the pixels that this rank owns to `pictureRank`, or to all if it is negative. There they are drawn into the
   * target. Changes the framebuffer bindings, tests and masks.
   */
  std::string Send(RankExchange& ranks, const TileOwners& owners, vtkOpenGLRenderWindow* window,
    const RenderTarget& target, int pictureRank);

  std::int64_t Bytes() const { return this->Transfer.Bytes() + this->Samples.Bytes(); }
  void Release();

private:
  std::string Read(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  std::string ReadColors(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  std::string WriteDepths(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, const OpaquePixels& pixels);
  std::string WriteColors(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, const OpaquePixels& pixels);
  bool ExchangeOpaque(RankExchange& ranks, const TileOwners& owners);

  TargetPixels Transfer; // of single-sampled targets
  SamplePixels Samples;  // of multisampled ones
  OpaquePixels Pixels;
  OpaquePixels Before; // this rank's own, or nothing
};

}
#endif
