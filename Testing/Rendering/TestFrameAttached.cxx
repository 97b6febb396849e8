// A frame that stays on a renderer by vtkSeeThroughPass::Attach(), whatever passes the application sets there.
#include "FrameScene.h"

#include "vtkGaussianBlurPass.h"
#include "vtkNew.h"
#include "vtkRenderStepsPass.h"
#include "vtkSeeThroughPass.h"

#include <gtest/gtest.h>

TEST(FrameAttached, TakesInPassesThatAreSetLater)
{
  FrameScene scene;
  const auto blur = Around<vtkGaussianBlurPass>(vtkNew<vtkRenderStepsPass>());
  vtkNew<vtkSeeThroughPass> frame;
  frame->Attach(scene.Renderer);
  const Picture sharp = scene.Render();
  scene.Renderer->SetPass(blur);
  const Picture blurred = scene.Render();
  EXPECT_EQ(scene.Renderer->GetPass(), frame);
  EXPECT_EQ(frame->GetEffectsPass(), blur);
  EXPECT_NE(blurred, sharp);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), frame);
  scene.Renderer->SetPass(nullptr);
  EXPECT_TRUE(Matches(scene.Render(), sharp));
  scene.Renderer->SetPass(blur);
  scene.Render();
  frame->Detach();
  EXPECT_EQ(scene.Renderer->GetPass(), blur);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), nullptr);
}

// An application may put a pass around the attached frame, before or after it attaches the frame.
TEST(FrameAttached, StaysWithinAPassAroundIt)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  const auto blur = Around<vtkGaussianBlurPass>(frame);
  scene.Renderer->SetPass(blur);
  const Picture blurred = scene.Render();
  frame->Attach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), blur);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), frame);
  EXPECT_TRUE(Matches(scene.Render(), blurred));
  scene.Renderer->SetPass(nullptr);
  EXPECT_NE(scene.Render(), blurred);
  EXPECT_EQ(scene.Renderer->GetPass(), frame);
  scene.Renderer->SetPass(blur);
  EXPECT_TRUE(Matches(scene.Render(), blurred));
  EXPECT_EQ(scene.Renderer->GetPass(), blur);
  EXPECT_EQ(frame->GetEffectsPass(), nullptr);
  frame->Detach();
  EXPECT_EQ(scene.Renderer->GetPass(), blur);
  blur->SetDelegatePass(nullptr);
  blur->ReleaseGraphicsResources(scene.Window);
}

TEST(FrameAttached, MayBeSetBeforeItIsAttached)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  scene.Renderer->SetPass(frame);
  frame->Attach(scene.Renderer);
  EXPECT_EQ(scene.Renderer->GetPass(), frame);
  EXPECT_EQ(frame->GetEffectsPass(), nullptr);
  frame->Detach();
  EXPECT_EQ(scene.Renderer->GetPass(), nullptr);
}

TEST(FrameAttached, KeepsItsEffectsWhereTheRendererHasNone)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> frame;
  vtkNew<vtkRenderStepsPass> steps;
  frame->SetEffectsPass(steps);
  frame->Attach(scene.Renderer);
  EXPECT_EQ(frame->GetEffectsPass(), steps);
  frame->Detach();
  EXPECT_EQ(scene.Renderer->GetPass(), steps);
}

// A frame that the application set itself is its effect, and what it is set to stays.
TEST(FrameAttached, LeavesAFrameOfTheApplicationAsItIs)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> theirs;
  scene.Renderer->SetPass(theirs);
  vtkNew<vtkSeeThroughPass> frame;
  frame->Attach(scene.Renderer);
  EXPECT_EQ(frame->GetEffectsPass(), theirs);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  scene.Render();
  EXPECT_EQ(theirs->GetEffectsPass(), nullptr);
  EXPECT_EQ(frame->GetEffectsPass(), steps);
  frame->Detach();
}

// The frame attached first is the innermost one, and takes in what the application sets.
TEST(FrameAttached, NestsInFramesThatAreAttachedLater)
{
  FrameScene scene;
  vtkNew<vtkSeeThroughPass> inner;
  vtkNew<vtkSeeThroughPass> outer;
  inner->Attach(scene.Renderer);
  outer->Attach(scene.Renderer);
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), outer);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  scene.Render();
  EXPECT_EQ(outer->GetEffectsPass(), inner);
  EXPECT_EQ(inner->GetEffectsPass(), steps);
  outer->Detach();
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), inner);
  EXPECT_EQ(scene.Renderer->GetPass(), inner);
  inner->Detach();
  EXPECT_EQ(vtkSeeThroughPass::GetAttached(scene.Renderer), nullptr);
  EXPECT_EQ(scene.Renderer->GetPass(), steps);
}
