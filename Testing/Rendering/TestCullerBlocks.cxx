// Tests blocks of a composite mapper that hide each other. The picture must equal that of VTK's own mapper in every
// pixel.
#include "CompositeMapper.h"
#include "CullerScene.h"
#include "Select.h"
#include "culling/PartGeometry.h"
#include "culling/mappers/DividedMapper.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCullerCollection.h"
#include "vtkDoubleArray.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace
{

using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;
using Mesh = vtkSmartPointer<vtkPolyData>;

Mesh MakeWall(double z = 0.0, double halfWidth = 2.5)
{
  return MeshOf({ Rectangle(-halfWidth, -halfWidth, halfWidth, halfWidth, z) });
}

Mesh MakeBlock(double x, double y, double z)
{
  const double w = 0.05, d = 0.04;
  const auto side = [&](Quad quad, int a, int b, int c)
  {
    for (Point3& p : quad)
    {
      const Point3 q = p;
      p = { x + w * q[a], y + w * q[b], z + d * q[c] };
    }
    return quad;
  };
  const Quad front = Rectangle(-1, -1, 1, 1, 1), back = Rectangle(-1, -1, 1, 1, -1);
  return MeshOf({ side(front, 0, 1, 2), side(back, 0, 1, 2), side(front, 1, 2, 0),
    side(back, 1, 2, 0), side(front, 2, 0, 1), side(back, 2, 0, 1) });
}

/** A layer of 63 blocks, all of them behind a wall at 0 where z is less. */
Blocks MakeLayer(double z = -0.4)
{
  auto layer = Blocks::New();
  for (int row = -3; row <= 3; ++row)
  {
    for (int column = -4; column <= 4; ++column)
    {
      layer->SetBlock(layer->GetNumberOfBlocks(), MakeBlock(0.2 * column, 0.24 * row, z));
    }
  }
  return layer;
}

constexpr int LayerSize = 63;

class CullerBlocks : public CullerTest
{
protected:
  CullerBlocks()
  {
    this->Mapper->SetInputDataObject(this->Root);
    this->Mapper->SetCompositeDataDisplayAttributes(this->Attributes);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    Scene.Renderer->AddActor(this->Actor);
  }

  void Add(vtkDataObject* block) { this->Root->SetBlock(this->Root->GetNumberOfBlocks(), block); }

  /** A wall, and 63 blocks behind it, each of a colour of its own. */
  void AddWallAndLayer()
  {
    this->Wall = MakeWall();
    this->Layer = MakeLayer();
    this->Add(this->Wall);
    this->Add(this->Layer);
    this->PaintBlocks(this->Layer);
  }

  void PaintBlocks(vtkMultiBlockDataSet* blocks)
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      const double color[3] = { 0.5 + 0.007 * i, 0.01 * i, 0.2 };
      this->Attributes->SetBlockColor(blocks->GetBlock(i), color);
    }
    this->Mapper->Modified();
  }

  /** Expects the same with the culler, without it, and by VTK's own mapper. Returns how many parts were left out. */
  int ExpectAsVTK()
  {
    const int leftOut = Scene.ExpectSame();
    const Picture whole = Scene.Render(); // without culling
    this->Plain->SetInputDataObject(this->Mapper->GetInputDataObject(0, 0));
    this->Plain->SetCompositeDataDisplayAttributes(this->Attributes);
    this->Plain->Modified();
    this->Actor->SetMapper(this->Plain);
    EXPECT_TRUE(Matches(Scene.Render(), whole));
    this->Actor->SetMapper(this->Mapper);
    return leftOut;
  }

  /** After each change all of the layer shows, and none of it in turn. */
  void ExpectAsVTKAfter(const std::vector<std::function<void()>>& changes)
  {
    EXPECT_EQ(this->ExpectAsVTK(), LayerSize);
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      SCOPED_TRACE("change " + std::to_string(i));
      changes[i]();
      EXPECT_EQ(this->ExpectAsVTK() >= LayerSize, i % 2 == 1);
    }
  }

  vtkNew<vtkMultiBlockDataSet> Root;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  vtkNew<vtkCulledCompositePolyDataMapper> Mapper;
  vtkNew<CompositeMapper> Plain; ///< VTK's
  vtkNew<vtkActor> Actor;
  Mesh Wall;
  Blocks Layer;
};

