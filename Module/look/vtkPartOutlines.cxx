#include "vtkPartOutlines.h"

#include "gl/FullScreenDraw.h"
#include "gl/GLObjects.h"
#include "gl/HeldContext.h"
#include "gl/ProgramCache.h"
#include "gl/ScopedState.h"
#include "look/ChosenParts.h"
#include "look/PartMask.h"
#include "look/RegionOfParts.h"
#include "scene/Settings.h"
#include "shader/ShaderText.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPartOutlines);

namespace
{

/** Outlines come after what other observers do at the end of a frame, such as a culler that takes back its choice. */
constexpr float AfterOthers = -1.0f;

constexpr vitrine::NumberRange<double> Share{ 0.0, 1.0 };

/** Observes the end of a renderer's frames, and keeps the object alive. */
class EndOfFrame : public vtkCommand
{
public:
  static EndOfFrame* New() { return new EndOfFrame; }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    const vtkSmartPointer<vtkPartOutlines> alive = this->Outlines;
    this->Draw();
  }

  vtkSmartPointer<vtkPartOutlines> Outlines;
  std::function<void()> Draw;
};
}

struct vtkPartOutlines::Internals
{
  vitrine::ChosenParts Chosen;
  vitrine::ChosenParts Excluded;
  std::array<double, 3> Color{ 1.0, 0.5, 0.0 };
  double Opacity = 1.0;
  int Width = 2;
  double FillOpacity = 0.0;

  vtkPartOutlines* Owner = nullptr;
  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  std::string FallbackReason;
  std::string ToldReason; ///< of the last warning

  vtkNew<vitrine::PartMask> Mask;
  vitrine::HeldContext Context; ///< of Programs and Triangle
  vitrine::ProgramCache Programs{ vitrine::GLSL150 };
  vitrine::EmptyVertexArray Triangle;

  void Choose(vitrine::ChosenParts& parts, const char* method, vtkProp* prop, int block)
  {
    if (!vitrine::ChosenParts::IsOfParts(prop))
    {
      vtkErrorWithObjectMacro(this->Owner,
        << method << " takes an actor, and cannot take " << (prop ? prop->GetClassName() : "null"));
      return;
    }
    parts.Add(prop, block);
    this->Owner->Modified();
  }

  void RemoveAll(vitrine::ChosenParts& parts)
  {
    parts.RemoveAll();
    this->Owner->Modified();
  }

  bool IsSeen() const
  {
    return (this->Width > 0 && this->Opacity > 0.0) || this->FillOpacity > 0.0;
  }

  /** Draws the outlines over the frame that the renderer has drawn. */
  void Draw()
  {
    vtkRenderer* const renderer = this->Renderer;
    this->FallbackReason.clear();
    if (renderer->GetSelector() || !this->IsSeen())
    {
      return;
    }
    const std::vector<vtkProp*> props = this->Chosen.PropsIn(renderer);
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vitrine::PixelRegion viewport;
    renderer->GetTiledSizeAndOrigin(&viewport.Width, &viewport.Height, &viewport.X, &viewport.Y);
    if (props.empty() || !window || viewport.Width <= 0 || viewport.Height <= 0)
    {
      return;
    }
    const vitrine::PixelRegion region =
      vitrine::RegionOfParts(renderer, viewport, this->Chosen, props, this->Width + 1);
    if (region.Width <= 0 || region.Height <= 0)
    {
      return;
    }
    this->FallbackReason =
      this->Mask->Draw(renderer, viewport, region, this->Chosen, props, this->Excluded);
    if (this->FallbackReason.empty())
    {
      this->FallbackReason = this->DrawOver(window, viewport, region);
    }
    if (!this->FallbackReason.empty() && this->FallbackReason != this->ToldReason)
    {
      vtkWarningWithObjectMacro(
        this->Owner, << "Outlines cannot be drawn: " << this->FallbackReason << ".");
    }
    this->ToldReason = this->FallbackReason;
  }

