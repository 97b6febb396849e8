/**
 * @class   vtkHeadlessRenderWindow
 * @brief   offscreen render window that needs no display
 *
 * The window adds offscreen rendering through EGL to a VTK that was built for X windows only, as in Linux
 * distributions. It renders on a GPU without a display server, or by Mesa's llvmpipe without a GPU. The context is
 * the latest OpenGL core profile of the driver, from 4.6 down to 3.2. It is created on the first platform that
 * supports one: the EGL devices, Mesa's surfaceless platform, and the default display, in this order.
 *
 * @code
 * vtkHeadlessRenderWindow::InstallOverride();
 * vtkNew<vtkRenderWindow> window; // a vtkHeadlessRenderWindow
 * @endcode
 *
 * The window draws into framebuffer objects of its size. The picture can be read by GetRGBACharPixelData(),
 * vtkWindowToImageFilter and similar functions. Several windows can exist at the same time. Each can be resized,
 * finalized and rendered again. OffScreenRendering is on; nothing is shown whatever its value.
 *
 * If no platform gives a context, the first attempt to render raises one error with the answer of each platform. Then
 * rendering does nothing and reading pixels returns VTK_ERROR, until Finalize() lets the window try again.
 *
 * VTK's own EGL windows, where VTK has them, can be created and deleted at any time. The display that they share with
 * this window is not terminated.
 *
 * @warning
 * In one thread a process can use either this window or VTK's X window, since GLX does not give way to EGL there.
 *
 * @sa
 * vtkGenericOpenGLRenderWindow vtkEGLRenderWindow
 */
#ifndef vtkHeadlessRenderWindow_h
#define vtkHeadlessRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkVitrineRenderingModule.h" // export macro

#include <memory> // for members

namespace vitrine
{
class EGLOffscreenContext;
}

class VTKVITRINERENDERING_EXPORT vtkHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  ///@{
  /**
   * Standard methods to create, identify and print the object.
   */
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Let vtkRenderWindow::New() create windows of this class, and vtkRenderWindowInteractor::New() create a
   * vtkGenericRenderWindowInteractor. The event loop of that interactor ends at once, since VTK's own interactor
   * needs a display. Existing windows do not change. A second call has no effect.
   */
  static void InstallOverride();

  /**
   * Undo InstallOverride(). Existing windows do not change. A second call has no effect.
   */
  static void RemoveOverride();

  /**
   * Get the EGL platform of the context: "device:N", "surfaceless" or "default". The string is empty if there is no
   * context: before the first frame, after Finalize(), and if no platform gives one.
   */
  const char* GetPlatform();

  /**
   * Get the number of EGL devices. The search for a context begins at DeviceIndex, whose default is 0.
   */
  int GetNumberOfDevices() override;

  /**
   * Create the context unless there is one, make it current and initialize VTK's state for it. It is an error if no
   * platform gives a context.
   */
  void Initialize() override;

  /**
   * Release the context and what the window and its renderers hold on the device. The next frame creates a new
   * context.
   */
  void Finalize() override;

  /**
   * Begin a frame as in the superclass. Does nothing without a context.
   */
  void Start() override;

  /**
   * Render as in the superclass. Does nothing without a context.
   */
  void Render() override;

  /**
   * End a frame as in the superclass. Does nothing without a context.
   */
  void Frame() override;

  ///@{
  /**
   * Get the window depths of a rectangle of pixels as in the superclass. Returns VTK_ERROR without a context.
   */
  using Superclass::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  ///@}

  /**
   * Get the capabilities of the context as text, or a line that says that there is no context.
   */
  const char* ReportCapabilities() override;

  /**
   * Make the context current in the calling thread. Does nothing without a context.
   */
  void MakeCurrent() override;

  /**
   * Returns true if the context is current in the calling thread.
   */
  bool IsCurrent() override;

  /**
   * Remember the context that is current, of whatever window or library, and call MakeCurrent(). Each call is paired
   * with a call of PopContext(). The pairs may be nested.
   */
  void PushContext() override;

  /**
   * Make the context current again that was current before PushContext().
   */
  void PopContext() override;

  /**
   * Get the EGLContext, or null without a context.
   */
  void* GetGenericContext() override;

  /**
   * Get the EGLDisplay, or null without a context.
   */
  void* GetGenericDisplayId() override;

  /**
   * Load OpenGL's functions and initialize the state of the context as VTK's own windows do. Initialize() calls this
   * method while the context is current. The superclass would adopt the state of the context instead.
   */
  void OpenGLInit() override;

  /**
   * Load OpenGL's functions.
   */
  void OpenGLInitContext() override;

  /**
   * Returns 1: the window supports OpenGL.
   */
  int SupportsOpenGL() override { return 1; }

  /**
   * Returns 1: rendering is direct.
   */
  vtkTypeBool IsDirect() override { return 1; }

protected:
  vtkHeadlessRenderWindow();
  ~vtkHeadlessRenderWindow() override;

private:
  vtkHeadlessRenderWindow(const vtkHeadlessRenderWindow&) = delete;
  void operator=(const vtkHeadlessRenderWindow&) = delete;

  struct ContextStack;

  bool CreateContext();

  std::unique_ptr<vitrine::EGLOffscreenContext> Context;
  std::unique_ptr<ContextStack> Pushed;
  bool ContextFailed = false; // reported once; not tried again before Finalize()
};

#endif
