// Why the culler leaves out less than all that is hidden: a scene for each rule of its tables, which must be told.
#include "CompositeMapper.h"
#include "CullerScene.h"
#include "DividedActor.h"
#include "Select.h"
#include "TestMessages.h"
#include "culling/CullingPolicy.h"
#include "culling/PropPolicy.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkEDLShading.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdTypeArray.h"
#include "vtkImageActor.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkSection.h"
#include "vtkSelectionNode.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"
#include "vtkTexture.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVersionMacros.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

const CullerSetting OneSample{ "OneSample", 0, false, 270, 91, 70 };

/** A row is known by its condition, or by a part of it that no other row of its table has. */
template <class Row>
const Row* FindRow(const std::vector<Row>& rows, const std::string& part)
{
  std::vector<const Row*> found;
  for (const Row& row : rows)
  {
    if (row.Condition == part)
    {
      return &row;
    }
    if (std::string(row.Condition).find(part) != std::string::npos)
    {
      found.push_back(&row);
    }
  }
  EXPECT_EQ(found.size(), 1u) << "rows with: " << part;
  return found.empty() ? nullptr : found.front();
}

/** Expect that each row has a case, and each case a row. */
template <class Row, class Case>
void ExpectCaseForEach(const std::vector<Row>& rows, const std::vector<Case>& cases)
{
  EXPECT_EQ(cases.size(), rows.size());
  for (const Row& row : rows)
  {
    int count = 0;
    for (const Case& each : cases)
    {
      count += FindRow(rows, each.Condition) == &row;
    }
    EXPECT_EQ(count, 1) << "cases of: " << row.Condition;
  }
}

/** A wall in the plane of height 0, boxes behind it, and what a case adds. */
struct ReasonScene : CullerScene
{
  ReasonScene()
    : CullerScene(OneSample)
    , Boxes(this->AddHidden())
    , Wall(this->AddMesh(TexturedWall()))
  {
  }

  ~ReasonScene() { this->Renderer->SetPass(nullptr); }

  /** A plate in front of the wall, in the middle of the view. */
  vtkSmartPointer<vtkActor> AddFront(double alpha = 1.0)
  {
    return this->AddMesh(
      MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, 0.4) }), { 0.1, 0.2, 0.9, alpha });
  }

  vtkPolyDataMapper* MapperOf(vtkActor* actor)
  {
    return static_cast<vtkPolyDataMapper*>(actor->GetMapper());
  }

  /** Have the culler cull a renderer that draws nothing. */
  void CullAlone(vtkRenderer* renderer)
  {
    vtkProp* prop = this->Wall;
    int count = 1, initialized = 0;
    this->Culler->Cull(renderer, &prop, count, initialized);
    EXPECT_EQ(count, 1);
  }

  std::vector<vtkSmartPointer<vtkActor>> Boxes;
  vtkSmartPointer<vtkActor> Wall;
  vtkSmartPointer<vtkObject> Kept;         ///< for as long as the scene
  vtkSmartPointer<vtkObject> ChangeBefore; ///< each frame, if there is any
};

class OtherCamera : public vtkOpenGLCamera
{
public:
  static OtherCamera* New();
  vtkTypeMacro(OtherCamera, vtkOpenGLCamera);
};
vtkStandardNewMacro(OtherCamera);

/** An image of red, of so much alpha, in front of the wall. */
vtkSmartPointer<vtkImageSlice> AddImage(ReasonScene& scene)
{
  vtkSmartPointer<vtkImageData> image = PlainImage(4, 120.0);
  image->SetOrigin(-0.3, -0.3, 0.4);
  image->SetSpacing(0.6, 0.6, 0.6);
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  auto slice = vtkSmartPointer<vtkImageSlice>::New();
  slice->SetMapper(mapper);
  scene.Renderer->AddViewProp(slice);
  return slice;
}

vtkSmartPointer<vtkTextActor3D> AddText(ReasonScene& scene)
{
  auto text = vtkSmartPointer<vtkTextActor3D>::New();
  text->SetInput("text");
  text->SetScale(0.02);
  text->SetPosition(-0.4, -0.1, 0.4);
  text->ForceOpaqueOn();
  scene.Renderer->AddViewProp(text);
  return text;
}

