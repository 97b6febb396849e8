// Walls whose colours are not what their mappers tell beforehand: nothing is lost that shines through them.
#include "CullerScene.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace
{

/** Two colours of the same alpha, for 0 and for 1. */
vtkSmartPointer<vtkLookupTable> MakeTable(double alpha)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 0.2, 0.2, 0.4, alpha);
  table->SetTableValue(1, 0.3, 0.5, 0.4, alpha);
  table->SetRange(0.0, 1.0);
  return table;
}

/** Of 0 and 1 in turn, which bring a table of their own unless its alpha is less than 0. */
vtkSmartPointer<vtkFloatArray> MakeScalars(int count, double alpha)
{
  auto scalars = vtkSmartPointer<vtkFloatArray>::New();
  for (int i = 0; i < count; ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 2));
  }
  if (alpha >= 0.0)
  {
    scalars->SetLookupTable(MakeTable(alpha));
  }
  return scalars;
}

/** A table of colours of a user's, which tells nothing of its alpha. */
template <class Base>
class Glass : public Base
{
public:
  static Glass* New() { VTK_STANDARD_NEW_BODY(Glass); }
  int IsOpaque() override { return 1; }
  int IsOpaque(vtkAbstractArray*, int, int) override { return 1; }
  void MapScalarsThroughTable2(
    void*, unsigned char* colors, int, int count, int, int components) override
  {
    std::fill_n(colors, components * count, 70);
  }
};

class CullerColors : public CullerTest
{
protected:
  CullerColors()
    : Boxes(Scene.AddHidden()) // first, so that they show through whatever is blended
    , Wall(Scene.AddWall())
    , Mapper(static_cast<vtkPolyDataMapper*>(Wall->GetMapper()))
  {
    this->Mapper->UseLookupTableScalarRangeOn();
  }

  vtkPointData* Points() { return this->Mapper->GetInput()->GetPointData(); }

  void ExpectSeenThrough()
  {
    Scene.ExpectNothingHidden(310, 1);
    EXPECT_TRUE(Scene.ShowsUnculled(this->Boxes));
    this->ExpectHiddenByAPlainWall();
  }

  void ExpectHiddenByAPlainWall()
  {
    const vtkSmartPointer<vtkActor> plain = Scene.AddWall(0.5);
    this->Wall->VisibilityOff();
    Scene.LookAhead();
    EXPECT_EQ(Scene.ExpectSame(), static_cast<int>(this->Boxes.size()));
    this->Wall->VisibilityOn();
    Scene.Renderer->RemoveActor(plain);
  }

  // Tests the first frame after a change. Mappers adopt the lookup tables of their arrays while they draw, and VTK
  // draws differently from then on.
  void ExpectNothingHiddenAtFirst(const std::function<void()>& change)
  {
    Picture pictures[2];
    for (const bool isCulled : { false, true })
    {
      Scene.Culler->SetCulling(isCulled);
      change();
      pictures[isCulled] = Scene.Render();
    }
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), 0);
    Scene.ExpectSamePictures(pictures[1], pictures[0]);
  }

  void ExpectHidden()
  {
    Scene.ExpectHidden(311, 1);
    EXPECT_FALSE(Scene.ShowsUnculled(this->Boxes));
  }

  // Scalars at the wall's corners that a table makes colours of.
  void Color(vtkScalarsToColors* table)
  {
    this->Points()->SetScalars(MakeScalars(4, -1.0));
    this->Mapper->SetLookupTable(table);
  }

  template <class Array>
  void ColorDirectly(double most, double lastAlpha)
  {
    vtkNew<Array> colors;
    colors->SetNumberOfComponents(4);
    for (int i = 0; i < 4; ++i)
    {
      colors->InsertNextTuple4(0.2 * most, 0.3 * most, 0.4 * most, i < 3 ? most : lastAlpha);
    }
    this->Points()->SetScalars(colors);
    this->Mapper->SetColorModeToDirectScalars();
  }

  // Draws the wall as blocks side by side, whose arrays bring tables of these alphas.
  void DrawBlocks(const std::vector<double>& alphas)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    const double width = 5.0 / static_cast<double>(alphas.size());
    for (const double alpha : alphas)
    {
      const double left = width * blocks->GetNumberOfBlocks() - 2.5;
      const vtkSmartPointer<vtkPolyData> block =
        MeshOf({ Rectangle(left, -2.5, left + width, 2.5, 0.0) });
      block->GetPointData()->SetScalars(MakeScalars(4, alpha));
      blocks->SetBlock(blocks->GetNumberOfBlocks(), block);
    }
    vtkNew<vtkCulledCompositePolyDataMapper> mapper;
    mapper->SetInputDataObject(blocks);
    mapper->UseLookupTableScalarRangeOn();
    this->Wall->SetMapper(mapper);
  }

  std::vector<vtkSmartPointer<vtkActor>> Boxes;
  vtkSmartPointer<vtkActor> Wall;
  vtkPolyDataMapper* Mapper;
};

