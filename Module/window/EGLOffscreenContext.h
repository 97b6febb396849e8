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
 * Owns one EGL context and, if the platform has pixel buffers, a 1x1 pixel buffer.
 *
 * The context is made current with the pixel buffer, or else without a surface. All drawing goes to framebuffer
 * objects, but drivers and VTK query the formats of the default framebuffer.
 *
 * A context belongs to the thread that made it current last. This class terminates no display, since the process shares
 * them.
 */
class EGLOffscreenContext
{
public:
  /**
   * Try the EGL devices from `firstDevice` on, then Mesa's surfaceless platform, then the default display. On each, try
   * core profiles of OpenGL from 4.6 down to 3.2. The first context that can be made current is returned, and is
   * current.
   *
   * Returns null if there is none. `failures` then says why, a clause for each platform.
   */
  static std::unique_ptr<EGLOffscreenContext> Create(int firstDevice, std::string& failures);

  /** Returns the number of EGL devices, or 0 if EGL cannot enumerate them. */
  static int CountDevices();

  /** Release the context from this thread, if it is current here, and destroy it. */
  ~EGLOffscreenContext();

  EGLOffscreenContext(const EGLOffscreenContext&) = delete;
  EGLOffscreenContext& operator=(const EGLOffscreenContext&) = delete;

  /**
   * Make the context current in the calling thread. Returns false if EGL refuses, for example since the context is
   * current in another thread. GetLastError() tells the reason.
   */
  bool MakeCurrent() const;

  /** Returns true if the context is current in the calling thread. */
  bool IsCurrent() const;

  /** The context that is current in a thread, whoever owns it, with its display and surfaces. */
  struct Binding
  {
    void* Display;
    void* Draw;
    void* Read;
    void* Context;
  };

  ///@{
  /** Get and restore what is current in the calling thread. If nothing was current, Bind() changes nothing. */
  static Binding GetBinding();
  static void Bind(const Binding& binding);
  ///@}

  /** Returns the name of EGL's last error in this thread, such as EGL_BAD_ACCESS. */
  static std::string GetLastError();

  /** Returns the entry point of an OpenGL function, or null if there is none of this name. */
  static void (*GetProcAddress(const char* name))();

  /** Returns the platform in use: "device:N", "surfaceless" or "default". */
  const std::string& GetPlatform() const { return this->Platform; }

  /** Returns the number of the EGL device in use, or -1 on other platforms. */
  int GetDevice() const { return this->Device; }

  /** Get the EGLContext and the EGLDisplay. */
  void* GetContext() const { return this->Context; }
  void* GetDisplay() const { return this->Display; }

private:
  EGLOffscreenContext(void* display, const std::string& platform, int device);
  bool Initialize(std::string& failure);

  std::string Platform;
  int Device;
  void* Display;           // The EGLDisplay.
  void* Surface = nullptr; // The EGLSurface, or EGL_NO_SURFACE without pixel buffers.
  void* Context = nullptr; // The EGLContext.
};
}

#endif