vtkSmartPointer<vtkTexture> TextureOf(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkSkybox> AddFloor(ReasonScene& scene)
{
  auto sky = vtkSmartPointer<vtkSkybox>::New();
  sky->SetProjection(vtkSkybox::Floor);
  sky->SetFloorPlane(0.0f, 0.0f, 1.0f, -0.4f);
  sky->SetFloorRight(1.0f, 0.0f, 0.0f);
  sky->SetTexture(TextureOf(PlainImage(3, 180.0)));
  scene.Renderer->AddActor(sky);
  return sky;
}

vtkSmartPointer<vtkActor> AddSplat(ReasonScene& scene)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MeshOf({ Rectangle(-0.1, -0.1, 0.1, 0.1, 0.4) }));
  mapper->SetScaleFactor(0.1);
  mapper->EmissiveOff();
  auto splat = vtkSmartPointer<vtkActor>::New();
  splat->SetMapper(mapper);
  scene.Renderer->AddActor(splat);
  return splat;
}

/** Blocks on both sides of the middle, in front of the wall, drawn in parts by our mapper. */
vtkSmartPointer<vtkActor> AddBlocks(ReasonScene& scene, const std::vector<double>& lefts)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const double left : lefts)
  {
    blocks->SetBlock(
      blocks->GetNumberOfBlocks(), MeshOf({ Rectangle(left, -0.3, left + 0.3, 0.3, 0.4) }));
  }
  vtkNew<vtkCulledCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  scene.Renderer->AddActor(actor);
  return actor;
}

/** Colours that are translucent. */
void ColorByAnUnknownAlpha(vtkPolyDataMapper* mapper)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfValues(4);
  scalars->Fill(0.5f);
  mapper->GetInput()->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(1);
  table->SetTableValue(0, 0.2, 0.3, 0.4, 0.5);
  mapper->SetLookupTable(table);
}

struct FrameCase
{
  std::string Condition; ///< a part of the row's
  std::string Detail;
  std::function<void(ReasonScene&)> Draw; ///< a frame
};

const std::vector<FrameCase>& FrameCases()
{
  static const std::vector<FrameCase> cases = {
    { "switched off", "",
      [](ReasonScene& scene)
      {
        scene.Culler->CullingOff();
        scene.Render();
      } },
    { "image of a texture", "",
      [](ReasonScene& scene)
      {
        vtkNew<vtkImageAppendComponents> image;
        image->AddInputData(PlainImage(3, 200.0));
        vtkNew<vtkTexture> texture;
        texture->SetInputConnection(image->GetOutputPort());
        scene.Wall->SetTexture(texture);
        scene.Render();
      } },
    { "draws shadows", "",
      [](ReasonScene& scene)
      {
        scene.Renderer->UseShadowsOn();
        scene.Render();
      } },
    { "hidden line removal and ambient occlusion", "",
      [](ReasonScene& scene)
      {
        scene.Renderer->UseHiddenLineRemovalOn();
        scene.Renderer->UseSSAOOn();
        scene.Render();
      } },
    { "looks beyond the view", "vtkEDLShading depends on the bounds of all props",
      [](ReasonScene& scene)
      {
        vtkNew<vtkEDLShading> shading;
        shading->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
        scene.Renderer->SetPass(shading);
        scene.Render();
        shading->ReleaseGraphicsResources(scene.Window);
        scene.Renderer->SetPass(nullptr);
      } },
    { "draws opaque geometry", "",
      [](ReasonScene& scene)
      {
        scene.Renderer->SetPass(vtkSmartPointer<vtkTranslucentPass>::New());
        scene.Render();
      } },
    { "works on the picture", "",
      [](ReasonScene& scene)
      {
        vtkNew<vtkToneMappingPass> mapping;
        mapping->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
        scene.Renderer->SetPass(mapping);
        vtkCamera* const camera = scene.Renderer->GetActiveCamera();
        vtkNew<vtkMatrix4x4> closer;
        closer->DeepCopy(
          camera->GetProjectionTransformMatrix(scene.Renderer->GetTiledAspectRatio(), -1.0, 1.0));
        closer->SetElement(0, 0, 2.0 * closer->GetElement(0, 0));
        camera->SetExplicitProjectionTransformMatrix(closer);
        camera->UseExplicitProjectionTransformMatrixOn();
        scene.Render();
        mapping->ReleaseGraphicsResources(scene.Window);
        scene.Renderer->SetPass(nullptr);
      } },
    { "no camera yet", "",
      [](ReasonScene& scene)
      {
        vtkNew<vtkRenderer> other;
        scene.Kept = other.Get();
        scene.CullAlone(other);
      } },
    { "class of the camera", "OtherCamera",
      [](ReasonScene& scene)
      {
        vtkNew<OtherCamera> camera;
        scene.Renderer->SetActiveCamera(camera);
        scene.LookAhead();
        scene.Render();
      } },
    { "stereo rendering", "",
      [](ReasonScene& scene)
      {
        scene.Window->StereoRenderOn();
        scene.CullAlone(scene.Renderer);
        scene.Window->StereoRenderOff();
      } },
    { "viewport has no pixel", "",
      [](ReasonScene& scene)
      {
        scene.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
        scene.CullAlone(scene.Renderer);
        scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
      } },
    { "a selector renders", "",
      [](ReasonScene& scene)
      {
        scene.Render();
        Select(scene.Renderer, vtkDataObject::FIELD_ASSOCIATION_CELLS, 1, 1, 20, 20);
      } },
    { "smooths lines", "",
      [](ReasonScene& scene)
      {
        scene.Window->LineSmoothingOn();
        scene.Render();
      } },
    { "may be drawn beside its bounds",
      "vtkOpenGLTextActor3D: it is a text that VTK draws among what is opaque (ForceOpaqueOn); it "
      "turns "
      "towards the eye",
      [](ReasonScene& scene)
      {
        AddText(scene);
        scene.Render();
      } },
    { "finds ambient occlusion", "",
      [](ReasonScene& scene)
      {
        scene.Renderer->UseSSAOOn();
        scene.Render();
      } },
    { "a prop is blended among what is opaque",
      "vtkOpenGLActor: its opacity is below 1, and it is forced to be opaque",
      [](ReasonScene& scene)
      {
        scene.AddFront(0.5)->ForceOpaqueOn();
        scene.Render();
      } },
  };
  return cases;
}

