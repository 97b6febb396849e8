#include "gl/HeldContext.h"

namespace vitrine
{

void HeldContext::Hold(vtkOpenGLRenderWindow* window)
{
  this->Holder = window;
  this->CreationTime = window->GetContextCreationTime();
}

bool HeldContext::Lives() const
{
  return this->Holder && this->Holder->GetContextCreationTime() == this->CreationTime;
}

void HeldContext::Release(const std::function<void(vtkOpenGLRenderWindow*)>& release) const
{
  if (!this->Lives())
  {
    return;
  }
  vtkOpenGLRenderWindow* const window = this->Holder; // `release` may let go
  window->PushContext();
  if (window->IsCurrent())
  {
    release(window);
  }
  window->PopContext();
}

}
