#include "methods/VitrineMethods.h"

#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h"
#include "vtkStencilMaskTransparencyPass.h"
#include "vtkStencilRoutedTransparencyPass.h"
#include "vtkTolerantTransparencyPass.h"

namespace program
{

VitrineMethod::VitrineMethod(vtkSmartPointer<vtkTransparencyPass> pass)
  : Pass(pass)
{
}

void VitrineMethod::Attach(vtkRenderer* renderer)
{
  vtkNew<vtkSeeThroughPass> steps;
  steps->SetTranslucentPass(this->Pass);
  if (this->Opaque)
  {
    this->Opaque->SetStage("opaque", steps->GetOpaquePass());
    steps->SetOpaquePass(this->Opaque);
  }
  renderer->SetPass(steps);
}

std::string VitrineMethod::SetCoincidence(const Coincidence& coincidence)
{
  if (auto* tolerant = vtkTolerantTransparencyPass::SafeDownCast(this->Pass))
  {
    tolerant->SetCoincidenceSteps(coincidence.Steps);
    tolerant->SetCoincidenceSlope(coincidence.Slope);
    return "";
  }
  return this->Method::SetCoincidence(coincidence);
}

void VitrineMethod::MeasureStages()
{
  this->Pass->SetMeasureStages(true);
  this->Opaque = vtkSmartPointer<TimedPass>::New();
}

MethodStatistics VitrineMethod::Statistics() const
{
  MethodStatistics statistics;
  statistics.Fragments = this->Pass->GetNumberOfFragments();
  statistics.Lost = this->Pass->GetNumberOfLostFragments();
  statistics.LostIsLeast = this->Pass->GetNumberOfSaturatedPixels() > 0;
  statistics.LayersMax = this->Pass->GetMaximumNumberOfLayers();
  statistics.LayersMean = this->Pass->GetMeanNumberOfLayers();
  statistics.GeometryPasses = this->Pass->GetNumberOfGeometryPasses();
  statistics.Bytes = this->Pass->GetBytes();
  if (this->Opaque)
  {
    statistics.Stages = this->Opaque->Times();
  }
  for (int stage = 0; stage < this->Pass->GetNumberOfStages(); ++stage)
  {
    statistics.Stages.emplace_back(
      this->Pass->GetStageName(stage), 1000.0 * this->Pass->GetStageTime(stage));
  }
  return statistics;
}

std::string VitrineMethod::WhyNotRun() const
{
  return this->Pass->GetFallbackReason();
}

AutomaticMethod::AutomaticMethod(vtkSmartPointer<vtkErrorBudgetTransparencyPass> pass)
  : VitrineMethod(pass)
{
}

std::string AutomaticMethod::SetErrorBudget(double budget)
{
  this->GetBudgetPass()->SetErrorBudget(budget);
  return "";
}

MethodStatistics AutomaticMethod::Statistics() const
{
  MethodStatistics statistics = this->VitrineMethod::Statistics();
  vtkErrorBudgetTransparencyPass* const pass = this->GetBudgetPass();
  if (!pass->GetChosenMethod().empty())
  {
    statistics.Chosen = pass->GetChosenMethod();
    statistics.GuaranteedError = pass->GetGuaranteedError();
    statistics.BudgetProblem = pass->GetBudgetProblem();
  }
  return statistics;
}

vtkErrorBudgetTransparencyPass* AutomaticMethod::GetBudgetPass() const
{
  return static_cast<vtkErrorBudgetTransparencyPass*>(this->GetPass());
}

std::unique_ptr<Method> MakeAutomatic()
{
  return std::make_unique<AutomaticMethod>(vtkSmartPointer<vtkErrorBudgetTransparencyPass>::New());
}

std::unique_ptr<Method> MakeByDefault(const std::string& name)
{
  return std::make_unique<VitrineMethod>(
    vtkSmartPointer<vtkTransparencyPass>::Take(vtkTransparencyPass::NewMethod(name)));
}

std::unique_ptr<Method> MakeLinkedList(int storage)
{
  auto pass = vtkSmartPointer<vtkLinkedListTransparencyPass>::New();
  pass->SetColorStorage(storage);
  return std::make_unique<VitrineMethod>(pass);
}

std::unique_ptr<Method> MakePrefixSum(bool prediction, int storage)
{
  auto pass = vtkSmartPointer<vtkPrefixSumTransparencyPass>::New();
  pass->SetPrediction(prediction);
  pass->SetColorStorage(storage);
  return std::make_unique<VitrineMethod>(pass);
}

std::unique_ptr<Method> MakeStencilMask(int layers, MaskEdges edges)
{
  auto pass = vtkSmartPointer<vtkStencilMaskTransparencyPass>::New();
  pass->SetNumberOfLayers(layers);
  pass->SetFilter(edges == MaskEdges::Repaired);
  pass->SetShowMarks(edges == MaskEdges::Marks);
  return std::make_unique<VitrineMethod>(pass);
}

std::unique_ptr<Method> MakeStencilRouted(int samples)
{
  auto pass = vtkSmartPointer<vtkStencilRoutedTransparencyPass>::New();
  pass->SetSamplesPerPass(samples);
  return std::make_unique<VitrineMethod>(pass);
}

std::unique_ptr<Method> MakeStencilRoutedEightBit()
{
  auto pass = vtkSmartPointer<vtkStencilRoutedTransparencyPass>::New();
  pass->SetColorStorageToEightBit();
  return std::make_unique<VitrineMethod>(pass);
}

}
