/**
 * The methods of this module.
 */
#ifndef VITRINE_VITRINE_METHODS_H
#define VITRINE_VITRINE_METHODS_H

#include "methods/Method.h"
#include "methods/TimedPass.h"

#include "vtkSmartPointer.h"
#include "vtkTransparencyPass.h"

class vtkErrorBudgetTransparencyPass;

namespace program
{

/** A method that is one of the module's passes. */
class VitrineMethod : public Method
{
public:
  explicit VitrineMethod(vtkSmartPointer<vtkTransparencyPass> pass);

  void Attach(vtkRenderer* renderer) override;
  std::string SetCoincidence(const Coincidence& coincidence) override;
  void MeasureStages() override;
  MethodStatistics Statistics() const override;
  std::string WhyNotRun() const override;

protected:
  vtkTransparencyPass* GetPass() const { return this->Pass; }

private:
  vtkSmartPointer<vtkTransparencyPass> Pass;
  vtkSmartPointer<TimedPass> Opaque; ///< null unless stages are measured
};

/** The method that chooses by an error budget. */
class AutomaticMethod : public VitrineMethod
{
public:
  explicit AutomaticMethod(vtkSmartPointer<vtkErrorBudgetTransparencyPass> pass);

  std::string SetErrorBudget(double budget) override;
  MethodStatistics Statistics() const override;

  vtkErrorBudgetTransparencyPass* GetBudgetPass() const;
};

std::unique_ptr<Method> MakeAutomatic();

/** The module's method of this name (vtkTransparencyPass::GetMethods()) with its default settings. */
std::unique_ptr<Method> MakeByDefault(const std::string& name);

/** vtkLinkedListTransparencyPass, with colours kept by one of its ColorStorageType. */
std::unique_ptr<Method> MakeLinkedList(int storage);

/** vtkPrefixSumTransparencyPass, by prediction or counting first. */
std::unique_ptr<Method> MakePrefixSum(bool prediction, int storage);

/** What stencil masks do about the edges of polygons: repair them, leave them, or show the marks alone. */
enum class MaskEdges
{
  Repaired,
  AsTheyAre,
  Marks
};

/** vtkStencilMaskTransparencyPass with 4, 8, 9 or 16 layers. */
std::unique_ptr<Method> MakeStencilMask(int layers, MaskEdges edges = MaskEdges::Repaired);

/** vtkStencilRoutedTransparencyPass with so many samples a pass. */
std::unique_ptr<Method> MakeStencilRouted(int samples);
std::unique_ptr<Method> MakeStencilRoutedEightBit();

}
#endif
