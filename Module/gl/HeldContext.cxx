#include "gl/HeldContext.h"

namespace vitrine
{

void HeldContext::Hold(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent(); // Release() may have left another window's context current.
  this->Holder = window;
  this->CreationTime = window->GetContextCreationTime();
  this->LimitsOfContext.Clear();
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
  // vtkEGLRenderWindow does not remember which context was current before.
  vtkOpenGLRenderWindow* const window = this->Holder; // `release` may reset Holder.
  window->PushContext();
  if (window->IsCurrent())
  {
    release(window);
  }
  window->PopContext();
}

}
