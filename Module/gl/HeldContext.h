/** The context in which a pass has its GL objects. */
#ifndef VITRINE_GL_HELD_CONTEXT_H
#define VITRINE_GL_HELD_CONTEXT_H

#include "gl/Capabilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <functional>

namespace vitrine
{

/**
 * Identifies a window's context by its creation time. After a window was finalized it makes a new context, in which the
 * old names of objects belong to others.
 */
class HeldContext
{
public:
  /** Hold the context of `window`, and make it current. */
  void Hold(vtkOpenGLRenderWindow* window);

  void LetGo() { this->Holder = nullptr; }

  /** The window, if it still exists. Its context may be gone. */
  vtkOpenGLRenderWindow* Window() const { return this->Holder; }

  bool Lives() const;

  /** Returns true if the held context lives and belongs to `window`. */
  bool LivesIn(const vtkWindow* window) const
  {
    return this->Holder.GetPointer() == window && this->Lives();
  }

  /**
   * Make the context current and call `release` with the window. Does nothing if the context is gone or cannot be made
   * current. Then restores the former context; a window that cannot (vtkEGLRenderWindow) leaves its own current.
   * A caller that goes on in another window calls Hold(), or makes that window current.
   */
  void Release(const std::function<void(vtkOpenGLRenderWindow*)>& release) const;

  /** The limits of the held context. */
  KnownLimits& Limits() { return this->LimitsOfContext; }

private:
  vtkWeakPointer<vtkOpenGLRenderWindow> Holder;
  vtkMTimeType CreationTime = 0;
  KnownLimits LimitsOfContext;
};

}

#endif
