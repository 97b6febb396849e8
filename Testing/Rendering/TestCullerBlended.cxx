// What VTK blends among what is opaque lets shine through what was drawn before it, whatever stands between both.
#include "CompositeMapper.h"
#include "CullerScene.h"
#include "TestPasses.h"
#include "gl/VitrineOpenGL.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkFloatArray.h"
#include "vtkLightsPass.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderState.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

namespace
{

class CullerBlended : public CullerTest
{
protected:
  CullerBlended()
    : Boxes(Scene.AddHidden())
  {
  }

  // A plate in front of some of the boxes, drawn after them and before what is added later.
  vtkSmartPointer<vtkActor> AddFront(double opacity = 1.0)
  {
    return Scene.AddMesh(
      MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, 0.4) }), { 0.1, 0.2, 0.9, opacity });
  }

  vtkSmartPointer<vtkActor> AddForced()
  {
    const vtkSmartPointer<vtkActor> front = this->AddFront(0.5);
    front->ForceOpaqueOn();
    return front;
  }

  // Of the boxes behind the wall those are drawn that lie where something is blended, and no others.
  void ExpectSomeDrawn()
  {
    Scene.LookAhead();
    const int leftOut = Scene.ExpectSame();
    EXPECT_GT(leftOut, 20);
    EXPECT_LT(leftOut, static_cast<int>(this->Boxes.size()));
    EXPECT_TRUE(Scene.ShowsUnculled(this->Boxes));
    Scene.ExpectHidden(320, 2);
  }

  void ExpectAllHidden()
  {
    Scene.LookAhead();
    EXPECT_GE(Scene.ExpectSame(), static_cast<int>(this->Boxes.size()));
    EXPECT_FALSE(Scene.ShowsUnculled(this->Boxes));
  }

  // Puts a wall between the boxes and what is blended.
  void ExpectShinesThrough(vtkActor* front)
  {
    const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
    this->ExpectSomeDrawn();
    front->VisibilityOff();
    this->ExpectAllHidden();
    front->VisibilityOn();
    this->ExpectSomeDrawn();
    Scene.Renderer->RemoveActor(wall);
    Scene.Renderer->RemoveActor(front);
  }

  std::vector<vtkSmartPointer<vtkActor>> Boxes;
};

// That changes nothing, so that it is drawn as it is; but the culler does not know that.
void AddShaderCode(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n", false);
}

TEST_P(CullerBlended, WhatIsForcedToBeOpaque)
{
  this->ExpectShinesThrough(this->AddForced());
}

TEST_P(CullerBlended, WhatIsForcedAndCannotBeHidden)
{
  const vtkSmartPointer<vtkActor> front = this->AddForced();
  AddShaderCode(front);
  this->ExpectShinesThrough(front);
}

// Points are drawn as squares of pixels, which boxes do not contain. Beside the point's middle is a bar as high as the
// points. The wall hides the bar except where the point is blended over it.
TEST_P(CullerBlended, PointsThatCannotBeHidden)
{
  for (const float size : { 1.0f, 9.0f })
  {
    SCOPED_TRACE(size);
    Scene.Clear();
    Scene.LookAhead();
    const double pixel = Scene.PixelSize();
    const double from = 0.3 * size * pixel, to = 0.45 * size * pixel;
    Scene.AddMesh(MeshOf({ Rectangle(from, -0.4 * size * pixel, to, 0.4 * size * pixel, -0.01) }),
      { 1, 0, 0, 1 });
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.01);
    vtkNew<vtkCellArray> verts;
    verts->InsertNextCell({ 0 });
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetVerts(verts);
    const vtkSmartPointer<vtkActor> blended = Scene.AddMesh(mesh, { 0.5, 0.5, 0.5, 0.5 });
    AddShaderCode(blended);
    blended->ForceOpaqueOn();
    blended->GetProperty()->SetPointSize(size);
    Scene.AddWall();
    // The bar by the smaller point lies between the centres of pixels, where one sample does not see it.
    EXPECT_EQ(Scene.ExpectSame(), size < 2.0f && Scene.Setting.Samples == 0 ? 1 : 0);
    blended->VisibilityOff();
    EXPECT_EQ(Scene.ExpectSame(), 1) << "nothing but the point lets the bar shine through the wall";
  }
}

// VTK draws it after all that is opaque, behind which it hides nothing.
TEST_P(CullerBlended, WhatIsTranslucentIsNot)
{
  this->AddFront(0.5);
  Scene.AddWall();
  this->ExpectAllHidden();
}

TEST_P(CullerBlended, TranslucentBacks)
{
  vtkNew<vtkProperty> back;
  back->SetOpacity(0.4);
  back->LightingOff();
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(-0.3, 0.3, -0.3, 0.3, -0.4, -0.35);
  for (const bool isClosed : { false, true })
  {
    const vtkSmartPointer<vtkActor> front =
      Scene.AddMesh(MeshOf({ Rectangle(0.3, -0.3, -0.3, 0.3, 0.4) }));
    if (isClosed)
    {
      front->GetMapper()->SetInputConnection(cube->GetOutputPort());
      front->SetScale(
        1.0, 1.0, -1.0); // inside out, and the side in front is drawn before the one at the back
    }
    front->SetBackfaceProperty(back);
    this->ExpectShinesThrough(front);
  }
}