struct KeepCase
{
  std::string Condition;
  std::function<vtkSmartPointer<vtkProp>(ReasonScene&)> Make; ///< what is kept
};

const std::vector<KeepCase>& KeepCases()
{
  const auto addHiddenGlass = [](ReasonScene& scene) {
    return scene.AddSphere(0.1, 0.1, -0.6, 0.1, { 0.9, 0.6, 0.9, 0.4 });
  };
  static const std::vector<KeepCase> cases = {
    { "depth is peeled",
      [=](ReasonScene& scene)
      {
        scene.Renderer->UseDepthPeelingOn();
        return addHiddenGlass(scene);
      } },
    { "always drawn",
      [=](ReasonScene& scene)
      {
        scene.Renderer->AddActor(vtkSmartPointer<vtkAssembly>::New());
        return addHiddenGlass(scene);
      } },
    { "smooths or keeps the picture",
      [](ReasonScene& scene)
      {
        scene.Clear();
        scene.Renderer->UseFXAAOn();
        return scene.AddBox({ 40.0, 0.0, 0.0 }, { 0.1, 0.1, 0.1 });
      } },
  };
  return cases;
}

using vitrine::PropStage;

// From VTK 9.2 on, props may stand in coordinates of the room, or of the device.
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2
#define VITRINE_TEST_COORDINATE_SYSTEMS
constexpr bool HasCoordinateSystems = true;
#else
constexpr bool HasCoordinateSystems = false;
#endif
const std::string RoomOrDevice = "coordinates of the room or of the device";

struct PropCase
{
  PropStage Stage;
  std::string Condition;
  std::string Detail;
  std::function<vtkSmartPointer<vtkProp>(ReasonScene&)> Make;
  int Frames = 1; ///< until it applies
};

using MakeProp = std::function<vtkSmartPointer<vtkProp>(ReasonScene&)>;

/** The front plate, after something was done to it. */
MakeProp Front(const std::function<void(ReasonScene&, vtkActor*)>& change, double alpha = 1.0)
{
  return [=](ReasonScene& scene) -> vtkSmartPointer<vtkProp>
  {
    const vtkSmartPointer<vtkActor> front = scene.AddFront(alpha);
    change(scene, front);
    return front;
  };
}