TEST_P(CullerColors, PointsBringATranslucentTable)
{
  this->Points()->SetScalars(MakeScalars(4, 0.3));
  for (int again = 0; again < 3; ++again)
  {
    this->ExpectNothingHiddenAtFirst([&] { Mapper->SetLookupTable(MakeTable(1.0)); });
  }
  this->ExpectSeenThrough();
  this->ExpectNothingHiddenAtFirst(
    [&]
    {
      Mapper->SetLookupTable(MakeTable(1.0));
      Wall->SetPosition(99.0, 0.0, 0.0); // out of view, where it takes the table without culling
      Scene.Render();
      Wall->SetPosition(0.0, 0.0, 0.0);
    });
}

TEST_P(CullerColors, CellsBringATranslucentTable)
{
  this->Mapper->GetInput()->GetCellData()->SetScalars(MakeScalars(1, 0.3));
  this->ExpectNothingHiddenAtFirst([&] { Mapper->SetLookupTable(MakeTable(1.0)); });
  this->ExpectSeenThrough();
}

// An opaque one hides once the mapper has it.
TEST_P(CullerColors, PointsBringAnOpaqueTableAndAnotherLater)
{
  this->Points()->SetScalars(MakeScalars(4, 1.0));
  EXPECT_EQ(Scene.ExpectSame(), 0);
  this->ExpectHidden();
  this->ExpectNothingHiddenAtFirst(
    [&]
    {
      Points()->GetScalars()->SetLookupTable(MakeTable(1.0));
      Scene.Render();
      Scene.Render();
      Points()->GetScalars()->SetLookupTable(MakeTable(0.3));
    });
  this->ExpectSeenThrough();
}

// Blocks that bring none may get that of one before.
TEST_P(CullerColors, BlocksBringTables)
{
  for (const std::vector<double>& alphas :
    { std::vector<double>{ 0.3 }, { 0.3, 1.0 }, { 1.0, 0.3 }, { 0.3, -1.0 } })
  {
    this->DrawBlocks(alphas);
    this->ExpectSeenThrough();
  }
}

TEST_P(CullerColors, NamesWithAnAlphaEach)
{
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfValues(4); // all of them empty
  this->Points()->AddArray(names);
  vtkNew<vtkDiscretizableColorTransferFunction> colors;
  colors->IndexedLookupOn();
  colors->SetAnnotation(vtkVariant(""), "none");
  colors->SetIndexedColor(0, 0.2, 0.3, 0.5, 0.4);
  colors->Build();
  this->Mapper->SetLookupTable(colors);
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectColorArray("names");
  this->ExpectSeenThrough();
}

TEST_P(CullerColors, NumbersWithAnAlphaEach)
{
  for (const double alpha : { 1.0, 0.4 })
  {
    vtkNew<vtkDiscretizableColorTransferFunction> colors;
    colors->IndexedLookupOn();
    for (int i = 0; i < 2; ++i)
    {
      colors->SetAnnotation(vtkVariant(static_cast<float>(i)), "");
      colors->SetIndexedColor(i, 0.2, 0.3 * i, 0.5, i == 0 ? 1.0 : alpha);
    }
    colors->Build();
    this->Color(colors);
    alpha < 1.0 ? this->ExpectSeenThrough() : this->ExpectHidden();
  }
}

TEST_P(CullerColors, TablesOfAUsersClass)
{
  this->Color(vtkSmartPointer<Glass<vtkScalarsToColors>>::New());
  this->ExpectSeenThrough();
  this->Color(vtkSmartPointer<Glass<vtkLookupTable>>::New());
  this->ExpectSeenThrough();
}

TEST_P(CullerColors, DirectAlphaThatIsNoNumber)
{
  this->ColorDirectly<vtkFloatArray>(1.0, std::numeric_limits<double>::quiet_NaN());
  this->ExpectSeenThrough();
  this->ColorDirectly<vtkFloatArray>(1.0, 1.0); // which need not hide
  Scene.ExpectNothingHidden(312, 1);
  this->ColorDirectly<vtkUnsignedCharArray>(255.0, 255.0);
  this->ExpectHidden();
}

TEST_P(CullerColors, VectorsThatAreColors)
{
  this->ColorDirectly<vtkFloatArray>(1.0, 0.3);
  const vtkSmartPointer<vtkLookupTable> table = MakeTable(1.0);
  table->SetVectorModeToRGBColors();
  this->Mapper->SetLookupTable(table);
  this->Mapper->SetColorModeToMapScalars();
  this->Mapper->SetArrayComponent(-1);
  this->ExpectSeenThrough();
}

TEST_P(CullerColors, UsualTablesHide)
{
  vtkNew<vtkColorTransferFunction> function;
  vtkNew<vtkDiscretizableColorTransferFunction> steps;
  function->AddRGBPoint(0.0, 0.2, 0.3, 0.5);
  steps->AddRGBPoint(0.0, 0.2, 0.3, 0.5);
  steps->DiscretizeOn();
  for (const vtkSmartPointer<vtkScalarsToColors>& each :
    std::vector<vtkSmartPointer<vtkScalarsToColors>>{ MakeTable(1.0), function, steps })
  {
    this->Color(each);
    this->ExpectHidden();
  }
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerColors, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
