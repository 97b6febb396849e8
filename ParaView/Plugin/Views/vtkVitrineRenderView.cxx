#include "vtkVitrineRenderView.h"

#include "vtkABufferTransparencyPass.h"
#include "vtkClusteredLightsPass.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h"
#include "vtkSmartPointer.h"
#include "vtkTransparencyPass.h"

vtkStandardNewMacro(vtkVitrineRenderView);

namespace
{
constexpr vtkTypeInt64 Mebibyte = 1024 * 1024;

/** Returns why this process cannot draw exactly, or an empty string. */
std::string FindHindrance(bool tiles, bool cave)
{
  const int ranks = vtkProcessModule::GetProcessModule()->GetNumberOfLocalPartitions();
  if (ranks > 1)
  {
    return "Vitrine draws on one rank, and these are " + std::to_string(ranks) +
      ", so ParaView itself draws this view. Start the server or pvbatch with one rank, or draw "
      "on the client: Edit, Settings, Render View, Remote Render Threshold";
  }
  if (tiles || cave)
  {
    return std::string("Vitrine does not draw ") + (tiles ? "on tiled displays" : "in a CAVE") +
      ", so ParaView itself draws this view";
  }
  return {};
}
}

struct vtkVitrineRenderView::Internals
{
  vtkNew<vtkSeeThroughPass> Frame;
  vtkNew<vtkClusteredLightsPass> Lights;
  std::string Hindrance; ///< Why this process draws as ParaView does.
  bool IsTold = false;   ///< The hindrance was told.
  std::string Text;      ///< Buffer of the text that GetFallbackReason() returned.
  double ErrorBudget = 1.0 / 255.0;
  int ColorStorage = vtkABufferTransparencyPass::HALF_FLOAT;
  vtkTypeInt64 MemoryLimit = 0;
  double CoincidenceSteps = 0.0;
  double CoincidenceSlope = 0.0;

  vtkTransparencyPass* Method()
  {
    return vtkTransparencyPass::SafeDownCast(this->Frame->GetTranslucentPass());
  }

  /** Gives the method those of the settings that it has. */
  void Configure()
  {
    auto* const method = this->Method();
    if (auto* const tolerant = vtkTolerantTransparencyPass::SafeDownCast(method))
    {
      tolerant->SetCoincidenceSteps(this->CoincidenceSteps);
      tolerant->SetCoincidenceSlope(this->CoincidenceSlope);
    }
    if (auto* const lists = vtkABufferTransparencyPass::SafeDownCast(method))
    {
      lists->SetMemoryLimit(this->MemoryLimit);
    }
    if (auto* const budget = vtkErrorBudgetTransparencyPass::SafeDownCast(method))
    {
      budget->SetErrorBudget(this->ErrorBudget);
    }
    else if (auto* const lists = vtkABufferTransparencyPass::SafeDownCast(method))
    {
      lists->SetColorStorage(this->ColorStorage);
    }
  }
};

//------------------------------------------------------------------------------
vtkVitrineRenderView::vtkVitrineRenderView()
  : Private(new Internals)
{
  Internals& in = *this->Private;
  in.Hindrance = FindHindrance(this->InTileDisplayMode(), this->InCaveDisplayMode());
  if (in.Hindrance.empty())
  {
    this->SynchronizedRenderers->SetRenderPass(in.Frame);
  }
}

//------------------------------------------------------------------------------
vtkVitrineRenderView::~vtkVitrineRenderView() = default;

//------------------------------------------------------------------------------
void vtkVitrineRenderView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FallbackReason: " << this->GetFallbackReason() << "\n";
  this->Private->Frame->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetTransparencyMethod(const char* name)
{
  Internals& in = *this->Private;
  const std::string wanted = name ? name : "";
  if (wanted == in.Method()->GetMethodName())
  {
    return;
  }
  const auto method =
    vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod(wanted));
  if (!method)
  {
    vtkErrorMacro("There is no method \"" << wanted << "\". The methods are "
                                          << vtkTransparencyPass::GetMethods());
    return;
  }
  in.Frame->SetTranslucentPass(method);
  in.Configure();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetErrorBudget(double budget)
{
  this->Private->ErrorBudget = budget;
  this->Private->Configure();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetColorStorage(int storage)
{
  this->Private->ColorStorage = storage;
  this->Private->Configure();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetMemoryLimit(int mebibytes)
{
  this->Private->MemoryLimit = mebibytes * Mebibyte;
  this->Private->Configure();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetCoincidenceSteps(double steps)
{
  this->Private->CoincidenceSteps = steps;
  this->Private->Configure();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetCoincidenceSlope(double slope)
{
  this->Private->CoincidenceSlope = slope;
  this->Private->Configure();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetClusteredLights(bool clustered)
{
  Internals& in = *this->Private;
  in.Frame->SetLightingPass(clustered ? in.Lights.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetMaximumNumberOfPeels(int)
{
  this->Superclass::SetMaximumNumberOfPeels(VTK_INT_MAX);
}

//------------------------------------------------------------------------------
const char* vtkVitrineRenderView::GetFallbackReason()
{
  Internals& in = *this->Private;
  in.Text = in.Hindrance.empty() ? in.Frame->GetFallbackReason() : in.Hindrance;
  return in.Text.c_str();
}

//------------------------------------------------------------------------------
vtkIdType vtkVitrineRenderView::GetNumberOfFragments()
{
  return this->Private->Method()->GetNumberOfFragments();
}

//------------------------------------------------------------------------------
vtkIdType vtkVitrineRenderView::GetMaximumNumberOfLayers()
{
  return this->Private->Method()->GetMaximumNumberOfLayers();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  Internals& in = *this->Private;
  if (!in.Hindrance.empty() && !in.IsTold)
  {
    in.IsTold = true;
    vtkErrorMacro(<< in.Hindrance);
  }
}
