#include "vtkPartXRay.h"

#include "Shaders/SharedLayout.h"
#include "look/ChosenParts.h"
#include "look/XRayShader.h"
#include "scene/AnswerEvent.h"
#include "scene/ExactParts.h"
#include "scene/FadedLooks.h"
#include "scene/FrameObserver.h"
#include "scene/ListedPass.h"
#include "scene/PartNumbers.h"
#include "scene/SceneTime.h"
#include "scene/Settings.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkDataObjectTree.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkPartXRay);

namespace
{

/** Event by which a renderer's observers are asked for the x-ray that is attached to it. */
constexpr unsigned long AskForXRay = vtkCommand::UserEvent + 0x56495458;

void TellXRay(vtkObject*, unsigned long, void* xray, void* asked)
{
  *static_cast<vtkPartXRay**>(asked) = static_cast<vtkPartXRay*>(xray);
}

void TellExactParts(vtkObject*, unsigned long, void* chosen, void* asked)
{
  static_cast<const vitrine::ChosenParts*>(chosen)->AddPropsTo(
    static_cast<vitrine::ExactParts*>(asked)->Props);
}
}

struct vtkPartXRay::Internals
{
  vitrine::ChosenParts Chosen;
  vtkNew<vitrine::XRayShader> Shader;
  vitrine::ListedPass Listed{ this->Shader };
  vitrine::FadedLooks Looks;

  vtkPartXRay* Owner = nullptr;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vitrine::FrameObserver> Observer;
  unsigned long Answers[2]{};
  unsigned long Deletion = 0; ///< observer of the renderer's end
  vtkMTimeType LooksTime = 0; ///< when looks were set last

  void StartFrame()
  {
    vtkRenderer* const renderer = this->Renderer;
    this->EndFrame();
    const std::vector<vtkProp*> props = this->Chosen.PropsIn(renderer);
    this->SetLooks(props);
    for (vtkProp* prop : props)
    {
      this->Listed.List(prop);
    }
    this->Shader->Begin(renderer, this->Chosen, props);
  }

  void EndFrame()
  {
    this->Listed.Unlist();
    this->Shader->End();
  }

  /** Returns when the x-ray, its props or the renderer's list of props changed last. */
  vtkMTimeType NewestTime(const std::vector<vtkProp*>& props) const
  {
    vtkMTimeType newest =
      std::max(this->Owner->GetMTime(), this->Renderer->GetViewProps()->GetMTime());
    for (vtkProp* prop : props)
    {
      newest = std::max(newest, vitrine::NewestTimeOf(prop));
    }
    return newest;
  }

  /** A frame may change what it draws, as mappers do whose blocks have got other opacities. */
  void NoteFrame()
  {
    vtkRenderer* const renderer = this->Renderer;
    if (renderer)
    {
      this->LooksTime = std::max(this->LooksTime, this->NewestTime(this->Chosen.PropsIn(renderer)));
    }
  }

  /** Makes opaque parts translucent, unless nothing has changed since. */
  void SetLooks(const std::vector<vtkProp*>& props)
  {
    if (this->NewestTime(props) <= this->LooksTime)
    {
      return;
    }
    if (this->Renderer->GetViewProps()->GetMTime() > this->LooksTime)
    {
      this->Looks.PutBackAll(); // of props that have left the renderer, too
    }
    this->Looks.ForgetNodes();
    for (vtkProp* prop : props)
    {
      this->SetLooksOf(vtkActor::SafeDownCast(prop));
    }
    vtkTimeStamp now;
    now.Modified();
    this->LooksTime = now.GetMTime();
  }

  void SetLooksOf(vtkActor* actor)
  {
    const std::uint32_t first = vitrine::PartNumbers::Of(this->Renderer).FirstOf(actor);
    const std::vector<std::uint32_t> chosen = this->Chosen.NumbersOf(actor);
    const std::vector<vitrine::BlockNode> nodes = vitrine::BlockNodesOf(actor);
    for (std::uint32_t block = 0; block < chosen.size(); ++block)
    {
      const bool isLeaf = nodes.empty() ||
        (block < nodes.size() && nodes[block].Data &&
          !vtkDataObjectTree::SafeDownCast(nodes[block].Data));
      if (chosen[block] == 0 || !isLeaf)
      {
        continue;
      }
      const vitrine::ShownPart part{ actor, block };
      if (this->Looks.OriginalOf(part) >= VITRINE_XRAY_OPAQUE)
      {
        this->Looks.Set(first + block, part, VITRINE_XRAY_ALMOST_OPAQUE);
      }
      else
      {
        this->Looks.PutBack(first + block);
      }
    }
  }
};