TEST_P(CullerBlended, AlphaOfAShader)
{
  const vtkSmartPointer<vtkActor> front = this->AddFront();
  front->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].a = 0.5;\n", false);
  this->ExpectShinesThrough(front);
}

TEST_P(CullerBlended, ColorsThatAreTranslucentUnknownToVTK)
{
  const vtkSmartPointer<vtkActor> front = this->AddFront();
  auto* mapper = static_cast<vtkPolyDataMapper*>(front->GetMapper());
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfValues(4);
  scalars->Fill(0.5);
  mapper->GetInput()->GetPointData()->SetScalars(scalars);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.2, 0.2, 0.4);
  colors->IndexedLookupOn(); // none of the values is known by name
  colors->SetNanOpacity(0.3);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  this->ExpectShinesThrough(front);
}

TEST_P(CullerBlended, TranslucentBlocksThatAreForced)
{
  for (const bool isOurs : { false, true })
  {
    const vtkSmartPointer<vtkActor> front = this->AddFront();
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, MeshOf({ Rectangle(-0.3, -0.3, 0.0, 0.3, 0.4) }));
    blocks->SetBlock(1, MeshOf({ Rectangle(0.0, -0.3, 0.3, 0.3, 0.4) }));
    const auto mapper = isOurs
      ? vtkSmartPointer<CompositeMapper>(vtkSmartPointer<vtkCulledCompositePolyDataMapper>::New())
      : vtkSmartPointer<CompositeMapper>::New();
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    mapper->SetBlockOpacity(2, 0.5);
    front->SetMapper(mapper);
    front->ForceOpaqueOn();
    this->ExpectShinesThrough(front);
  }
}

TEST_P(CullerBlended, WhatIsSwitchedBetweenFrames)
{
  const vtkSmartPointer<vtkActor> front = this->AddFront();
  Scene.AddWall();
  this->ExpectAllHidden();
  front->ForceOpaqueOn();
  this->ExpectAllHidden();
  front->GetProperty()->SetOpacity(0.5);
  this->ExpectSomeDrawn();
  front->ForceOpaqueOff();
  this->ExpectAllHidden();
  front->ForceOpaqueOn();
  for (const double x : { 0.5, -0.7, 9.0 }) // beside the view in the end
  {
    front->SetPosition(x, 0.0, 0.0);
    Scene.LookAhead();
    x < 1.0 ? this->ExpectSomeDrawn() : this->ExpectAllHidden();
  }
}

// Edges are blended with whatever was drawn before.
TEST_P(CullerBlended, WindowsThatSmooth)
{
  Scene.AddWall();
  this->ExpectAllHidden();
  vtkRenderWindow* const window = Scene.Window;
  for (const auto smooth : { &vtkRenderWindow::SetLineSmoothing,
         &vtkRenderWindow::SetPointSmoothing, &vtkRenderWindow::SetPolygonSmoothing })
  {
    (window->*smooth)(1);
    Scene.ExpectNothingHidden(321, 1);
    (window->*smooth)(0);
  }
  this->ExpectAllHidden();
}

/** Draws whatever lies behind, too. */
class XRayPass : public vtkOpaquePass
{
public:
  static XRayPass* New() { VTK_STANDARD_NEW_BODY(XRayPass); }
  void Render(const vtkRenderState* frame) override
  {
    vtkOpenGLState* const state =
      static_cast<vtkOpenGLRenderWindow*>(frame->GetRenderer()->GetRenderWindow())->GetState();
    vtkOpenGLState::ScopedglEnableDisable kept(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    this->vtkOpaquePass::Render(frame);
  }
};

/** The same, which tells its name. */
class NamedXRayPass : public XRayPass
{
public:
  static NamedXRayPass* New() { VTK_STANDARD_NEW_BODY(NamedXRayPass); }
  vtkTypeMacro(NamedXRayPass, XRayPass);
};

TEST_P(CullerBlended, PassesDerivedFromVTKs)
{
  Scene.Clear();
  Scene.AddWall();
  this->Boxes = Scene.AddHidden(); // after it, so that they show where depths are not compared
  const std::pair<vtkSmartPointer<vtkOpaquePass>, bool> passes[] = {
    { vtkSmartPointer<XRayPass>::New(), true }, { vtkSmartPointer<NamedXRayPass>::New(), true },
    { vtkSmartPointer<vtkOpaquePass>::New(), false }
  };
  for (const auto& [opaque, isXRay] : passes)
  {
    Scene.Renderer->SetPass(ByCamera(InSequence({ vtkNew<vtkLightsPass>(), opaque })));
    isXRay ? Scene.ExpectNothingHidden(322, 1) : Scene.ExpectHidden(322, 1);
    EXPECT_EQ(Scene.ShowsUnculled(this->Boxes), isXRay);
    Scene.Renderer->SetPass(nullptr);
  }
}

/** Of no name of its own. */
class DerivedLists : public vtkLinkedListTransparencyPass
{
public:
  static DerivedLists* New() { VTK_STANDARD_NEW_BODY(DerivedLists); }
};

TEST_P(CullerBlended, PassesDerivedFromOurs)
{
  Scene.AddWall();
  Scene.Use(vtkSmartPointer<DerivedLists>::New());
  Scene.ExpectNothingHidden(323, 1);
  Scene.Use(vtkSmartPointer<vtkLinkedListTransparencyPass>::New());
  Scene.ExpectHidden(323, 1);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerBlended, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
