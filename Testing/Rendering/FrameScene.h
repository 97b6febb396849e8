/**
 * A scene for frames with effects, and passes around others.
 */
#ifndef VITRINE_TEST_FRAME_SCENE_H
#define VITRINE_TEST_FRAME_SCENE_H

#include "TestScene.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"

#include <vector>

/** Opaque spheres before a wall, and translucent ones among them. */
struct FrameScene : TestScene
{
  FrameScene()
    : TestScene(72, 54)
  {
    this->AddRectangle(-3.0, -3.0, 3.0, 3.0, -0.6, { 0.8, 0.8, 0.7, 1.0 })
      ->GetProperty()
      ->LightingOn();
    this->AddSphere(-0.4, 0.0, 0.0, 0.35, { 0.9, 0.2, 0.1, 1.0 });
    this->AddSphere(0.4, 0.3, -0.2, 0.3, { 0.1, 0.5, 0.9, 1.0 });
    for (int i = 0; i < 3; ++i)
    {
      this->Glass.push_back(
        this->AddSphere(0.35 * i - 0.4, 0.15 * i, 0.3, 0.4, { 0.2, 0.3 * i, 0.8, 0.4 }));
    }
  }

  void ShowGlass(bool isShown)
  {
    for (const auto& part : this->Glass)
    {
      part->SetVisibility(isShown);
    }
  }

  std::vector<vtkSmartPointer<vtkActor>> Glass;
};

template <class Class>
vtkSmartPointer<Class> Around(vtkRenderPass* pass)
{
  auto around = vtkSmartPointer<Class>::New();
  around->SetDelegatePass(pass);
  return around;
}

#endif
