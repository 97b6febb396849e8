#include "Core/budget/GuessDelay.h"

#include <algorithm>

namespace vitrine
{

void GuessDelay::Begin()
{
  this->Frames = this->Next;
  this->Next = std::min(2 * this->Next, Longest);
  this->RightFrames = 0;
}

void GuessDelay::CountFrame()
{
  if (this->Frames > 0)
  {
    --this->Frames;
  }
  else if (++this->RightFrames >= Longest)
  {
    this->Next = Shortest;
  }
}

}