std::vector<PropCase> CasesOfWhatIsAlwaysDrawn()
{
  return {
    { PropStage::Class, "its class", "vtkAssembly",
      [](ReasonScene& scene)
      {
        auto assembly = vtkSmartPointer<vtkAssembly>::New();
        const vtkSmartPointer<vtkActor> front = scene.AddFront();
        scene.Renderer->RemoveActor(front);
        assembly->AddPart(front);
        scene.Renderer->AddActor(assembly);
        return assembly;
      } },
    { PropStage::Class, "no mapper", "",
      Front([](ReasonScene&, vtkActor* front) { front->SetMapper(nullptr); }) },
    { PropStage::Class, "class of its mapper", "vtkOpenGLGlyph3DMapper",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkGlyph3DMapper> glyphs;
          glyphs->SetInputData(MeshOf({ Rectangle(-0.1, -0.1, 0.1, 0.1, 0.0) }));
          glyphs->SetSourceData(MeshOf({ Rectangle(-0.1, -0.1, 0.1, 0.1, 0.4) }));
          glyphs->ScalingOff();
          front->SetMapper(glyphs);
        }) },
    { PropStage::Class, RoomOrDevice, "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
#ifdef VITRINE_TEST_COORDINATE_SYSTEMS
          front->SetCoordinateSystemToDevice();
#else
          static_cast<void>(front);
#endif
        }) },
    { PropStage::Class, "code of the user's", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          front->GetShaderProperty()->AddVertexShaderReplacement(
            "//VTK::PositionVC::Impl", true, "//VTK::PositionVC::Impl\n", false);
        }) },
    { PropStage::Mapper, "one of several pieces", "",
      Front([](ReasonScene& scene, vtkActor* front)
        { scene.MapperOf(front)->SetNumberOfSubPieces(2); }) },
    { PropStage::Mapper, "bring a lookup table", "",
      Front(
        [](ReasonScene& scene, vtkActor* front)
        {
          vtkPolyDataMapper* const mapper = scene.MapperOf(front);
          ColorByAnUnknownAlpha(mapper);
          vtkNew<vtkLookupTable> table;
          mapper->GetInput()->GetPointData()->GetScalars()->SetLookupTable(table);
        }) },
    { PropStage::Division, "finite", "",
      [](ReasonScene& scene)
      {
        const vtkSmartPointer<vtkActor> blocks = AddBlocks(scene, { -0.3, 0.0 });
        auto* const data =
          vtkMultiBlockDataSet::SafeDownCast(blocks->GetMapper()->GetInputDataObject(0, 0));
        vtkPolyData::SafeDownCast(data->GetBlock(0))
          ->GetPoints()
          ->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
        return blocks;
      } },
    { PropStage::Division, "no blocks", "",
      [](ReasonScene& scene) { return AddBlocks(scene, {}); } },
    { PropStage::Data, "no data", "",
      Front([](ReasonScene&, vtkActor* front)
        { front->SetMapper(vtkSmartPointer<vtkPolyDataMapper>::New()); }) },
    { PropStage::Place, "SetVBOShiftScaleMethod", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkOpenGLPolyDataMapper::SafeDownCast(front->GetMapper())
            ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::MANUAL_SHIFT_SCALE);
        }) },
    { PropStage::Place, "finite", "",
      Front(
        [](ReasonScene& scene, vtkActor* front)
        {
          scene.MapperOf(front)->GetInput()->GetPoints()->SetPoint(
            0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
        }) },
    { PropStage::Place, "affine", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkMatrix4x4> matrix;
          matrix->SetElement(3, 0, 0.1);
          front->SetUserMatrix(matrix);
        }) },
    { PropStage::Place, "no points", "",
      Front([](ReasonScene& scene, vtkActor* front)
        { scene.MapperOf(front)->SetInputData(vtkSmartPointer<vtkPolyData>::New()); }) },
    { PropStage::Distance, "1e15", "",
      Front([](ReasonScene&, vtkActor* front) { front->SetPosition(0.0, 0.0, -1e16); }) },
  };
}

std::vector<PropCase> CasesOfWhatTheViewAloneHides()
{
  return {
    { PropStage::Depths, "are offset", "",
      Front(
        [](ReasonScene&, vtkActor*) { vtkMapper::SetResolveCoincidentTopologyToShiftZBuffer(); }) },
    { PropStage::Depths, "selection", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkIdTypeArray> chosen;
          chosen->InsertNextValue(0);
          vtkNew<vtkSelectionNode> node;
          node->SetContentType(vtkSelectionNode::INDICES);
          node->SetFieldType(vtkSelectionNode::POINT);
          node->SetSelectionList(chosen);
          vtkNew<vtkSelection> selection;
          selection->AddNode(node);
          front->GetMapper()->SetSelection(selection);
        }) },
    { PropStage::Depths, "edges or vertices", "",
      Front([](ReasonScene&, vtkActor* front) { front->GetProperty()->EdgeVisibilityOn(); }) },
    { PropStage::Depths, "spheres", "",
      Front(
        [](ReasonScene&, vtkActor* front) { front->GetProperty()->RenderPointsAsSpheresOn(); }) },
    { PropStage::Hidden, "wireframe", "",
      [](ReasonScene& scene)
      {
        scene.Boxes[30]->GetProperty()->SetRepresentationToWireframe();
        return scene.Boxes[30];
      } },
    { PropStage::Hidden, "change in most frames", "",
      [](ReasonScene& scene)
      {
        const vtkSmartPointer<vtkActor> hidden = scene.AddFront();
        hidden->SetPosition(0.0, 0.0, -0.9);
        scene.ChangeBefore = scene.MapperOf(hidden)->GetInput()->GetPoints();
        return hidden;
      },
      12 },
  };
}