//------------------------------------------------------------------------------
vtkPartXRay::vtkPartXRay()
  : Private(new Internals)
{
  this->Private->Owner = this;
}

//------------------------------------------------------------------------------
// A renderer to which the object is attached keeps it alive. So there is none, or it is being deleted.
vtkPartXRay::~vtkPartXRay()
{
  this->Private->EndFrame();
}

//------------------------------------------------------------------------------
void vtkPartXRay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfParts: " << this->GetNumberOfParts() << "\n";
  os << indent << "Floor: " << this->GetFloor() << "\n";
  os << indent << "Falloff: " << this->GetFalloff() << "\n";
}

//------------------------------------------------------------------------------
bool vtkPartXRay::CanChoose(vtkProp* prop)
{
  return vtkActor::SafeDownCast(prop) != nullptr;
}

//------------------------------------------------------------------------------
void vtkPartXRay::AddPart(vtkProp* prop, int block)
{
  if (!CanChoose(prop))
  {
    vtkErrorMacro(
      "AddPart() takes an actor, and cannot take " << (prop ? prop->GetClassName() : "null"));
    return;
  }
  this->Private->Chosen.Add(prop, block);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPartXRay::RemoveAllParts()
{
  this->Private->Chosen.RemoveAll();
  this->Private->Looks.PutBackAll();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPartXRay::GetNumberOfParts()
{
  return static_cast<int>(this->Private->Chosen.Size());
}

//------------------------------------------------------------------------------
void vtkPartXRay::SetFloor(double floor)
{
  vitrine::SetInRange(
    this, "Floor", this->Private->Shader->Floor, floor, vitrine::NumberRange<double>{ 0.0, 1.0 });
}

//------------------------------------------------------------------------------
double vtkPartXRay::GetFloor()
{
  return this->Private->Shader->Floor;
}

//------------------------------------------------------------------------------
void vtkPartXRay::SetFalloff(double falloff)
{
  vitrine::SetInRange(this, "Falloff", this->Private->Shader->Falloff, falloff,
    vitrine::NumberRange<double>{ 0.0, 16.0 });
}

//------------------------------------------------------------------------------
double vtkPartXRay::GetFalloff()
{
  return this->Private->Shader->Falloff;
}

//------------------------------------------------------------------------------
void vtkPartXRay::Attach(vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkPartXRay> alive = this;
  this->Detach();
  if (!renderer)
  {
    vtkErrorMacro("Attach() takes a renderer");
    return;
  }
  if (vtkPartXRay* const other = GetAttached(renderer))
  {
    other->Detach();
  }
  Internals& in = *this->Private;
  in.Renderer = renderer;
  in.LooksTime = 0;
  in.Observer = vtkSmartPointer<vitrine::FrameObserver>::New();
  in.Observer->Start = [&in] { in.StartFrame(); };
  in.Observer->End = [&in]
  {
    in.EndFrame();
    in.NoteFrame();
  };
  in.Observer->Watch(renderer, this);
  in.Answers[0] = vitrine::AddAnswer(renderer, AskForXRay, TellXRay, this);
  in.Answers[1] =
    vitrine::AddAnswer(renderer, vitrine::AskForExactParts, TellExactParts, &in.Chosen);
  in.Deletion =
    renderer->AddObserver(vtkCommand::DeleteEvent, this, &vtkPartXRay::WhenRendererIsDeleted);
}

//------------------------------------------------------------------------------
void vtkPartXRay::Detach()
{
  Internals& in = *this->Private;
  in.EndFrame();
  in.Looks.PutBackAll();
  vtkRenderer* const renderer = in.Renderer; // It may be about to be deleted, so it is not held.
  in.Renderer = nullptr;
  if (renderer)
  {
    in.Shader->Release();
    for (const unsigned long answer : in.Answers)
    {
      renderer->RemoveObserver(answer);
    }
    renderer->RemoveObserver(in.Deletion);
    const vtkSmartPointer<vitrine::FrameObserver> observer = std::move(in.Observer);
    observer->Leave(renderer); // it may hold the last reference to this object
  }
}

//------------------------------------------------------------------------------
void vtkPartXRay::WhenRendererIsDeleted()
{
  this->Private->EndFrame();
  this->Private->Looks.PutBackAll();
}

//------------------------------------------------------------------------------
vtkRenderer* vtkPartXRay::GetRenderer()
{
  return this->Private->Renderer;
}

//------------------------------------------------------------------------------
vtkPartXRay* vtkPartXRay::GetAttached(vtkRenderer* renderer)
{
  vtkPartXRay* attached = nullptr;
  if (renderer)
  {
    renderer->InvokeEvent(AskForXRay, &attached);
  }
  return attached;
}