TEST_P(CullerBlocks, HideEachOther)
{
  this->AddWallAndLayer();
  this->Add(MakeLayer(0.3));
  EXPECT_EQ(this->ExpectAsVTK(), LayerSize);
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 1);
  TestRandom random(300);
  for (int pose = 0; pose < 3; ++pose)
  {
    Scene.LookFromAnywhere(random);
    EXPECT_GE(this->ExpectAsVTK(), 2 * LayerSize / 3) << "some are seen from their edge";
  }
}

TEST_P(CullerBlocks, HideActorsAndAreHiddenByThem)
{
  Scene.AddWall(0.5);
  Scene.AddHidden(-0.4);
  this->AddWallAndLayer();
  EXPECT_EQ(this->ExpectAsVTK(), LayerSize + 1 + 63);
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 1);
}

// Colours and normals of cells are looked up by the number of the primitive, which no block may shift for others.
TEST_P(CullerBlocks, KeepColorsOfCellsAndPoints)
{
  this->Wall = MeshOf({ Rectangle(-0.35, -2.0, 2.0, 2.0, 0.0) });
  this->Layer = MakeLayer();
  this->Add(this->Wall);
  this->Add(this->Layer);
  TestRandom random(301);
  for (unsigned int i = 0; i < this->Layer->GetNumberOfBlocks(); ++i)
  {
    auto* mesh = vtkPolyData::SafeDownCast(this->Layer->GetBlock(i));
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    const bool isOfCells = i % 3 != 0;
    for (vtkIdType k = 0; k < (isOfCells ? 6 : 24); ++k)
    {
      colors->InsertNextTuple3(255 * random.Unit(), 255 * random.Unit(), 255 * random.Unit());
    }
    (isOfCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) : mesh->GetPointData())
      ->SetScalars(colors);
  }
  EXPECT_GT(this->ExpectAsVTK(), 20);
  EXPECT_LT(this->ExpectAsVTK(), LayerSize);
  this->Actor->GetProperty()->LightingOn();
  EXPECT_GT(this->ExpectAsVTK(), 20);
}

TEST_P(CullerBlocks, HideByWhatTheyAreSetTo)
{
  this->AddWallAndLayer();
  vtkCompositeDataDisplayAttributes* set = this->Attributes;
  const auto with = [&](const std::function<void()>& change)
  {
    return [=]
    {
      change();
      this->Mapper->Modified();
    };
  };
  const auto color = [&](double red, double alpha)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    colors->InsertNextTuple4(red, 90, 90, alpha);
    this->Wall->GetCellData()->SetScalars(colors);
    this->Mapper->Modified(); // VTK looks for what blocks have only then
  };
  this->ExpectAsVTKAfter({
    with([=] { set->SetBlockVisibility(this->Wall, false); }),
    with([=] { set->SetBlockVisibility(this->Wall, true); }),
    with([=] { set->SetBlockOpacity(this->Wall, 0.5); }),
    with([=] { set->RemoveBlockOpacity(this->Wall); }),
    with([=] { set->SetBlockOpacity(this->Root, 0.5); }),
    with([=] { set->SetBlockOpacity(this->Root, 1.0); }),
    [=] { color(200, 120); },
    [=] { color(200, 255); },
    [=] { this->Actor->GetProperty()->SetOpacity(0.5); },
    [=] { this->Actor->GetProperty()->SetOpacity(1.0); },
    [=] { this->Actor->ForceTranslucentOn(); },
    [=] { this->Actor->ForceTranslucentOff(); },
    [=] { this->Actor->GetProperty()->SetRepresentationToWireframe(); },
    [=] { this->Actor->GetProperty()->SetRepresentationToSurface(); },
    [=] { this->Actor->GetProperty()->FrontfaceCullingOn(); },
    [=] { this->Actor->GetProperty()->FrontfaceCullingOff(); },
  });
}

