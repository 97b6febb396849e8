// What shines through what VTK blends among what is opaque, where that is no plain actor: assemblies, images, splats.
#include "CullerScene.h"

#include "vtkAssembly.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLabeledContourMapper.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProp3DFollower.h"
#include "vtkPropAssembly.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

namespace
{

class CullerBlendedProps : public CullerTest
{
protected:
  CullerBlendedProps()
    : Boxes(Scene.AddHidden())
  {
  }

  // A translucent plate that is drawn among what is opaque; in no renderer.
  vtkSmartPointer<vtkActor> MakeForced()
  {
    const vtkSmartPointer<vtkActor> plate =
      Scene.AddMesh(MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, 0.4) }), { 0.1, 0.2, 0.9, 0.5 });
    Scene.Renderer->RemoveActor(plate);
    plate->ForceOpaqueOn();
    return plate;
  }

  // Puts a wall between the boxes and a prop. The prop is drawn after the boxes and before the wall. Returns how many
  // parts behind the wall are culled.
  int HiddenBehind(vtkProp* front)
  {
    Scene.Renderer->AddViewProp(front);
    const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
    Scene.LookAhead();
    const int hidden = Scene.ExpectSame();
    this->ShowsThrough = Scene.ShowsUnculled(this->Boxes);
    EXPECT_EQ(Scene.ExpectSameAround(340) > 0, hidden > 0) << "as from straight ahead";
    front->VisibilityOff();
    Scene.LookAhead();
    EXPECT_GE(Scene.ExpectSame(), this->All());
    front->VisibilityOn();
    Scene.Renderer->RemoveViewProp(front);
    Scene.Renderer->RemoveActor(wall);
    return hidden;
  }

  void ExpectShinesThrough(vtkProp* front)
  {
    const int hidden = this->HiddenBehind(front);
    EXPECT_GT(hidden, 20);
    EXPECT_LT(hidden, this->All());
    EXPECT_TRUE(this->ShowsThrough);
  }

  void ExpectShinesThroughAnywhere(vtkProp* front)
  {
    EXPECT_EQ(this->HiddenBehind(front), 0);
    EXPECT_TRUE(this->ShowsThrough);
  }

  int All() const { return static_cast<int>(this->Boxes.size()); }

  std::vector<vtkSmartPointer<vtkActor>> Boxes;
  bool ShowsThrough = false; // whether boxes showed with nothing culled
};

// Of red, and of so much alpha; from -0.3 to 0.3 in front of the wall.
vtkSmartPointer<vtkImageData> ImageOf(unsigned char alpha)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(7, 7, 1);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-0.3, -0.3, 0.4);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 7 * 7; ++i)
  {
    const unsigned char red[] = { 255, 0, 0, alpha };
    std::copy(std::begin(red), std::end(red), values + 4 * i);
  }
  return image;
}

TEST_P(CullerBlendedProps, ActorsOfAssemblies)
{
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(this->MakeForced());
  this->ExpectShinesThrough(assembly);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(assembly);
  this->ExpectShinesThrough(outer);
  vtkNew<vtkPropAssembly> props;
  props->AddPart(outer);
  this->ExpectShinesThrough(props);
}

TEST_P(CullerBlendedProps, AssembliesThatChange)
{
  vtkNew<vtkAssembly> assembly;
  const vtkSmartPointer<vtkActor> part = this->MakeForced();
  part->ForceOpaqueOff();
  assembly->AddPart(part);
  EXPECT_GE(this->HiddenBehind(assembly), this->All());
  Scene.Renderer->AddViewProp(assembly);
  Scene.AddWall();
  EXPECT_GE(Scene.ExpectSame(), this->All());
  part->ForceOpaqueOn();
  EXPECT_LT(Scene.ExpectSame(), this->All());
  part->VisibilityOff();
  EXPECT_GE(Scene.ExpectSame(), this->All());
}

TEST_P(CullerBlendedProps, ImagesThatAreForced)
{
  vtkNew<vtkImageActor> image;
  image->SetInputData(ImageOf(120));
  EXPECT_GE(this->HiddenBehind(image), this->All()) << "VTK draws it after the wall";
  image->ForceOpaqueOn();
  this->ExpectShinesThrough(image);
}

TEST_P(CullerBlendedProps, SlicesWithTheirBackground)
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(ImageOf(120));
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  this->ExpectShinesThrough(slice);
  mapper->BorderOn();
  EXPECT_EQ(this->HiddenBehind(slice), 0);
}

// Texts look at the eye, or hang from others: where they are is not known.
TEST_P(CullerBlendedProps, TextsThatAreForced)
{
  vtkNew<vtkTextActor3D> text;
  text->SetInput("text");
  text->SetScale(0.02);
  text->SetPosition(-0.4, -0.1, 0.4);
  EXPECT_GE(this->HiddenBehind(text), this->All());
  text->ForceOpaqueOn();
  this->ExpectShinesThroughAnywhere(text);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(text);
  this->ExpectShinesThroughAnywhere(assembly);
  vtkNew<vtkProp3DFollower> follower;
  follower->SetProp3D(text);
  follower->SetCamera(Scene.Renderer->GetActiveCamera());
  this->ExpectShinesThroughAnywhere(follower);
  vtkNew<vtkBillboardTextActor3D> sign;
  sign->SetInput("sign");
  sign->SetPosition(-0.1, -0.1, 0.4);
  Scene.Renderer->AddViewProp(sign); // what the text is like is known once it was drawn
  Scene.Render();
  Scene.Renderer->RemoveViewProp(sign);
  EXPECT_GE(this->HiddenBehind(sign), this->All());
  sign->ForceOpaqueOn();
  this->ExpectShinesThroughAnywhere(sign);
}

TEST_P(CullerBlendedProps, LabelsOfContours)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> heights;
  lines->InsertNextCell(40);
  for (int i = 0; i < 40; ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(-0.7 + 0.035 * i, 0.0, 0.4));
    heights->InsertNextValue(8.0f);
  }
  vtkNew<vtkPolyData> contour;
  contour->SetPoints(points);
  contour->SetLines(lines);
  contour->GetPointData()->SetScalars(heights);
  vtkNew<vtkLabeledContourMapper> mapper;
  mapper->SetInputData(contour);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  Scene.Window->StencilCapableOn(); // so that VTK does not complain
  this->ExpectShinesThroughAnywhere(actor);
}

TEST_P(CullerBlendedProps, FloorBelowTheSky)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(PlainImage(3, 180.0));
  vtkNew<vtkSkybox> sky;
  sky->SetProjection(vtkSkybox::Floor);
  sky->SetFloorPlane(0.0f, 0.0f, 1.0f, -0.4f);
  sky->SetFloorRight(1.0f, 0.0f, 0.0f);
  sky->SetTexture(texture);
  Scene.Renderer->AddActor(sky);
  Scene.AddWall();
  Scene.ExpectNothingHidden(341);
  sky->SetProjection(vtkSkybox::Sphere);
  Scene.ExpectHidden(342);
}

// Splats are wider than the box around their points tells.
TEST_P(CullerBlendedProps, Splats)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.4);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetVerts(verts);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScaleFactor(0.1);
  mapper->EmissiveOff();
  vtkNew<vtkActor> splat;
  splat->SetMapper(mapper);
  EXPECT_EQ(this->HiddenBehind(splat), 0);
  EXPECT_TRUE(this->ShowsThrough);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerBlendedProps, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
