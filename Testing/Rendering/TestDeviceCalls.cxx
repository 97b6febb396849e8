// How often a steady frame asks the driver, waits for it and allocates: budgets for each method. On a device each query
// may wait for the driver's thread, and each read for all work that was submitted.
#include "CallCounter.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkTranslucentPass.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

namespace
{

// The calls of a frame after some of the same.
CallCounts CallsOfSteadyFrame(vtkRenderPass* pass)
{
  TestScene scene(60, 44);
  for (int i = 0; i < 9; ++i)
  {
    scene.AddSphere(0.1 * i - 0.4, 0.05 * i, 0.0, 0.4, { 0.1 * i, 0.5, 0.9, 0.3 });
  }
  scene.Use(pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Window->Render();
  }
  const CallCounter counter;
  scene.Window->Render();
  return counter.Counts();
}

// The most calls of a method's frame. Stencil methods count their fragments on the CPU. Truth composites there.
CallCounts BudgetOf(const std::string& name)
{
  static const std::map<std::string, CallCounts> others = { { "PrefixSumPredicted", { 100, 2, 0 } },
    { "PrefixSumCountedCompact", { 116, 2, 0 } }, { "StencilRoutedHalfFloat", { 146, 2, 0 } },
    { "StencilMask9", { 152, 2, 0 } }, { "Truth", { 114, 3, 0 } } };
  const auto found = others.find(name);
  return found == others.end() ? CallCounts{ 95, 1, 0 } : found->second;
}

class DeviceCalls : public testing::TestWithParam<Method>
{
};

TEST_P(DeviceCalls, OfASteadyFrameAreFew)
{
  vtkNew<vtkOrderIndependentTranslucentPass> weighted;
  vtkNew<vtkTranslucentPass> geometry;
  weighted->SetTranslucentPass(geometry);
  const CallCounts byVTK = CallsOfSteadyFrame(weighted);
  const CallCounts calls = CallsOfSteadyFrame(GetParam().Make());
  std::cout << GetParam().Name << ": " << calls << "; by VTK: " << byVTK << "\n";
  const CallCounts most = BudgetOf(GetParam().Name);
  EXPECT_LE(calls.Queries, most.Queries);
  EXPECT_LE(calls.BlockingReads, most.BlockingReads);
  EXPECT_LE(calls.Reallocations, most.Reallocations);
}

INSTANTIATE_TEST_SUITE_P(Methods, DeviceCalls, testing::ValuesIn(AllMethods()), MethodName());

}