std::vector<PropCase> CasesOfWhatHidesNothing()
{
  return {
    { PropStage::Opacity, "its opacity", "", Front([](ReasonScene&, vtkActor*) {}, 0.5) },
    { PropStage::Opacity, "back faces", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkProperty> back;
          back->SetOpacity(0.4);
          front->SetBackfaceProperty(back);
        }) },
    { PropStage::Opacity, "colours of its scalars", "",
      Front([](ReasonScene& scene, vtkActor* front)
        { ColorByAnUnknownAlpha(scene.MapperOf(front)); }) },
    { PropStage::Opacity, "ForceTranslucentOn", "",
      Front([](ReasonScene&, vtkActor* front) { front->ForceTranslucentOn(); }) },
    { PropStage::Surface, "representation", "",
      Front(
        [](ReasonScene&, vtkActor* front) { front->GetProperty()->SetRepresentationToPoints(); }) },
    { PropStage::Surface, "front faces", "",
      Front([](ReasonScene&, vtkActor* front) { front->GetProperty()->FrontfaceCullingOn(); }) },
    { PropStage::Surface, "ForceOpaqueOn", "",
      Front([](ReasonScene&, vtkActor* front) { front->ForceOpaqueOn(); }) },
    { PropStage::Surface, "clipping planes", "",
      Front([](ReasonScene&, vtkActor* front)
        { front->GetMapper()->AddClippingPlane(vtkSmartPointer<vtkPlane>::New()); }) },
    { PropStage::Part, "a block", "",
      [](ReasonScene& scene)
      {
        const vtkSmartPointer<vtkActor> blocks = AddBlocks(scene, { -0.3 });
        static_cast<CompositeMapper*>(blocks->GetMapper())->SetBlockOpacity(1, 0.5);
        return blocks;
      } },
    { PropStage::Frame, "texture", "",
      [](ReasonScene& scene)
      {
        scene.Wall->SetTexture(TextureOf(PlainImage(1, 120.0)));
        return scene.Wall;
      } },
    { PropStage::Frame, "a vtkSection", "",
      Front(
        [](ReasonScene& scene, vtkActor*)
        {
          vtkNew<vtkPlane> plane;
          plane->SetNormal(1.0, 0.0, 0.0);
          vtkNew<vtkSection> section;
          section->AddPlane(plane);
          section->Attach(scene.Renderer);
          scene.Kept = section;
        }) },
    { PropStage::Frame, "NON_OCCLUDING", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkInformation> keys;
          keys->Set(vtkHierarchicalSBufferCuller::NON_OCCLUDING(), 1);
          front->SetPropertyKeys(keys);
        }) },
    { PropStage::Frame, "no polygons", "",
      [](ReasonScene& scene) {
        return scene.AddLine({ -0.3, 0.0, 0.4 }, { 0.3, 0.1, 0.4 });
      } },
  };
}

std::vector<PropCase> CasesOfWhatBlends()
{
  return {
    { PropStage::Blending, "it is a text", "", AddText },
    { PropStage::Blending, "floor", "", AddFloor },
    { PropStage::Blending, "an image", "", AddImage },
    { PropStage::Blending, "its opacity", "",
      Front([](ReasonScene&, vtkActor* front) { front->ForceOpaqueOn(); }, 0.5) },
    { PropStage::Blending, "back faces", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          vtkNew<vtkProperty> back;
          back->SetOpacity(0.4);
          front->SetBackfaceProperty(back);
        }) },
    { PropStage::Blending, "code of the user's", "",
      Front(
        [](ReasonScene&, vtkActor* front)
        {
          front->GetShaderProperty()->AddFragmentShaderReplacement(
            "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].a = 0.5;\n", false);
        }) },
    { PropStage::Blending, "a texture", "",
      [](ReasonScene& scene)
      {
        scene.Wall->SetTexture(TextureOf(PlainImage(4, 120.0)));
        scene.Wall->ForceOpaqueOn();
        return scene.Wall;
      } },
    { PropStage::Blending, "colours of its scalars", "",
      Front(
        [](ReasonScene& scene, vtkActor* front)
        {
          ColorByAnUnknownAlpha(scene.MapperOf(front));
          front->ForceOpaqueOn();
        }) },
    { PropStage::Blending, "in blocks", "",
      [](ReasonScene& scene)
      {
        const vtkSmartPointer<vtkActor> blocks = AddBlocks(scene, { -0.3 });
        blocks->ForceOpaqueOn();
        return blocks;
      } },
    { PropStage::Blending, "splats", "", AddSplat },
    { PropStage::Beside, "is a text", "", AddText },
    { PropStage::Beside, "floor", "", AddFloor },
    { PropStage::Beside, "border", "",
      [](ReasonScene& scene)
      {
        const vtkSmartPointer<vtkImageSlice> image = AddImage(scene);
        image->GetMapper()->BorderOn();
        return image;
      } },
    { PropStage::Beside, "class of its mapper", "", AddSplat },
  };
}