// Composite mappers ask all of their table for blocks without scalars.
TEST_P(CullerBlocks, WithoutScalarsAreAsOpaqueAsTheTable)
{
  this->AddWallAndLayer();
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.99, 1.0);
  table->Build();
  for (const auto& mapper :
    { static_cast<vtkMapper*>(this->Mapper), static_cast<vtkMapper*>(this->Plain) })
  {
    mapper->ScalarVisibilityOn();
    mapper->SetLookupTable(table);
  }
  EXPECT_EQ(this->ExpectAsVTK(), 0);
  table->SetAlphaRange(1.0, 1.0);
  table->ForceBuild();
  this->Mapper->Modified();
  EXPECT_EQ(this->ExpectAsVTK(), LayerSize);
}

// A group that is not to be seen, but for the wall in it; and translucent blocks, which are hidden like others.
TEST_P(CullerBlocks, InheritFromGroups)
{
  this->AddWallAndLayer();
  this->Attributes->SetBlockVisibility(this->Layer, false);
  EXPECT_EQ(this->ExpectAsVTK(), 0);
  this->Attributes->SetBlockVisibility(this->Root, false);
  this->Attributes->SetBlockVisibility(this->Layer, true);
  this->Mapper->Modified();
  EXPECT_EQ(this->ExpectAsVTK(), 0); // the wall is not there
  this->Attributes->SetBlockVisibility(this->Wall, true);
  this->Attributes->SetBlockOpacity(this->Layer, 0.4);
  this->Mapper->Modified();
  EXPECT_EQ(this->ExpectAsVTK(), LayerSize);
  Scene.Use(vtkSmartPointer<vtkLinkedListTransparencyPass>::New());
  EXPECT_EQ(Scene.ExpectSame(), LayerSize);
  this->Wall->GetPoints()->SetPoint(0, 0.1, 0.2, 0.0);
  this->Wall->GetPoints()->Modified();
  EXPECT_LT(Scene.ExpectSame(), LayerSize);
}

TEST_P(CullerBlocks, MayBeEmptyAndSharedAndNested)
{
  this->AddWallAndLayer();
  this->Add(nullptr);
  vtkNew<vtkPolyData> empty;
  this->Add(empty);
  vtkNew<vtkMultiBlockDataSet> none, outer, inner;
  this->Add(none);
  inner->SetBlock(2, this->Layer->GetBlock(5));
  inner->SetBlock(3, MakeBlock(0.1, 0.1, 0.5));
  outer->SetBlock(1, inner);
  outer->SetBlock(2, this->Wall);
  this->Add(outer);
  this->Attributes->SetBlockOpacity(inner, 0.5);
  EXPECT_EQ(Scene.ExpectSame(), LayerSize); // one of the layer is in two places
  this->Attributes->SetBlockOpacity(outer, 0.5);
  this->Mapper->Modified();
  EXPECT_EQ(
    Scene.ExpectSame(), 0); // one of the walls is translucent, which may be the one that counts
}

