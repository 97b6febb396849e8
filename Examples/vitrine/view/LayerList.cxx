#include "view/LayerList.h"

#include "Errors.h"

#include <algorithm>
#include <cstdlib>

namespace program
{

namespace
{
const int SamePlace = 4; // pixels
const double ShareThatIsSeen = 0.5;
}

LayerList::LayerList(vtkRenderer* renderer)
{
  this->Picker->SetRenderer(renderer);
  this->Picker->SetBehindOpaque(true);
}

const PartUnderCursor* LayerList::Click(int x, int y, bool deeper, const ShownParts& parts)
{
  const bool isSamePlace = !this->Found.empty() && std::abs(x - this->Pixel[0]) < SamePlace &&
    std::abs(y - this->Pixel[1]) < SamePlace;
  const std::optional<std::size_t> before =
    isSamePlace ? std::optional<std::size_t>(this->Found[this->Chosen].Part) : std::nullopt;
  this->Find(x, y, parts);
  if (this->Found.empty())
  {
    return nullptr;
  }
  const auto again = std::find_if(this->Found.begin(), this->Found.end(),
    [before](const PartUnderCursor& part) { return part.Part == before; });
  const bool isKnown = again != this->Found.end();
  this->Chosen =
    isKnown ? static_cast<std::size_t>(again - this->Found.begin()) : this->SeenByEye();
  if (isKnown || deeper)
  {
    this->Chosen = (this->Chosen + 1) % this->Found.size();
  }
  this->Pixel = { x, y };
  return &this->Found[this->Chosen];
}

void LayerList::Forget()
{
  this->Found.clear();
}

void LayerList::Find(int x, int y, const ShownParts& parts)
{
  this->Found.clear();
  this->Picker->SetPosition(x, y);
  if (!this->Picker->Pick())
  {
    throw RuntimeError(this->Picker->GetProblem());
  }
  for (vtkIdType layer = 0; layer < this->Picker->GetNumberOfLayers(); ++layer)
  {
    const std::optional<std::size_t> part =
      parts.Find(this->Picker->GetProp(layer), this->Picker->GetBlock(layer));
    if (!part)
    {
      continue;
    }
    const double share = this->Picker->GetShare(layer);
    const auto known = std::find_if(this->Found.begin(), this->Found.end(),
      [part](const PartUnderCursor& found) { return found.Part == *part; });
    if (known != this->Found.end())
    {
      known->Share += share;
      continue;
    }
    PartUnderCursor found{ *part, share, this->Picker->GetOpacity(layer), {} };
    std::copy_n(this->Picker->GetWorldPosition(layer), 3, found.Position.begin());
    this->Found.push_back(found);
  }
}

std::size_t LayerList::SeenByEye() const
{
  const auto seen = std::find_if(this->Found.begin(), this->Found.end(),
    [](const PartUnderCursor& part) { return part.Share >= ShareThatIsSeen; });
  const auto most = std::max_element(this->Found.begin(), this->Found.end(),
    [](const PartUnderCursor& a, const PartUnderCursor& b) { return a.Share < b.Share; });
  return static_cast<std::size_t>((seen != this->Found.end() ? seen : most) - this->Found.begin());
}

}