std::vector<PropCase> PropCases()
{
  std::vector<PropCase> all;
  for (const auto& cases : { CasesOfWhatIsAlwaysDrawn(), CasesOfWhatTheViewAloneHides(),
         CasesOfWhatHidesNothing(), CasesOfWhatBlends() })
  {
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

std::vector<vitrine::PropRow> RowsOf(PropStage stage)
{
  std::vector<vitrine::PropRow> rows;
  for (const vitrine::PropRow& row : vitrine::PropRows())
  {
    if (row.Stage == stage)
    {
      rows.push_back(row);
    }
  }
  return rows;
}

/** What is told of a prop to which a row applies; of the frame if the row is of what blends. */
void ExpectTold(
  ReasonScene& scene, vtkProp* prop, const PropCase& each, const vitrine::PropRow& row)
{
  const std::string text = vitrine::Sentence(row.Condition, each.Detail, row.Why);
  const std::string ofFrame = scene.Culler->GetReason();
  switch (row.Effect)
  {
    case vitrine::PropEffect::AlwaysDrawn:
      EXPECT_EQ(scene.Culler->GetReason(prop), "always drawn: " + text);
      break;
    case vitrine::PropEffect::ViewAlone:
      EXPECT_EQ(scene.Culler->GetReason(prop), "drawn, as only the view hides it: " + text);
      break;
    case vitrine::PropEffect::HidesNothing:
      EXPECT_EQ(scene.Culler->GetReason(prop), "visible; hides nothing: " + text);
      break;
    case vitrine::PropEffect::Blends:
      EXPECT_NE(
        ofFrame.find(std::string(prop->GetClassName()) + ": " + row.Condition), std::string::npos)
        << ofFrame;
      break;
    case vitrine::PropEffect::BlendsAnywhere:
      EXPECT_EQ(scene.Culler->GetCullingMode(), vtkHierarchicalSBufferCuller::VIEW_ONLY);
      EXPECT_NE(ofFrame.find("; " + std::string(row.Why)), std::string::npos) << ofFrame;
      break;
  }
}

// From VTK 9.2 on at the latest, copies of cameras have an explicit projection, too.
constexpr bool CopiesOfCamerasHaveAll = VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION > 1;

TEST(CullerReasons, OfFrames)
{
  ExpectCaseForEach(vitrine::FrameRows(), FrameCases());
  for (const FrameCase& each : FrameCases())
  {
    SCOPED_TRACE(each.Condition);
    const vitrine::FrameRow* const row = FindRow(vitrine::FrameRows(), each.Condition);
    ASSERT_TRUE(row);
    ReasonScene scene;
    each.Draw(scene);
    if (CopiesOfCamerasHaveAll && std::string(each.Condition) == "works on the picture")
    {
      continue;
    }
    EXPECT_EQ(scene.Culler->GetCullingMode(), static_cast<int>(row->Mode));
    EXPECT_STREQ(scene.Culler->GetCullingModeAsString(), vitrine::NameOf(row->Mode));
    EXPECT_EQ(scene.Culler->GetReason(), vitrine::Sentence(row->Condition, each.Detail, row->Why));
    static_cast<void>(scene.ExpectSame());
  }
}

TEST(CullerReasons, OfPropsThatAreKept)
{
  ExpectCaseForEach(vitrine::KeepRows(), KeepCases());
  for (const KeepCase& each : KeepCases())
  {
    SCOPED_TRACE(each.Condition);
    const vitrine::KeepRow* const row = FindRow(vitrine::KeepRows(), each.Condition);
    ASSERT_TRUE(row);
    ReasonScene scene;
    const vtkSmartPointer<vtkProp> kept = each.Make(scene);
    scene.Render();
    EXPECT_EQ(scene.Culler->GetReason(kept),
      "drawn: kept as " + vitrine::Sentence(row->Condition, {}, row->Why));
    static_cast<void>(scene.ExpectSame());
  }
}

TEST(CullerReasons, OfProps)
{
  const std::vector<PropCase> cases = PropCases();
  EXPECT_EQ(cases.size(), vitrine::PropRows().size());
  for (const vitrine::PropRow& row : vitrine::PropRows())
  {
    int count = 0;
    for (const PropCase& each : cases)
    {
      const std::vector<vitrine::PropRow> rows = RowsOf(each.Stage);
      const vitrine::PropRow* const found = FindRow(rows, each.Condition);
      count += found && each.Stage == row.Stage && std::string(found->Condition) == row.Condition;
    }
    EXPECT_EQ(count, 1) << "cases of: " << row.Condition;
  }
  for (const PropCase& each : cases)
  {
    SCOPED_TRACE(each.Condition);
    const std::vector<vitrine::PropRow> rows = RowsOf(each.Stage);
    const vitrine::PropRow* const row = FindRow(rows, each.Condition);
    ASSERT_TRUE(row);
    ReasonScene scene;
    const vtkSmartPointer<vtkProp> prop = each.Make(scene);
    for (int frame = 0; frame < each.Frames; ++frame)
    {
      if (scene.ChangeBefore)
      {
        scene.ChangeBefore->Modified();
      }
      scene.Render();
    }
    if (HasCoordinateSystems || each.Condition != RoomOrDevice)
    {
      ExpectTold(scene, prop, each, *row);
    }
    static_cast<void>(scene.ExpectSame());
    if (each.Stage == PropStage::Data) // VTK complains of a mapper without any
    {
      EXPECT_FALSE(TakeMessages().empty());
    }
    vtkMapper::SetResolveCoincidentTopologyToOff();
  }
}

TEST(CullerReasons, OfWhatIsLeftOutAndOfWhatShows)
{
  ReasonScene scene;
  EXPECT_EQ(scene.Culler->GetCullingMode(), vtkHierarchicalSBufferCuller::OFF);
  EXPECT_STREQ(scene.Culler->GetReason(), "no frame has been drawn yet");
  const vtkSmartPointer<vtkActor> outside = scene.AddBox({ 40.0, 0.0, 0.3 }, { 0.1, 0.1, 0.1 });
  const vtkSmartPointer<vtkActor> invisible = scene.AddFront();
  invisible->VisibilityOff();
  scene.Render();
  EXPECT_EQ(scene.Culler->GetCullingMode(), vtkHierarchicalSBufferCuller::OCCLUSION);
  EXPECT_STREQ(scene.Culler->GetReason(), "");
  EXPECT_STREQ(scene.Culler->GetReason(scene.Wall), "visible");
  EXPECT_STREQ(scene.Culler->GetReason(scene.Boxes[0]), "left out: hidden by others");
  EXPECT_STREQ(scene.Culler->GetReason(outside), "left out: outside of the view");
  const char* const isAbsent = "not drawn: it is not among the visible props of the last frame";
  EXPECT_STREQ(scene.Culler->GetReason(invisible), isAbsent);
  EXPECT_STREQ(
    scene.Culler->GetReason(static_cast<vtkProp*>(nullptr)), "not drawn: there is no prop");
  scene.Culler->CullingOff();
  scene.Render();
  EXPECT_EQ(scene.Culler->GetReason(scene.Wall),
    "drawn, as nothing is left out of the frame: " + std::string(scene.Culler->GetReason()));
  EXPECT_STREQ(scene.Culler->GetReason(invisible), isAbsent);
  scene.Culler->CullingOn();
  scene.Renderer->RemoveAllViewProps();
  scene.Render();
  EXPECT_STREQ(scene.Culler->GetReason(), "no prop is visible");
  EXPECT_STREQ(scene.Culler->GetReason(scene.Wall), "not drawn: no prop is visible");
}

// A part is drawn though others hide it where it may shine through, or where the view alone hides.
TEST(CullerReasons, OfWhatIsDrawnForTheFrame)
{
  ReasonScene scene;
  const vtkSmartPointer<vtkActor> front = scene.AddFront(0.5);
  front->ForceOpaqueOn();
  vtkActor* const middle = scene.Boxes[scene.Boxes.size() / 2];
  scene.Render();
  EXPECT_EQ(scene.Culler->GetReason(middle), "drawn: " + std::string(scene.Culler->GetReason()));
  EXPECT_STREQ(scene.Culler->GetReason(scene.Boxes[0]), "left out: hidden by others");
  scene.Window->LineSmoothingOn();
  scene.Render();
  EXPECT_EQ(scene.Culler->GetReason(middle),
    "drawn, as only the view hides in this frame: " + std::string(scene.Culler->GetReason()));
}

TEST(CullerReasons, OfPartsOfAnActor)
{
  ReasonScene scene;
  const vtkSmartPointer<vtkActor> blocks = AddBlocks(scene, { -0.3, 0.0, 40.0, 50.0 });
  scene.Render();
  EXPECT_STREQ(scene.Culler->GetReason(blocks), "visible; 2 of its 4 parts are left out");
  blocks->SetPosition(0.0, 0.0, -0.8);
  scene.Render();
  EXPECT_STREQ(scene.Culler->GetReason(blocks), "left out: hidden by others");
  blocks->SetPosition(90.0, 0.0, 0.0);
  scene.Render();
  EXPECT_STREQ(scene.Culler->GetReason(blocks), "left out: outside of the view");
}

// Rows that leave out least stand first, so that the first one that applies decides.
TEST(CullerReasons, StrongestRowsStandFirst)
{
  const std::vector<vitrine::FrameRow>& rows = vitrine::FrameRows();
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    EXPECT_LE(rows[i - 1].Mode, rows[i].Mode) << rows[i].Condition;
  }
}

// What is asked for after the frame may have changed since.
TEST(CullerReasons, OfAnActorThatHasLostItsMapper)
{
  ReasonScene scene;
  const vtkSmartPointer<vtkActor> splat = AddSplat(scene);
  scene.Render();
  EXPECT_NE(
    std::string(scene.Culler->GetReason(splat)).find("PointGaussianMapper"), std::string::npos)
    << scene.Culler->GetReason(splat);
  splat->SetMapper(nullptr);
  EXPECT_NE(
    std::string(scene.Culler->GetReason(splat)).find("the class of its mapper is not known: "),
    std::string::npos)
    << scene.Culler->GetReason(splat);
}

TEST(CullerReasons, OfADeletedPropThatBlends)
{
  ReasonScene scene;
  vtkSmartPointer<vtkActor> front = scene.AddFront(0.5);
  front->ForceOpaqueOn();
  scene.Render();
  const std::string reason = scene.Culler->GetReason();
  EXPECT_NE(reason.find("vtkOpenGLActor: its opacity"), std::string::npos) << reason;
  scene.Renderer->RemoveActor(front);
  front = nullptr;
  EXPECT_NE(
    std::string(scene.Culler->GetReason()).find("a deleted prop: its opacity"), std::string::npos)
    << scene.Culler->GetReason();
}

/** An actor that is always at the same address. There may be one at a time. */
class PlacedActor : public vtkOpenGLActor
{
public:
  static PlacedActor* New() { VTK_STANDARD_NEW_BODY(PlacedActor); }
  vtkTypeMacro(PlacedActor, vtkOpenGLActor);

  static void* operator new(std::size_t) { return Place; }
  static void operator delete(void*) {}

private:
  alignas(64) static unsigned char Place[4096];
};
unsigned char PlacedActor::Place[4096];
static_assert(sizeof(PlacedActor) <= 4096, "it fits into its place");

TEST(CullerReasons, OfAPropAtTheAddressOfADeletedOne)
{
  ReasonScene scene;
  auto actor = vtkSmartPointer<PlacedActor>::New();
  actor->SetMapper(scene.Wall->GetMapper());
  scene.Renderer->AddActor(actor);
  scene.Render();
  EXPECT_NE(std::string(scene.Culler->GetReason(actor)).find("always drawn"), std::string::npos);
  scene.Renderer->RemoveActor(actor);
  actor = nullptr;
  actor = vtkSmartPointer<PlacedActor>::New();
  EXPECT_STREQ(scene.Culler->GetReason(actor),
    "not drawn: it is not among the visible props of the last frame");
}

// Asking whether passes draw by another camera would make the camera.
TEST(CullerReasons, CreateNoCamera)
{
  ReasonScene scene;
  vtkNew<vtkRenderer> renderer;
  renderer->SetRenderWindow(scene.Window);
  vtkNew<vtkToneMappingPass> mapping;
  mapping->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
  renderer->SetPass(mapping);
  scene.CullAlone(renderer);
  EXPECT_FALSE(renderer->IsActiveCameraCreated());
  EXPECT_NE(std::string(scene.Culler->GetReason()).find("no camera yet"), std::string::npos)
    << scene.Culler->GetReason();
  renderer->SetRenderWindow(nullptr);
}

}
