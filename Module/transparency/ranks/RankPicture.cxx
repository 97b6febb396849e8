#include "transparency/ranks/RankPicture.h"

#include "gl/RenderTarget.h"
#include "transparency/ranks/RankExchange.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
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

// After a failure there are words, too, since other ranks wait for a message.
std::string RankPicture::Read(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  std::string problem;
  this->Before = {};
  this->Pixels.Samples = std::max(target.Samples, 1);
  this->Pixels.ColorWords = TargetPixels::ColorWords(target);
  this->Pixels.Farthest = TargetPixels::Farthest(target);
  if (target.Samples > 0)
  {
    problem = this->Samples.ReadDepths(window, target, this->Pixels.Depths);
  }
  else
  {
    this->Pixels.Depths = TargetPixels::ReadDepths(window->GetState(), target);
  }
  const std::string problemOfColors = this->ReadColors(window, target);
  problem = problem.empty() ? problemOfColors : problem;
  if (problem.empty())
  {
    this->Before = this->Pixels;
  }
  return problem;
}

std::string RankPicture::ReadColors(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  if (target.Samples > 0)
  {
    return this->Samples.ReadColors(window, target, this->Pixels.Colors);
  }
  this->Pixels.Colors = TargetPixels::ReadColors(window->GetState(), target);
  return {};
}

std::string RankPicture::WriteDepths(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, const OpaquePixels& pixels)
{
  return target.Samples > 0 ? this->Samples.WriteDepths(window, target, pixels.Depths)
                            : this->Transfer.WriteDepths(window->GetState(), target, pixels.Depths);
}

std::string RankPicture::WriteColors(
  vtkOpenGLRenderWindow* window, const RenderTarget& target, const OpaquePixels& pixels)
{
  return target.Samples > 0 ? this->Samples.WriteColors(window, target, pixels.Colors)
                            : this->Transfer.WriteColors(window->GetState(), target, pixels.Colors);
}

void RankPicture::PutBack(vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  if (!this->Before.Depths.empty())
  {
    this->WriteDepths(window, target, this->Before);
    this->WriteColors(window, target, this->Before);
  }
}

std::string RankPicture::CombineOpaque(RankExchange& ranks, const TileOwners& owners,
  vtkOpenGLRenderWindow* window, const RenderTarget& target)
{
  std::string problem = this->Read(window, target);
  if (!this->ExchangeOpaque(ranks, owners))
  {
    return Malformed(ranks);
  }
  if (problem.empty() && this->Pixels.Depths != this->Before.Depths)
  {
    problem = this->WriteDepths(window, target, this->Pixels);
  }
  if (problem.empty() && this->Pixels.Colors != this->Before.Colors)
  {
    problem = this->WriteColors(window, target, this->Pixels);
  }
  return problem;
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

std::string RankPicture::Send(RankExchange& ranks, const TileOwners& owners,
  vtkOpenGLRenderWindow* window, const RenderTarget& target, int pictureRank)
{
  const int own = ranks.Rank();
  const auto gets = [pictureRank](int rank) { return pictureRank < 0 || pictureRank == rank; };
  const std::string problem = this->ReadColors(window, target);
  std::vector<Message> messages(ranks.Count());
  for (int rank = 0; rank < ranks.Count() && problem.empty(); ++rank)
  {
    if (rank != own && gets(rank))
    {
      PackColors(this->Pixels, owners.PixelsOf(own), messages[rank]);
    }
  }
  messages = ranks.Exchange(std::move(messages));
  if (!gets(own) || !problem.empty())
  {
    return problem;
  }
  bool isGood = true;
  for (int rank = 0; rank < ranks.Count(); ++rank)
  {
    isGood =
      (rank == own || TakeColors(messages[rank], owners.PixelsOf(rank), this->Pixels)) && isGood;
  }
  return isGood ? this->WriteColors(window, target, this->Pixels) : Malformed(ranks);
}

void RankPicture::Release()
{
  this->Transfer.Release();
  this->Samples.Release();
}

}
