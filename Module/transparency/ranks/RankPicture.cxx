#include "transparency/ranks/RankPicture.h"

#include "gl/RenderTarget.h"
#include "transparency/ranks/RankExchange.h"

#include <utility>
#include <vector>

namespace vitrine
{
namespace
{

std::string Malformed(const RankExchange& ranks)
{
  return ranks.Failure().empty() ? "a message of another rank does not fit the picture"
                                 : ranks.Failure();
}

}

void RankPicture::Read(vtkOpenGLState* state, const RenderTarget& target)
{
  this->Pixels.ColorWords = TargetPixels::ColorWords(target);
  this->Pixels.Farthest = TargetPixels::Farthest(target);
  this->Pixels.Depths = TargetPixels::ReadDepths(state, target);
  this->Pixels.Colors = TargetPixels::ReadColors(state, target);
  this->Before = this->Pixels;
}

void RankPicture::PutBack(vtkOpenGLState* state, const RenderTarget& target)
{
  this->Transfer.WriteDepths(state, target, this->Before.Depths);
  this->Transfer.WriteColors(state, target, this->Before.Colors);
}

std::string RankPicture::CombineOpaque(
  RankExchange& ranks, const TileOwners& owners, vtkOpenGLState* state, const RenderTarget& target)
{
  this->Read(state, target);
  if (!this->ExchangeOpaque(ranks, owners))
  {
    return Malformed(ranks);
  }
  const std::string problem = this->Transfer.WriteDepths(state, target, this->Pixels.Depths);
  return problem.empty() ? this->Transfer.WriteColors(state, target, this->Pixels.Colors) : problem;
}

// Returns false if a message does not fit.
bool RankPicture::ExchangeOpaque(RankExchange& ranks, const TileOwners& owners)
{
  const int count = ranks.Count();
  const int own = ranks.Rank();
  std::vector<Message> messages(count);
  for (int rank = 0; rank < count; ++rank)
  {
    if (rank != own)
    {
      PackOpaque(this->Pixels, owners.PixelsOf(rank), messages[rank]);
    }
  }
  bool isGood = true;
  messages = ranks.Exchange(std::move(messages));
  std::vector<std::vector<std::uint32_t>> known(count); // the depths of each rank
  for (int rank = 0; rank < count; ++rank)
  {
    isGood = (rank == own ||
               TakeNearer(messages[rank], owners.PixelsOf(own), this->Pixels, known[rank])) &&
      isGood;
  }
  messages.assign(count, {});
  for (int rank = 0; rank < count; ++rank)
  {
    if (rank != own && isGood)
    {
      PackDepths(this->Pixels, owners.PixelsOf(own), known[rank], messages[rank]);
    }
  }
  messages = ranks.Exchange(std::move(messages));
  for (int rank = 0; rank < count; ++rank)
  {
    isGood =
      (rank == own || TakeDepths(messages[rank], owners.PixelsOf(rank), this->Pixels)) && isGood;
  }
  return isGood;
}

std::string RankPicture::Send(RankExchange& ranks, const TileOwners& owners, vtkOpenGLState* state,
  const RenderTarget& target, int pictureRank)
{
  const int own = ranks.Rank();
  const auto gets = [pictureRank](int rank) { return pictureRank < 0 || pictureRank == rank; };
  this->Pixels.Colors = TargetPixels::ReadColors(state, target);
  std::vector<Message> messages(ranks.Count());
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    if (rank != own && gets(rank))
    {
      PackColors(this->Pixels, owners.PixelsOf(own), messages[rank]);
    }
  }
  messages = ranks.Exchange(std::move(messages));
  if (!gets(own))
  {
    return {};
  }
  bool isGood = true;
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    isGood =
      (rank == own || TakeColors(messages[rank], owners.PixelsOf(rank), this->Pixels)) && isGood;
  }
  return isGood ? this->Transfer.WriteColors(state, target, this->Pixels.Colors) : Malformed(ranks);
}

}
