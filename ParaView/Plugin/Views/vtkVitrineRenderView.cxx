#include "vtkVitrineRenderView.h"

#include "FrameAnswers.h"
#include "LayersUnderPixel.h"
#include "RanksOfView.h"
#include "SectionOfView.h"

#include "vtkABufferTransparencyPass.h"
#include "vtkClusteredLightsPass.h"
#include "vtkCompositeRepresentation.h"
#include "vtkCullerCollection.h"
#include "vtkDoubleArray.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkFloatArray.h"
#include "vtkHierarchicalSBufferCuller.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVSession.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTransparencyPass.h"

#include <optional>
#include <string>

vtkStandardNewMacro(vtkVitrineRenderView);

namespace
{
constexpr vtkTypeInt64 Mebibyte = 1024 * 1024;

/** Returns why this process cannot draw exactly, or an empty string. */
std::string FindHindrance(bool tiles, bool cave)
{
  if (tiles || cave)
  {
    return std::string("Vitrine does not draw ") + (tiles ? "on tiled displays" : "in a CAVE") +
      ", so ParaView itself draws this view";
  }
  return {};
}

/** Returns true if a visible representation shows a volume, or the one that is chosen among several does. */
bool IsVolume(vtkDataRepresentation* representation)
{
  auto* shown = vtkPVDataRepresentation::SafeDownCast(representation);
  if (auto* const several = vtkCompositeRepresentation::SafeDownCast(shown))
  {
    shown = several->GetActiveRepresentation();
  }
  return shown && shown->GetVisibility() &&
    std::string(shown->GetClassName()).find("Volume") != std::string::npos;
}
}

struct vtkVitrineRenderView::Internals
{
  vtkNew<vtkSeeThroughPass> Frame;
  vtkNew<vtkClusteredLightsPass> Lights;
  vtkNew<vtkHierarchicalSBufferCuller> Culler;
  vtkSmartPointer<vtkTransparencyPass> Method; ///< draws the translucent geometry of one rank
  std::optional<vitrine::RanksOfView> Ranks;   ///< none where this process is the only one
  std::string Hindrance; ///< Why this process never draws but as ParaView does.
  std::string Reason;    ///< Why ParaView draws this frame, or empty.
  std::string Told;      ///< the last reason that was told
  vitrine::SectionOfView Section;
  vitrine::LayersUnderPixel Layers;
  vitrine::FrameAnswers Answers;  ///< of the last frame
  vtkNew<vtkStringArray> Texts;   ///< buffer of texts of layers that were asked for
  vtkNew<vtkDoubleArray> Numbers; ///< buffer of numbers of layers that were asked for

  double ErrorBudget = 1.0 / 255.0;
  int ColorStorage = vtkABufferTransparencyPass::HALF_FLOAT;
  vtkTypeInt64 MemoryLimit = 0;
  double CoincidenceSteps = 0.0;
  double CoincidenceSlope = 0.0;

  /** Returns the method that draws, that of all ranks where there are several. */
  vtkTransparencyPass* Drawing() { return this->Ranks ? this->Ranks->Pass() : this->Method.Get(); }

  /** Changes a setting of the method. */
  template <class Value>
  void Set(Value Internals::*setting, Value value)
  {
    this->*setting = value;
    this->Configure();
  }

  /** Returns what is told about the frame that this process has drawn. */
  vitrine::FrameAnswers AnswersOf(vtkRenderer* renderer)
  {
    vitrine::FrameAnswers answers;
    if (!this->Reason.empty())
    {
      answers.Reason = answers.LayersProblem = this->Reason;
      return answers;
    }
    answers.Reason = this->Frame->GetFallbackReason();
    if (this->Section.Section->GetRenderer() && answers.Reason.empty())
    {
      answers.Reason = this->Section.Section->GetFallbackReason();
    }
    answers.Fragments = this->Drawing()->GetNumberOfFragments();
    answers.MostLayers = this->Drawing()->GetMaximumNumberOfLayers();
    if (renderer->GetCullers()->IsItemPresent(this->Culler))
    {
      answers.CullingReason = this->Culler->GetReason();
      answers.CulledParts = this->Culler->GetNumberOfCulledParts();
    }
    vtkMultiProcessController* const ranks =
      this->Ranks ? this->Ranks->Pass()->GetController() : nullptr;
    this->Layers.Find(renderer, ranks, answers);
    if (ranks)
    {
      this->TakeAnswersOf(ranks, answers);
    }
    return answers;
  }

