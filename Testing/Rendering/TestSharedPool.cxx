// One pass that draws several viewports: what it holds is enough for all, and does not swing.
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkRendererCollection.h"
#include "vtkSeeThroughPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace
{

// One pass that draws several viewports side by side, each of some number of plates.
class SharedPool : public testing::TestWithParam<Method>
{
protected:
  void AddViewports(const std::vector<int>& layers)
  {
    this->Scene.Window->RemoveRenderer(this->Scene.Renderer);
    const double width = 1.0 / static_cast<double>(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      TestScene maker;
      maker.AddPlates(RandomPlates(layers[i], 0.05, 3), 4);
      maker.Window->RemoveRenderer(maker.Renderer);
      maker.Renderer->SetViewport(width * i, 0.0, width * (i + 1), 1.0);
      maker.Renderer->SetPass(this->SeeThrough);
      this->Scene.Window->AddRenderer(maker.Renderer);
    }
    this->SeeThrough->SetTranslucentPass(this->Pass);
  }

  // How often the pool has another size than after the viewport before.
  int Changes(int frames)
  {
    int changes = 0;
    vtkTypeInt64 before = this->Pass->GetPoolBytes();
    std::function<void()> count = [&]
    {
      changes += this->Pass->GetPoolBytes() != before ? 1 : 0;
      before = this->Pass->GetPoolBytes();
    };
    vtkNew<vtkCallbackCommand> afterViewport;
    afterViewport->SetClientData(&count);
    afterViewport->SetCallback([](vtkObject*, unsigned long, void* data, void*)
      { (*static_cast<std::function<void()>*>(data))(); });
    vtkRendererCollection* renderers = this->Scene.Window->GetRenderers();
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
    {
      renderer->AddObserver(vtkCommand::EndEvent, afterViewport);
    }
    for (int frame = 0; frame < frames; ++frame)
    {
      this->Scene.Render();
    }
    renderers->InitTraversal();
    while (vtkRenderer* renderer = renderers->GetNextItem())
    {
      renderer->RemoveObserver(afterViewport);
    }
    return changes;
  }

  TestScene Scene = TestScene(120, 20);
  const vtkSmartPointer<vtkABufferTransparencyPass> Pass = MakeABuffer(GetParam());
  vtkNew<vtkSeeThroughPass> SeeThrough;
};

TEST_P(SharedPool, OfADeepAndAFlatViewHoldsStill)
{
  this->AddViewports({ 64, 1 });
  this->Changes(2);
  const vtkTypeInt64 bytes = this->Pass->GetPoolBytes();
  EXPECT_GE(bytes, 64 * 60 * 20 * GetParam().NodeBytes());
  EXPECT_EQ(this->Changes(70), 0);
}

TEST_P(SharedPool, OfADeepAndSeveralFlatViewsHoldsStill)
{
  this->AddViewports({ 64, 1, 1, 1, 1, 1 });
  this->Changes(3);
  EXPECT_EQ(this->Changes(40), 0);
}

TEST_P(SharedPool, SettlesOnWhatTheViewTakes)
{
  const vtkSmartPointer<vtkActor> deep = this->Scene.AddPlates(RandomPlates(64, 0.05, 3), 4);
  this->Scene.AddPlates(RandomPlates(1, 0.05, 3), 4);
  this->Scene.Use(this->Pass);
  this->Scene.Render();
  const vtkTypeInt64 large = this->Pass->GetPoolBytes();
  deep->VisibilityOff();
  const int changes = this->Changes(80);
  EXPECT_GE(changes, 1);
  EXPECT_LE(changes, 3);
  const double plain = static_cast<double>(this->Pass->GetNumberOfFragments()) * 16;
  EXPECT_LE(this->Pass->GetPoolBytes(), std::max(1.3 * plain, static_cast<double>(large) / 20.0));
}

TEST_P(SharedPool, ShrinksWhileNothingIsVisible)
{
  const vtkSmartPointer<vtkActor> plates = this->Scene.AddPlates(RandomPlates(64, 0.05, 3), 4);
  this->Scene.Use(this->Pass);
  this->Scene.Render();
  const vtkTypeInt64 large = this->Pass->GetPoolBytes();
  const vtkTypeInt64 bytes = this->Pass->GetBytes();
  plates->VisibilityOff();
  this->Changes(40);
  EXPECT_LT(this->Pass->GetPoolBytes(), large / 100);
  EXPECT_EQ(bytes - this->Pass->GetBytes(), large - this->Pass->GetPoolBytes());
  plates->VisibilityOn();
  ExpectTruth(this->Scene, this->Pass, 2.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, SharedPool, testing::ValuesIn(ABufferMethods()), MethodName());

}
