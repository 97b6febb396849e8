#include "gl/HeldContext.h"

namespace vitrine
{

void HeldContext::Hold(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent(); // Release() may have left that of another window, see there
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
  // vtkEGLRenderWindow has no memory of what was current before.
  vtkOpenGLRenderWindow* const window = this->Holder; // `release` may let go
  window->PushContext();
  if (window->IsCurrent())
  {
    release(window);
  }
  window->PopContext();
}

}
