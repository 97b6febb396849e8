#include "gl/OuterPasses.h"

#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

#include <memory>
#include <optional>

namespace vitrine
{
namespace
{

GLuint BoundForDrawing()
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  return static_cast<GLuint>(framebuffer);
}

}

// Data that Enter and Leave share.
struct OuterPasses::Target
{
  vtkOpenGLState* State = nullptr;
  GLuint Framebuffer = 0; // The framebuffer on which outer passes rely.
  GLuint Drawn = 0;       // The framebuffer bound when outer passes were about to be called.
  // None where VTK's own framebuffer has one colour image, until outer passes may set its draw buffers.
  std::optional<ScopedFirstDrawBuffer> DrawBuffers;
  bool HasFurtherOutputs = false;

  // Returns true if outer passes may set draw buffers. Otherwise the binding of framebuffers for each draw is saved.
  bool IsTouched() const
  {
    return this->HasFurtherOutputs || (this->DrawBuffers && this->DrawBuffers->HasOthers());
  }
};

// Comes first among a prop's passes. Passes change shaders in this order; Enter and Leave change none.
class OuterPasses::Enter : public vtkOpenGLRenderPass
{
public:
  static Enter* New() { VTK_STANDARD_NEW_BODY(Enter); }
  vtkTypeMacro(Enter, vtkOpenGLRenderPass);
  void Render(const vtkRenderState*) override {}

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    Target& target = *this->Common;
    if (target.IsTouched())
    {
      target.Drawn = BoundForDrawing();
      target.State->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.Framebuffer);
      if (!target.DrawBuffers)
      {
        target.DrawBuffers.emplace(target.State);
      }
    }
    return true;
  }

  const std::shared_ptr<Target> Common = std::make_shared<Target>();
};

// Comes after the outer passes.
class OuterPasses::Leave : public vtkOpenGLRenderPass
{
public:
  static Leave* New() { VTK_STANDARD_NEW_BODY(Leave); }
  vtkTypeMacro(Leave, vtkOpenGLRenderPass);
  void Render(const vtkRenderState*) override {}

  bool SetShaderParameters(
    vtkShaderProgram*, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    Target& target = *this->Common;
    if (target.IsTouched())
    {
      target.DrawBuffers->Confine();
      target.State->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.Drawn);
    }
    return true;
  }

  std::shared_ptr<Target> Common;
};

OuterPasses::OuterPasses()
  : First(vtkSmartPointer<Enter>::New())
  , Last(vtkSmartPointer<Leave>::New())
{
  this->Last->Common = this->First->Common;
}

OuterPasses::~OuterPasses() = default;

void OuterPasses::ExpectFurtherOutputs()
{
  this->First->Common->HasFurtherOutputs = true;
}

OuterPasses::Scope::Scope(
  OuterPasses& passes, const vtkRenderState* s, vtkOpenGLRenderWindow* window)
  : Passes(passes)
{
  Target& target = *this->Passes.First->Common;
  target.Framebuffer = BoundName(GL_DRAW_FRAMEBUFFER_BINDING, 0);
  if (target.Framebuffer != 0)
  {
    target.State = window->GetState();
    if (!HasOneColorOfVTK(window, target.Framebuffer))
    {
      target.DrawBuffers.emplace(target.State);
    }
    this->Passes.Surround(s);
  }
}

OuterPasses::Scope::~Scope()
{
  this->Passes.Restore();
  this->Passes.First->Common->DrawBuffers.reset();
}

// Several props may share the same property keys.
void OuterPasses::Surround(const vtkRenderState* s)
{
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkInformation* const info = s->GetPropArray()[i]->GetPropertyKeys();
    if (!info || info->Length(key) == 0 || info->Get(key, 0) == this->First)
    {
      continue;
    }
    PassList outer;
    for (int pass = 0; pass < info->Length(key); ++pass)
    {
      outer.emplace_back(info->Get(key, pass));
    }
    info->Remove(key);
    info->Append(key, this->First);
    for (const auto& pass : outer)
    {
      info->Append(key, pass);
    }
    info->Append(key, this->Last);
    this->Lists.emplace_back(info, outer);
  }
}

void OuterPasses::Restore()
{
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  for (const auto& [info, outer] : this->Lists)
  {
    info->Remove(key);
    for (const auto& pass : outer)
    {
      info->Append(key, pass);
    }
  }
  this->Lists.clear();
}

}
