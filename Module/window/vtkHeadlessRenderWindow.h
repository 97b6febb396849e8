/**
 * @class   vtkHeadlessRenderWindow
 * @brief   a render window that needs no display
 *
 * Gives a VTK that was built for X windows only, as Linux distributions build it, offscreen rendering
 * through EGL: on a GPU without a display server, or by Mesa's llvmpipe on a machine without a GPU. The
 * context is the latest OpenGL core profile that the driver has, from 4.6 down to 3.2, on the first of
 * the EGL devices, Mesa's surfaceless platform and the default display that gives one.
 *
 * \code
 * vtkHeadlessRenderWindow::InstallOverride();
 * vtkNew<vtkRenderWindow> window; // a vtkHeadlessRenderWindow
 * \endcode
 *
 * Everything is drawn into framebuffer objects of the window's size and stays there, to be read with
 * GetRGBACharPixelData(), vtkWindowToImageFilter and their like. Several windows live side by side, and
 * each may be resized, finalized and rendered again. OffScreenRendering is on; nothing is shown whatever
 * its value.
 *
 * Where no platform gives a context, the first attempt to render raises one vtkErrorMacro that says what
 * each of them answered. From then on rendering does nothing and reading pixels returns VTK_ERROR, until
 * Finalize() lets the window try again.
 *
 * VTK's own windows by EGL, where VTK has them, may come and go beside it: the display that they share stays.
 *
 * @warning
 * A process uses either this window or VTK's X window in a given thread: GLX does not give way to EGL
 * there.
 *
 * @sa vtkGenericOpenGLRenderWindow
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
  static vtkHeadlessRenderWindow* New();
  vtkTypeMacro(vtkHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * From InstallOverride() to RemoveOverride(), vtkRenderWindow::New() gives this class in place of the
   * one it gave before, and vtkRenderWindowInteractor::New() a vtkGenericRenderWindowInteractor, whose
   * event loop ends at once, since VTK's own interactor needs a display. Calling either twice is as calling
   * it once. Windows that exist already stay what they are.
   */
  static void InstallOverride();
  static void RemoveOverride();
  ///@}

  /**
   * The EGL platform that gave the context: "device:N", "surfaceless" or "default"; "" before the first
   * frame, after Finalize() and where none does.
   */
  const char* GetPlatform();

  /**
   * The number of EGL devices. The search begins at DeviceIndex, 0 by default.
   */
  int GetNumberOfDevices() override;

  /**
   * Create the context unless there is one, make it current and initialize VTK's state for it.
   */
  void Initialize() override;

  /**
   * Release what the window and its renderers hold on the device, and the context. The next frame
   * begins anew.
   */
  void Finalize() override;

  ///@{
  /**
   * As in the superclass, once there is a context; without one, nothing or VTK_ERROR.
   */
  void Start() override;
  void Render() override;
  void Frame() override;
  using Superclass::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  const char* ReportCapabilities() override;
  ///@}

  ///@{
  /**
   * The context in the calling thread.
   */
  void MakeCurrent() override;
  bool IsCurrent() override;
  ///@}

  ///@{
  /**
   * MakeCurrent(), and make current again what was so before, be it this window, another or someone
   * else's context. To be called in pairs, which may be nested.
   */
  void PushContext() override;
  void PopContext() override;
  ///@}

  ///@{
  /**
   * The EGLContext and the EGLDisplay, null without a context.
   */
  void* GetGenericContext() override;
  void* GetGenericDisplayId() override;
  ///@}

  /**
   * Load OpenGL's entry points and bring the context into the state in which VTK begins, as VTK's own
   * windows do; the superclass would take over the context's. Initialize() calls it with the context
   * current.
   */
  void OpenGLInit() override;

  /**
   * Load OpenGL's entry points.
   */
  void OpenGLInitContext() override;

  ///@{
  /**
   * 1: a context by EGL is OpenGL's, and direct.
   */
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  ///@}

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