TEST_P(CullerBlocks, ChangeBetweenFrames)
{
  this->AddWallAndLayer();
  const Mesh other = MakeWall(0.1);
  const Mesh small = MakeWall(0.0, 0.05);
  vtkNew<vtkMultiBlockDataSet> roots[2];
  roots[0]->SetBlock(0, this->Layer);
  roots[1]->SetBlock(1, this->Layer);
  roots[1]->SetBlock(2, other);
  const auto lift = [](vtkPolyData* mesh, double x)
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const double* point = mesh->GetPoint(i);
      mesh->GetPoints()->SetPoint(i, point[0] + x, point[1], point[2]);
    }
    mesh->GetPoints()->Modified();
  };
  this->ExpectAsVTKAfter({
    [&] { lift(this->Wall, 3.0); },
    [&] { lift(this->Wall, -3.0); },
    [&] { this->Root->SetBlock(0, small); },
    [&] { this->Root->SetBlock(0, other); },
    [&] { this->Root->SetBlock(0, nullptr); },
    [&] { this->Root->SetBlock(70, this->Wall); },
    [&] { this->Mapper->SetInputDataObject(roots[0]); },
    [&] { this->Mapper->SetInputDataObject(roots[1]); },
    [&] { other->DeepCopy(small); },
    [&] { other->DeepCopy(this->Wall); },
    [&] { this->Mapper->SetInputDataObject(small); }, // a mesh and no blocks
    [&] { this->Mapper->SetInputDataObject(this->Root); },
  });
}

// A device may draw all blocks relative to the middle of a small one that is far off. By sums of absolute values, other
// blocks are as far from there as it is from the origin.
TEST(CullerBlocksFarOff, CountFromTheMiddleOfASmallOne)
{
  const double away = 4000.0;
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto farthestAlong = [&]
  {
    vtkNew<vtkCulledCompositePolyDataMapper> mapper;
    mapper->SetInputDataObject(blocks);
    return vitrine::DividedMapperOf(mapper)->PartsFor(nullptr, 1)->Farthest.x;
  };
  blocks->SetBlock(0, MeshOf({ Rectangle(-away, -1.0, 0.0, 1.0, 0.0) }));
  EXPECT_EQ(farthestAlong(), away);
  blocks->SetBlock(1, MeshOf({ Rectangle(away - 1.0, -1.0, away, 1.0, 0.0) }));
  EXPECT_GE(farthestAlong(), 3.0 * away - 2.0);
}

TEST_P(CullerBlocks, BelongToActorsThatShareTheirMapper)
{
  this->AddWallAndLayer();
  vtkNew<vtkActor> turned, behind;
  for (vtkActor* actor : { turned.Get(), behind.Get() })
  {
    actor->SetMapper(this->Mapper);
    actor->SetProperty(this->Actor->GetProperty());
    Scene.Renderer->AddActor(actor);
  }
  turned->RotateY(180.0); // its layer stands in front of its wall
  turned->SetScale(0.7);
  turned->SetPosition(0.0, 0.0, 0.2);
  behind->SetPosition(0.0, 0.0, -1.0);
  EXPECT_GE(Scene.ExpectSame(), 2 * LayerSize + 1);
  turned->VisibilityOff();
  this->Actor->SetPosition(2.0, 0.0, 0.0);
  EXPECT_GT(Scene.ExpectSame(), LayerSize);
}

TEST_P(CullerBlocks, OfVTKsMapperAreLeftOutTogether)
{
  this->AddWallAndLayer();
  this->Plain->SetInputDataObject(this->Root);
  this->Plain->SetCompositeDataDisplayAttributes(this->Attributes);
  this->Actor->SetMapper(this->Plain);
  EXPECT_EQ(Scene.ExpectSame(), 0) << "the wall shows";
  vtkNew<vtkActor> behind;
  behind->SetMapper(this->Plain);
  behind->SetProperty(this->Actor->GetProperty());
  behind->SetPosition(0.5, 0.0, -1.0);
  behind->SetScale(0.1);
  Scene.Renderer->AddActor(behind);
  EXPECT_EQ(Scene.ExpectSame(), LayerSize + 1);
  Scene.Culler->CullingOn();
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfDrawnProps(), 1);
  this->Attributes->SetBlockVisibility(this->Wall, false);
  this->Plain->Modified();
  EXPECT_LT(Scene.ExpectSame(), LayerSize + 1) << "the wall hides nothing more";
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerBlocks, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