  /** Adds what other ranks tell. A part that is divided among ranks is open on each, and then has no right cap. */
  void TakeAnswersOf(vtkMultiProcessController* ranks, vitrine::FrameAnswers& answers)
  {
    for (const auto& [actor, block] : this->Section.FindOpenParts())
    {
      answers.OpenParts.emplace_back(this->Layers.RepresentationOf(actor), block);
    }
    answers.Gather(ranks);
    if (answers.DividedParts > 0 && answers.Reason.empty())
    {
      answers.Reason =
        "caps may be incomplete, since parts that the section cuts are divided among "
        "ranks and not closed on each (" +
        std::to_string(answers.DividedParts) + " of them); set SectionCaps to 0";
    }
  }

  template <class Value>
  vtkDoubleArray* NumbersOf(Value vitrine::LayerOfPixel::*value)
  {
    this->Numbers->Reset();
    for (const vitrine::LayerOfPixel& layer : this->Answers.Layers)
    {
      this->Numbers->InsertNextValue(layer.*value);
    }
    return this->Numbers;
  }

  /** Gives the method those of the settings that it has. */
  void Configure()
  {
    vtkTransparencyPass* const method = this->Drawing();
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
  in.Method = vtkTransparencyPass::SafeDownCast(in.Frame->GetTranslucentPass());
  if (in.Hindrance.empty() && vitrine::RanksOfView::Draw(this->SynchronizedRenderers))
  {
    in.Ranks.emplace(this->GetSession(), in.Frame);
    in.Frame->SetTranslucentPass(in.Ranks->Pass());
    in.Culler->AddKnownPass(vitrine::RanksOfView::ClassOfPass);
  }
  else if (in.Hindrance.empty())
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
  if (wanted == in.Method->GetMethodName())
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
  in.Method = method;
  in.Frame->SetTranslucentPass(in.Drawing());
  in.Configure();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetErrorBudget(double budget)
{
  this->Private->Set(&Internals::ErrorBudget, budget);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetColorStorage(int storage)
{
  this->Private->Set(&Internals::ColorStorage, storage);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetMemoryLimit(int mebibytes)
{
  this->Private->Set(&Internals::MemoryLimit, mebibytes * Mebibyte);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetCoincidenceSteps(double steps)
{
  this->Private->Set(&Internals::CoincidenceSteps, steps);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetCoincidenceSlope(double slope)
{
  this->Private->Set(&Internals::CoincidenceSlope, slope);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetClusteredLights(bool clustered)
{
  Internals& in = *this->Private;
  in.Frame->SetLightingPass(clustered ? in.Lights.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetCulling(bool culls)
{
  vtkHierarchicalSBufferCuller* const culler = this->Private->Culler;
  this->GetRenderer()->RemoveCuller(culler);
  if (culls && this->Private->Hindrance.empty())
  {
    this->GetRenderer()->AddCuller(
      culler); // after ParaView's own, which leaves out all if a server draws
  }
  this->Modified();
}

//------------------------------------------------------------------------------
const char* vtkVitrineRenderView::GetCullingReason()
{
  return this->Private->Answers.CullingReason.c_str();
}

//------------------------------------------------------------------------------
vtkIdType vtkVitrineRenderView::GetNumberOfCulledParts()
{
  return this->Private->Answers.CulledParts;
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionPlane(bool cuts)
{
  this->Private->Section.HasPlane = cuts;
  this->UpdateSection();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionOrigin(double x, double y, double z)
{
  this->Private->Section.Plane->SetOrigin(x, y, z);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionNormal(double x, double y, double z)
{
  this->Private->Section.Plane->SetNormal(x, y, z);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::AddSectionPlane(
  double originX, double originY, double originZ, double normalX, double normalY, double normalZ)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(originX, originY, originZ);
  plane->SetNormal(normalX, normalY, normalZ);
  this->Private->Section.Others.emplace_back(plane);
  this->UpdateSection();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::RemoveSectionPlanes()
{
  this->Private->Section.Others.clear();
  this->UpdateSection();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionBox(int box)
{
  this->Private->Section.Box = box;
  this->UpdateSection();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  this->Private->Section.Bounds = { xmin, xmax, ymin, ymax, zmin, zmax };
  this->UpdateSection();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionRemoveBeyondAll(bool all)
{
  this->Private->Section.Section->SetRemoveBeyondAll(all);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionCaps(bool caps)
{
  this->Private->Section.Section->SetCaps(caps);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionInterference(bool stripes)
{
  this->Private->Section.Section->SetInterferenceStripes(stripes);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionHatch(int hatch)
{
  this->Private->Section.Section->SetHatch(hatch);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionHatchSpacing(double spacing)
{
  this->Private->Section.Section->SetHatchSpacing(spacing);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetSectionEdgeWidth(int width)
{
  this->Private->Section.Section->SetEdgeWidth(width);
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::UpdateSection()
{
  if (this->Private->Hindrance.empty())
  {
    this->Private->Section.Update(this->GetRenderer());
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetLayersPixel(int x, int y)
{
  this->Private->Layers.Pixel = { x, y };
  this->Modified();
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVitrineRenderView::GetLayerSources()
{
  Internals& in = *this->Private;
  in.Texts->Reset();
  for (const vitrine::LayerOfPixel& layer : in.Answers.Layers)
  {
    in.Texts->InsertNextValue(this->NameOfSource(layer.Representation));
  }
  return in.Texts;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVitrineRenderView::GetLayerBlocks()
{
  Internals& in = *this->Private;
  in.Texts->Reset();
  for (const vitrine::LayerOfPixel& layer : in.Answers.Layers)
  {
    in.Texts->InsertNextValue(layer.Block);
  }
  return in.Texts;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkVitrineRenderView::GetLayerDepths()
{
  return this->Private->NumbersOf(&vitrine::LayerOfPixel::Depth);
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkVitrineRenderView::GetLayerDistances()
{
  return this->Private->NumbersOf(&vitrine::LayerOfPixel::Distance);
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkVitrineRenderView::GetLayerShares()
{
  return this->Private->NumbersOf(&vitrine::LayerOfPixel::Share);
}

//------------------------------------------------------------------------------
const char* vtkVitrineRenderView::GetLayersProblem()
{
  return this->Private->Answers.LayersProblem.c_str();
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::SetMaximumNumberOfPeels(int)
{
  this->Superclass::SetMaximumNumberOfPeels(VTK_INT_MAX);
}

//------------------------------------------------------------------------------
const char* vtkVitrineRenderView::GetFallbackReason()
{
  return this->Private->Answers.Reason.c_str();
}

//------------------------------------------------------------------------------
vtkIdType vtkVitrineRenderView::GetNumberOfFragments()
{
  return this->Private->Answers.Fragments;
}

//------------------------------------------------------------------------------
vtkIdType vtkVitrineRenderView::GetMaximumNumberOfLayers()
{
  return this->Private->Answers.MostLayers;
}

//------------------------------------------------------------------------------
std::string vtkVitrineRenderView::NameOfSource(unsigned int representation)
{
  for (int i = 0; i < this->GetNumberOfRepresentations(); ++i)
  {
    auto* const shown = vtkPVDataRepresentation::SafeDownCast(this->GetRepresentation(i));
    if (shown && shown->GetUniqueIdentifier() == representation)
    {
      return vitrine::NameOfSource(shown);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::AddRepresentationInternal(vtkDataRepresentation* representation)
{
  this->Superclass::AddRepresentationInternal(representation);
  this->Private->Layers.Note(
    vtkPVDataRepresentation::SafeDownCast(representation), this->GetRenderer());
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::AboutToRenderOnLocalProcess(bool interactive)
{
  this->Superclass::AboutToRenderOnLocalProcess(interactive);
  Internals& in = *this->Private;
  const bool isFirst = !in.Ranks || in.Ranks->Pass()->GetController()->GetLocalProcessId() == 0;
  if (isFirst && !in.Reason.empty() && in.Reason != in.Told)
  {
    vtkErrorMacro(<< in.Reason);
  }
  in.Told = in.Reason;
  if (!in.Reason.empty() || this->GetMakingSelection())
  {
    return;
  }
  // ParaView has a pass that smooths a processed picture.
  if (this->SynchronizedRenderers->GetImageProcessingPass())
  {
    this->GetRenderer()->SetUseFXAA(false);
  }
  if (in.Ranks)
  {
    in.Ranks->PrepareToDraw(this->GetRenderer());
  }
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::Render(bool interactive, bool skipRendering)
{
  Internals& in = *this->Private;
  if (this->GetMakingSelection() && in.Ranks)
  {
    this->RenderInNoOrder(interactive, skipRendering);
    return;
  }
  if (skipRendering || this->GetMakingSelection())
  {
    this->Superclass::Render(interactive, skipRendering);
    return;
  }
  in.Reason = in.Ranks ? this->FindHindranceOfRanks(interactive) : in.Hindrance;
  if (in.Ranks && in.Reason.empty())
  {
    this->RenderTogether(interactive);
  }
  else
  {
    this->Superclass::Render(interactive, skipRendering);
  }
  in.Answers = in.AnswersOf(this->GetRenderer());
  // One of several clients may have told this while the frame was drawn.
  if (this->IsDistributed(interactive))
  {
    in.Answers.Exchange(this->GetSession());
  }
}

//------------------------------------------------------------------------------
// Returns whether a server, or all ranks of pvbatch, draw the view.
bool vtkVitrineRenderView::IsDistributed(bool interactive)
{
  return interactive && this->GetUseLODForInteractiveRender()
    ? this->GetUseDistributedRenderingForLODRender()
    : this->GetUseDistributedRenderingForRender();
}

//------------------------------------------------------------------------------
// Returns why the ranks cannot draw this frame together, the same on all of them.
std::string vtkVitrineRenderView::FindHindranceOfRanks(bool interactive)
{
  if (!this->IsDistributed(interactive))
  {
    return "ParaView draws this view on one of several ranks";
  }
  if (this->SynchronizedRenderers->GetRenderPass())
  {
    return "ParaView draws this view by ray tracing, or captures values";
  }
  if (this->UseSSAO)
  {
    return "Vitrine does not draw ambient occlusion on several ranks, so ParaView itself draws "
           "this view. Set UseAmbientOcclusion to 0, or start the server or pvbatch with one rank";
  }
  for (int i = 0; i < this->GetNumberOfRepresentations(); ++i)
  {
    if (IsVolume(this->GetRepresentation(i)))
    {
      return "Vitrine does not draw volumes on several ranks, so ParaView itself draws this view. "
             "Hide the volumes, or start the server or pvbatch with one rank";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Draws a frame on all ranks.
void vtkVitrineRenderView::RenderTogether(bool interactive)
{
  const vitrine::RanksOfView::Frame frame(
    *this->Private->Ranks, this->GetRenderer(), this->SynchronizedRenderers);
  this->RenderInNoOrder(interactive, false);
}

//------------------------------------------------------------------------------
// Draws a frame for which ranks need no order, so that no geometry is moved. Selections need none either.
void vtkVitrineRenderView::RenderInNoOrder(bool interactive, bool skipRendering)
{
  const bool needsOrder = this->NeedsOrderedCompositing;
  this->NeedsOrderedCompositing = false;
  this->Superclass::Render(interactive, skipRendering);
  this->NeedsOrderedCompositing = needsOrder;
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::CaptureZBuffer()
{
  Internals& in = *this->Private;
  if (!in.Ranks || !in.Reason.empty())
  {
    this->Superclass::CaptureZBuffer();
  }
  else if (vtkFloatArray* const depths = in.Ranks->Depths())
  {
    this->GetCapturedZBuffer()->DeepCopy(depths);
  }
}

//------------------------------------------------------------------------------
void vtkVitrineRenderView::ConfigureCompressor(const char* configuration)
{
  this->Superclass::ConfigureCompressor(configuration);
  if (this->Private->Ranks)
  {
    this->Private->Ranks->ConfigureCompressor(configuration);
  }
}
