#include "window/EGLOffscreenContext.h"

#include "window/VitrineEGL.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <vector>

namespace
{
bool HasEGL()
{
  static const bool has = vitrine::LoadEGL(EGL_NO_DISPLAY);
  return has;
}

/** Returns true if a list of extensions, separated by spaces, contains exactly this name. */
bool HasExtension(const char* extensions, const std::string& name)
{
  std::istringstream words(extensions ? extensions : "");
  return std::find(std::istream_iterator<std::string>(words), {}, name) !=
    std::istream_iterator<std::string>();
}

bool HasClientExtension(const std::string& name)
{
  return HasExtension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
}

std::vector<EGLDeviceEXT> QueryDevices()
{
  if (!HasEGL() || !HasClientExtension("EGL_EXT_platform_device") ||
    !(HasClientExtension("EGL_EXT_device_base") ||
      HasClientExtension("EGL_EXT_device_enumeration")))
  {
    return {};
  }
  const auto queryDevices =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLint count = 0;
  if (!queryDevices || !queryDevices(0, nullptr, &count))
  {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
  if (!queryDevices(count, devices.data(), &count))
  {
    return {};
  }
  devices.resize(static_cast<size_t>(count));
  return devices;
}

EGLDisplay GetPlatformDisplay(EGLenum platform, void* nativeDisplay)
{
  const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return getPlatformDisplay ? getPlatformDisplay(platform, nativeDisplay, nullptr) : EGL_NO_DISPLAY;
}

struct Candidate
{
  std::string Platform;
  EGLDisplay Display;
  int Device = -1;
};

// Displays without a window system come first, so that DISPLAY in the environment has no effect. It may be stale or
// name another machine.
std::vector<Candidate> ListCandidates(int firstDevice)
{
  std::vector<Candidate> candidates;
  const std::vector<EGLDeviceEXT> devices = QueryDevices();
  for (size_t i = static_cast<size_t>(std::max(firstDevice, 0)); i < devices.size(); ++i)
  {
    candidates.push_back({ "device:" + std::to_string(i),
      GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i]), static_cast<int>(i) });
  }
  if (HasClientExtension("EGL_MESA_platform_surfaceless"))
  {
    candidates.push_back(
      { "surfaceless", GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY) });
  }
  candidates.push_back({ "default", eglGetDisplay(EGL_DEFAULT_DISPLAY) });
  return candidates;
}

bool ChooseConfig(EGLDisplay display, EGLint surfaceType, EGLConfig& config)
{
  const EGLint attributes[] = { EGL_SURFACE_TYPE, surfaceType, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_NONE };
  EGLint count = 0;
  return eglChooseConfig(display, attributes, &config, 1, &count) && count > 0;
}

EGLContext CreateCoreContext(EGLDisplay display, EGLConfig config)
{
  static constexpr EGLint versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 },
    { 4, 1 }, { 4, 0 }, { 3, 3 }, { 3, 2 } };
  for (const EGLint* version : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  return EGL_NO_CONTEXT;
}
}

namespace vitrine
{
std::unique_ptr<EGLOffscreenContext> EGLOffscreenContext::Create(
  int firstDevice, std::string& failures)
{
  failures.clear();
  if (!HasEGL())
  {
    failures = "this machine has no EGL (libEGL.so.1)";
    return nullptr;
  }
  for (const Candidate& candidate : ListCandidates(firstDevice))
  {
    std::unique_ptr<EGLOffscreenContext> context(
      new EGLOffscreenContext(candidate.Display, candidate.Platform, candidate.Device));
    std::string failure;
    if (context->Initialize(failure))
    {
      return context;
    }
    failures += (failures.empty() ? "" : "; ") + candidate.Platform + ": " + failure;
  }
  return nullptr;
}

int EGLOffscreenContext::CountDevices()
{
  return static_cast<int>(QueryDevices().size());
}

EGLOffscreenContext::EGLOffscreenContext(void* display, const std::string& platform, int device)
  : Platform(platform)
  , Device(device)
  , Display(display)
{
}

bool EGLOffscreenContext::Initialize(std::string& failure)
{
  if (this->Display == EGL_NO_DISPLAY)
  {
    failure = "no display";
    return false;
  }
  if (!eglInitialize(this->Display, nullptr, nullptr))
  {
    failure = "eglInitialize gives " + GetLastError();
    return false;
  }
  LoadEGL(this->Display);
  if (!eglBindAPI(EGL_OPENGL_API))
  {
    failure = "no OpenGL";
    return false;
  }

  EGLConfig config = nullptr;
  const bool hasPixelBuffers = ChooseConfig(this->Display, EGL_PBUFFER_BIT, config);
  const bool hasConfig = hasPixelBuffers ||
    (HasExtension(eglQueryString(this->Display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context") &&
      ChooseConfig(this->Display, 0, config));
  if (!hasConfig)
  {
    failure = "no configuration with 8 bits for each of red, green, blue and alpha";
    return false;
  }

  this->Context = CreateCoreContext(this->Display, config);
  if (this->Context == EGL_NO_CONTEXT)
  {
    failure = "no core profile context of OpenGL 3.2 or later, " + GetLastError();
    return false;
  }

  if (hasPixelBuffers)
  {
    const EGLint attributes[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    this->Surface = eglCreatePbufferSurface(this->Display, config, attributes);
  }
  if (!this->MakeCurrent())
  {
    failure = "eglMakeCurrent gives " + GetLastError();
    return false;
  }
  return true;
}

EGLOffscreenContext::~EGLOffscreenContext()
{
  if (this->IsCurrent())
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  if (this->Surface != EGL_NO_SURFACE)
  {
    eglDestroySurface(this->Display, this->Surface);
  }
  if (this->Context != EGL_NO_CONTEXT)
  {
    eglDestroyContext(this->Display, this->Context);
  }
}

bool EGLOffscreenContext::MakeCurrent() const
{
  // The bound API is state of the thread, and another library may have changed it.
  return eglBindAPI(EGL_OPENGL_API) &&
    eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context);
}

bool EGLOffscreenContext::IsCurrent() const
{
  return this->Context != EGL_NO_CONTEXT && eglGetCurrentContext() == this->Context;
}

EGLOffscreenContext::Binding EGLOffscreenContext::GetBinding()
{
  if (!HasEGL())
  {
    return { nullptr, nullptr, nullptr, nullptr };
  }
  return { eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW), eglGetCurrentSurface(EGL_READ),
    eglGetCurrentContext() };
}

void EGLOffscreenContext::Bind(const Binding& binding)
{
  if (binding.Context != EGL_NO_CONTEXT && binding.Context != eglGetCurrentContext())
  {
    eglMakeCurrent(binding.Display, binding.Draw, binding.Read, binding.Context);
  }
}

void (*EGLOffscreenContext::GetProcAddress(const char* name))()
{
  return eglGetProcAddress(name);
}

std::string EGLOffscreenContext::GetLastError()
{
  const EGLint error = eglGetError();
  switch (error)
  {
    case EGL_SUCCESS:
      return "EGL_SUCCESS";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_CONTEXT_LOST:
      return "EGL_CONTEXT_LOST";
    default:
      break;
  }
  std::ostringstream text;
  text << "EGL error 0x" << std::hex << error;
  return text.str();
}
}
