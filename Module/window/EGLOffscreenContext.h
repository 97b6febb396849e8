/**
 * @file
 * An OpenGL core profile context by EGL that needs no display and no window.
 */
#ifndef EGLOffscreenContext_h
#define EGLOffscreenContext_h

#include <memory>
#include <string>

namespace vitrine
{
/**
 * Owns one EGL context and, where the platform has pixel buffers, the 1x1 one it is made current with:
 * what is drawn goes to framebuffer objects, but drivers and VTK ask the default framebuffer for its
 * formats. Where there are none, the context is made current without a surface.
 *
 * A context belongs to the thread that made it current last. Displays are shared within the process and
 * are not terminated.
 */
class EGLOffscreenContext
{
public:
  /**
   * Try the EGL devices from `firstDevice` on, then Mesa's surfaceless platform, then the default
   * display, and on each OpenGL 4.6 down to 3.2 in its core profile. The first context to be made
   * current wins, and is current upon return.
   *
   * Where none does, return null and say in `failures` why not, a clause for each platform.
   */
  static std::unique_ptr<EGLOffscreenContext> Create(int firstDevice, std::string& failures);

  /**
   * The number of EGL devices, 0 where EGL cannot enumerate them.
   */
  static int CountDevices();

  /**
   * Release the context from this thread, if it is current here, and destroy it.
   */
  ~EGLOffscreenContext();

  EGLOffscreenContext(const EGLOffscreenContext&) = delete;
  EGLOffscreenContext& operator=(const EGLOffscreenContext&) = delete;

  /**
   * Make the context current in the calling thread. False where EGL refuses, as it does when the context
   * is current in another thread; GetLastError() says why.
   */
  bool MakeCurrent() const;

  /**
   * Whether the context is current in the calling thread.
   */
  bool IsCurrent() const;

  /**
   * What is current in a thread: the context, of whichever owner, with its display and its surfaces.
   */
  struct Binding
  {
    void* Display;
    void* Draw;
    void* Read;
    void* Context;
  };

  ///@{
  /**
   * Take down and put back what is current in the calling thread. Nothing being current is put back by
   * leaving things as they are.
   */
  static Binding GetBinding();
  static void Bind(const Binding& binding);
  ///@}

  /**
   * The name of EGL's last error in this thread, such as EGL_BAD_ACCESS.
   */
  static std::string GetLastError();

  /**
   * The entry point of an OpenGL function, null where there is none of this name.
   */
  static void (*GetProcAddress(const char* name))();

  /**
   * The platform that was taken: "device:N", "surfaceless" or "default".
   */
  const std::string& GetPlatform() const { return this->Platform; }

  /**
   * The number of the EGL device that was taken, -1 of the other platforms.
   */
  int GetDevice() const { return this->Device; }

  /**
   * The EGLContext and the EGLDisplay.
   */
  void* GetContext() const { return this->Context; }
  void* GetDisplay() const { return this->Display; }

private:
  EGLOffscreenContext(void* display, const std::string& platform, int device);
  bool Initialize(std::string& failure);

  std::string Platform;
  int Device;
  void* Display;           // EGLDisplay
  void* Surface = nullptr; // EGLSurface, EGL_NO_SURFACE without pixel buffers
  void* Context = nullptr; // EGLContext
};
}

#endif
