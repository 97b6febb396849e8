#include "gl/VitrineOpenGL.h" // Must come first, as VTK requires.

#include "vtkHeadlessRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLState.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"
#include "vtkWeakPointer.h"
#include "window/EGLOffscreenContext.h"

#if __has_include("vtkEGLRenderWindow.h") // VTK is built with EGL.
#include "vtkEGLRenderWindow.h"
#define VITRINE_VTK_HAS_EGL 1
#else
#define VITRINE_VTK_HAS_EGL 0
#endif

#include <set>
#include <string>
#include <vector>

#ifndef VTK_FUTURE_CONST // A macro of VTK 9.3 and later.
#define VTK_FUTURE_CONST
#endif

namespace
{
const char* const WindowClass = "vtkRenderWindow";
const char* const InteractorClass = "vtkRenderWindowInteractor";

/**
 * Makes vtkRenderWindow::New() return a vtkHeadlessRenderWindow, and vtkRenderWindowInteractor::New() an interactor
 * without a display.
 *
 * VTK asks the factories in the order of their registration, and takes the first answer. So the earlier factories are
 * disabled for these classes; Restore() enables them again.
 */
class HeadlessWindowFactory : public vtkObjectFactory
{
public:
  static HeadlessWindowFactory* New();
  vtkTypeMacro(HeadlessWindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override
  {
    return "Vitrine: render windows without a display";
  }

  /** Returns the registered factory, or null. */
  static HeadlessWindowFactory* Find()
  {
    vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    vtkCollectionSimpleIterator cursor;
    factories->InitTraversal(cursor);
    while (vtkObjectFactory* factory = factories->GetNextObjectFactory(cursor))
    {
      if (auto* found = HeadlessWindowFactory::SafeDownCast(factory))
      {
        return found;
      }
    }
    return nullptr;
  }

  void SilenceEarlierFactories()
  {
    vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    vtkCollectionSimpleIterator cursor;
    factories->InitTraversal(cursor);
    while (vtkObjectFactory* factory = factories->GetNextObjectFactory(cursor))
    {
      for (int i = 0; i < factory->GetNumberOfOverrides(); ++i)
      {
        const std::string name = factory->GetClassOverrideName(i);
        if ((name == WindowClass || name == InteractorClass) && factory->GetEnableFlag(i))
        {
          this->Silenced.push_back({ factory, name, factory->GetClassOverrideWithName(i) });
          this->Silenced.back().Enable(false);
        }
      }
    }
  }

  void Restore()
  {
    for (const Override& silenced : this->Silenced)
    {
      silenced.Enable(true);
    }
    this->Silenced.clear();
  }

protected:
  HeadlessWindowFactory()
  {
    this->RegisterOverride(WindowClass, "vtkHeadlessRenderWindow", "a render window by EGL", 1,
      []() -> vtkObject* { return vtkHeadlessRenderWindow::New(); });
    this->RegisterOverride(InteractorClass, "vtkGenericRenderWindowInteractor",
      "an interactor without events", 1,
      []() -> vtkObject* { return vtkGenericRenderWindowInteractor::New(); });
  }

private:
  struct Override
  {
    // A weak pointer is used since the factory of a shared library must be deleted before the library is closed.
    vtkWeakPointer<vtkObjectFactory> Factory;
    std::string Class;
    std::string Subclass;

    void Enable(bool enable) const
    {
      if (this->Factory)
      {
        this->Factory->SetEnableFlag(enable, this->Class.c_str(), this->Subclass.c_str());
      }
    }
  };
  std::vector<Override> Silenced;
};
vtkStandardNewMacro(HeadlessWindowFactory);

#if VITRINE_VTK_HAS_EGL
/**
 * A window of VTK that only holds a display. VTK counts its windows of a display. The last one terminates the display,
 * and with it all contexts that others have there.
 */
class DisplayKeeper : public vtkEGLRenderWindow
{
public:
  static DisplayKeeper* New() { VTK_STANDARD_NEW_BODY(DisplayKeeper); }
  vtkTypeMacro(DisplayKeeper, vtkEGLRenderWindow);
  void Keep(int device) { this->SetDeviceAsDisplay(device); }
};

/** Keep the display of an EGL device alive until the process ends. Its keeper is never deleted. */
void KeepDisplay(int device)
{
  static std::set<int> kept;
  if (device >= 0 && kept.insert(device).second)
  {
    DisplayKeeper::New()->Keep(device);
  }
}
#else
void KeepDisplay(int) {}
#endif

#if VITRINE_GL_LOADER_IS_GLEW
/**
 * Load the entry points of the current context. A GLEW built for GLX loads all of OpenGL in glewInit(), and then fails
 * as there is no X display. The entry points are the same under EGL.
 *
 * Returns an error message, empty on success.
 */
std::string LoadWithGLEW()
{
  const GLenum status = glewInit();
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
  const bool loaded = status == GLEW_OK || status == GLEW_ERROR_NO_GLX_DISPLAY;
#else
  const bool loaded = status == GLEW_OK;
#endif
  if (!loaded)
  {
    return reinterpret_cast<const char*>(glewGetErrorString(status));
  }
  return GLEW_VERSION_3_2 ? "" : "the driver has no OpenGL 3.2";
}

float QueryMaximumLineWidth(bool smooth)
{
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(smooth ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  return range[1];
}
#endif
}

struct vtkHeadlessRenderWindow::ContextStack
{
  std::vector<vitrine::EGLOffscreenContext::Binding> Bindings;
};

vtkStandardNewMacro(vtkHeadlessRenderWindow);

vtkHeadlessRenderWindow::vtkHeadlessRenderWindow()
  : Pushed(new ContextStack)
{
  // There is no framebuffer on a screen to which the picture could be copied.
  this->FrameBlitMode = NoBlit;
  this->OwnContext = 1;
  this->SetOffScreenRendering(1);
  // Makes the superclass refuse to read or write pixels while there is no context.
  this->ReadyForRendering = false;
#if !VITRINE_GL_LOADER_IS_GLEW
  this->SetOpenGLSymbolLoader([](void*, const char* name)
    { return vitrine::EGLOffscreenContext::GetProcAddress(name); },
    nullptr);
#endif
}

vtkHeadlessRenderWindow::~vtkHeadlessRenderWindow()
{
  // The superclass's destructor finalizes too, but too late for this class's context.
  this->Finalize();
}

void vtkHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Platform: " << (this->Context ? this->Context->GetPlatform() : "(none)") << "\n";
}

void vtkHeadlessRenderWindow::InstallOverride()
{
  if (!HeadlessWindowFactory::Find())
  {
    auto factory = vtkSmartPointer<HeadlessWindowFactory>::New();
    factory->SilenceEarlierFactories();
    vtkObjectFactory::RegisterFactory(factory);
  }
}

void vtkHeadlessRenderWindow::RemoveOverride()
{
  if (HeadlessWindowFactory* factory = HeadlessWindowFactory::Find())
  {
    factory->Restore();
    vtkObjectFactory::UnRegisterFactory(factory);
  }
}

const char* vtkHeadlessRenderWindow::GetPlatform()
{
  return this->Context ? this->Context->GetPlatform().c_str() : "";
}

int vtkHeadlessRenderWindow::GetNumberOfDevices()
{
  return vitrine::EGLOffscreenContext::CountDevices();
}

bool vtkHeadlessRenderWindow::CreateContext()
{
  std::string failures;
  this->Context = vitrine::EGLOffscreenContext::Create(this->DeviceIndex, failures);
  if (!this->Context)
  {
    this->ContextFailed = true;
    vtkErrorMacro("No EGL platform gives an OpenGL context (" << failures << ").");
    return false;
  }
  KeepDisplay(this->Context->GetDevice());
  if (this->Size[0] <= 0 || this->Size[1] <= 0)
  {
    this->SetSize(300, 300); // VTK's own default.
  }
  this->SetMapped(1);
  return true;
}

void vtkHeadlessRenderWindow::Initialize()
{
  if (this->ContextFailed || (!this->Context && !this->CreateContext()))
  {
    return;
  }
  // ReleaseGraphicsResources() keeps the context, but not VTK's state for it.
  if (!this->Initialized)
  {
    this->MakeCurrent();
    this->OpenGLInit();
    this->ReadyForRendering = this->Initialized;
  }
}

void vtkHeadlessRenderWindow::Finalize()
{
  if (this->Context)
  {
    // The superclass pushes and pops the context. It is not current afterwards, even if it was before.
    this->ReleaseGraphicsResources(this);
    this->Context.reset();
    this->SetMapped(0);
    this->ReadyForRendering = false;
  }
  this->ContextFailed = false;
}

void vtkHeadlessRenderWindow::Start()
{
  this->Initialize();
  if (this->Initialized)
  {
    this->Superclass::Start();
  }
}

void vtkHeadlessRenderWindow::Render()
{
  this->Initialize();
  if (this->Initialized)
  {
    this->Superclass::Render();
  }
}

void vtkHeadlessRenderWindow::Frame()
{
  if (this->Initialized)
  {
    this->Superclass::Frame();
  }
}

const char* vtkHeadlessRenderWindow::ReportCapabilities()
{
  this->Initialize();
  return this->Initialized ? this->Superclass::ReportCapabilities() : "No OpenGL context.\n";
}

void vtkHeadlessRenderWindow::MakeCurrent()
{
  if (this->Context && !this->Context->MakeCurrent())
  {
    vtkErrorMacro(
      "The context cannot be made current: " << vitrine::EGLOffscreenContext::GetLastError());
  }
}

bool vtkHeadlessRenderWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

void vtkHeadlessRenderWindow::PushContext()
{
  this->Pushed->Bindings.push_back(vitrine::EGLOffscreenContext::GetBinding());
  this->MakeCurrent();
}

void vtkHeadlessRenderWindow::PopContext()
{
  if (!this->Pushed->Bindings.empty())
  {
    vitrine::EGLOffscreenContext::Bind(this->Pushed->Bindings.back());
    this->Pushed->Bindings.pop_back();
  }
}

void* vtkHeadlessRenderWindow::GetGenericContext()
{
  return this->Context ? this->Context->GetContext() : nullptr;
}

void* vtkHeadlessRenderWindow::GetGenericDisplayId()
{
  return this->Context ? this->Context->GetDisplay() : nullptr;
}

void vtkHeadlessRenderWindow::OpenGLInit()
{
  this->vtkOpenGLRenderWindow::OpenGLInit();
}

void vtkHeadlessRenderWindow::OpenGLInitContext()
{
#if VITRINE_GL_LOADER_IS_GLEW
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  const std::string failure = LoadWithGLEW();
  this->GlewInitValid = failure.empty();
  if (!this->GlewInitValid)
  {
    this->ContextFailed = true;
    vtkErrorMacro("OpenGL's entry points cannot be loaded: " << failure);
    return;
  }
  this->Initialized = true;
  this->MaximumHardwareLineWidth = QueryMaximumLineWidth(this->LineSmoothing);
#else
  this->Superclass::OpenGLInitContext();
#endif
}

int vtkHeadlessRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->Initialized ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}