  /** Draws the outlines of the mask into the framebuffer that is bound. Returns why the driver cannot. */
  std::string DrawOver(vtkOpenGLRenderWindow* window, const vitrine::PixelRegion& viewport,
    const vitrine::PixelRegion& region)
  {
    this->UseWindow(window);
    vtkOpenGLState* const state = window->GetState();
    const vitrine::ScopedTrackedState trackedState(state);
    const vitrine::ScopedShaderProgram shaderProgram(window);
    const vitrine::ScopedVertexArray vertexArray(this->Triangle.Handle());
    const vitrine::ScopedSampleMask allSamples;
    vitrine::ScopedFirstDrawBuffer firstDrawBuffer(state);
    const vitrine::ScopedTextureUnit mask(state, GL_TEXTURE_2D, this->Mask->Texture());
    vtkShaderProgram* const program =
      this->Programs.Ready(window, "PartOutlines", {}, vitrine::shaders::FullScreenVertex,
        [] { return std::string(vitrine::shaders::PartOutlines); });
    if (!program)
    {
      return vitrine::ProgramFailure;
    }
    vitrine::SetToBlendPixels(state, region);
    program->SetUniformi("vitrineMask", mask.Unit());
    program->SetUniformi("vitrineWidth", this->Width);
    this->SetColorUniform(program, "vitrineLine", this->Opacity);
    this->SetColorUniform(program, "vitrineTint", this->FillOpacity);
    glUniform4i(glGetUniformLocation(static_cast<GLuint>(program->GetHandle()), "vitrineViewport"),
      viewport.X, viewport.Y, viewport.Width, viewport.Height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return {};
  }

  void SetColorUniform(vtkShaderProgram* program, const char* name, double opacity) const
  {
    const float color[4] = { static_cast<float>(this->Color[0]), static_cast<float>(this->Color[1]),
      static_cast<float>(this->Color[2]), static_cast<float>(opacity) };
    program->SetUniform4f(name, color);
  }

  void UseWindow(vtkOpenGLRenderWindow* window)
  {
    if (!this->Context.LivesIn(window))
    {
      this->ReleaseProgram();
      this->Context.Hold(window);
    }
  }

  void Release()
  {
    this->Mask->ReleaseHeld();
    this->ReleaseProgram();
  }

  void ReleaseProgram()
  {
    this->Context.Release(
      [this](vtkOpenGLRenderWindow*)
      {
        this->Programs.Release();
        this->Triangle.Release();
      });
    this->Programs.Release();
    this->Triangle = vitrine::EmptyVertexArray();
    this->Context.LetGo();
  }
};

//------------------------------------------------------------------------------
vtkPartOutlines::vtkPartOutlines()
  : Private(new Internals)
{
  this->Private->Owner = this;
}

//------------------------------------------------------------------------------
// A renderer to which the object is attached keeps it alive. So there is none, or it is being deleted.
vtkPartOutlines::~vtkPartOutlines()
{
  this->Private->Release();
}

//------------------------------------------------------------------------------
void vtkPartOutlines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& in = *this->Private;
  os << indent << "NumberOfParts: " << in.Chosen.Size() << "\n";
  os << indent << "NumberOfExcludedParts: " << in.Excluded.Size() << "\n";
  os << indent << "Color: " << in.Color[0] << ", " << in.Color[1] << ", " << in.Color[2] << "\n";
  os << indent << "Opacity: " << in.Opacity << "\n";
  os << indent << "Width: " << in.Width << "\n";
  os << indent << "FillOpacity: " << in.FillOpacity << "\n";
  os << indent << "FallbackReason: " << in.FallbackReason << "\n";
}

//------------------------------------------------------------------------------
bool vtkPartOutlines::CanChoose(vtkProp* prop)
{
  return vitrine::ChosenParts::IsOfParts(prop);
}

//------------------------------------------------------------------------------
void vtkPartOutlines::AddPart(vtkProp* prop, int block)
{
  this->Private->Choose(this->Private->Chosen, "AddPart()", prop, block);
}

//------------------------------------------------------------------------------
void vtkPartOutlines::RemoveAllParts()
{
  this->Private->RemoveAll(this->Private->Chosen);
}

//------------------------------------------------------------------------------
int vtkPartOutlines::GetNumberOfParts()
{
  return static_cast<int>(this->Private->Chosen.Size());
}

//------------------------------------------------------------------------------
void vtkPartOutlines::AddExcludedPart(vtkProp* prop, int block)
{
  this->Private->Choose(this->Private->Excluded, "AddExcludedPart()", prop, block);
}

//------------------------------------------------------------------------------
void vtkPartOutlines::RemoveAllExcludedParts()
{
  this->Private->RemoveAll(this->Private->Excluded);
}

//------------------------------------------------------------------------------
void vtkPartOutlines::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  for (std::size_t i = 0; i < 3; ++i)
  {
    vitrine::SetInRange(this, "Color", this->Private->Color[i], color[i], Share);
  }
}

//------------------------------------------------------------------------------
const double* vtkPartOutlines::GetColor()
{
  return this->Private->Color.data();
}

//------------------------------------------------------------------------------
void vtkPartOutlines::SetOpacity(double opacity)
{
  vitrine::SetInRange(this, "Opacity", this->Private->Opacity, opacity, Share);
}

//------------------------------------------------------------------------------
double vtkPartOutlines::GetOpacity()
{
  return this->Private->Opacity;
}

//------------------------------------------------------------------------------
void vtkPartOutlines::SetWidth(int width)
{
  vitrine::SetInRange(
    this, "Width", this->Private->Width, width, vitrine::NumberRange<int>{ 0, 8 });
}

//------------------------------------------------------------------------------
int vtkPartOutlines::GetWidth()
{
  return this->Private->Width;
}

//------------------------------------------------------------------------------
void vtkPartOutlines::SetFillOpacity(double opacity)
{
  vitrine::SetInRange(this, "FillOpacity", this->Private->FillOpacity, opacity, Share);
}

//------------------------------------------------------------------------------
double vtkPartOutlines::GetFillOpacity()
{
  return this->Private->FillOpacity;
}

//------------------------------------------------------------------------------
void vtkPartOutlines::Attach(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkPartOutlines> alive = this;
  this->Detach();
  if (!renderer)
  {
    vtkErrorMacro("Attach() takes a renderer");
    return;
  }
  Internals& in = *this->Private;
  in.Renderer = renderer;
  vtkNew<EndOfFrame> observer;
  observer->Outlines = this;
  observer->Draw = [&in] { in.Draw(); };
  in.Observer = renderer->AddObserver(vtkCommand::EndEvent, observer, AfterOthers);
}

//------------------------------------------------------------------------------
void vtkPartOutlines::Detach()
{
  Internals& in = *this->Private;
  vtkRenderer* const renderer = in.Renderer; // It may be about to be deleted, so it is not held.
  in.Renderer = nullptr;
  if (renderer)
  {
    in.Release();
    renderer->RemoveObserver(
      in.Observer); // the observer may hold the last reference to this object
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkPartOutlines::GetRenderer()
{
  return this->Private->Renderer;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkPartOutlines::GetBytes()
{
  return this->Private->Mask->Bytes();
}

//------------------------------------------------------------------------------
const char* vtkPartOutlines::GetFallbackReason()
{
  return this->Private->FallbackReason.c_str();
}
