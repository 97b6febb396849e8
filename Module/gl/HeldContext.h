/**
 * The context in which a pass has its GL objects.
 */
#ifndef VITRINE_GL_HELD_CONTEXT_H
#define VITRINE_GL_HELD_CONTEXT_H

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <functional>

namespace vitrine
{

/** A window makes a context anew after it was finalized: names of the one before are those of others then. */
class HeldContext
{
public:
  /** Hold the context of `window`, which is current from here on. */
  void Hold(vtkOpenGLRenderWindow* window);

  void LetGo() { this->Holder = nullptr; }

  /** The window, if there is one yet; its context may be gone. */
  vtkOpenGLRenderWindow* Window() const { return this->Holder; }

  bool Lives() const;

  /** Whether it is this window's and lives. */
  bool LivesIn(const vtkWindow* window) const
  {
    return this->Holder.GetPointer() == window && this->Lives();
  }

  /**
   * Calls `release` with the window where its context lives and can be made current. With windows that do not give way it
   * stays so: whoever goes on in another window calls Hold(), or makes that one current.
   */
  void Release(const std::function<void(vtkOpenGLRenderWindow*)>& release) const;

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Holder;
  vtkMTimeType CreationTime = 0;
};

}

#endif
