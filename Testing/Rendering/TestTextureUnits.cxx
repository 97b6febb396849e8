/**
 * More actors of composite data than the driver has texture units. From VTK 9.4 on each of VTK's mappers keeps a unit.
 */
#include "CompositeMapper.h"
#include "vtkActor.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSeeThroughPass.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
vtkSmartPointer<vtkPolyData> PlateAt(int number)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0 + 0.01 * number, -1.0, -0.01 * number);
  plane->SetPoint1(1.0, -1.0, -0.01 * number);
  plane->SetPoint2(-1.0 + 0.01 * number, 1.0 - 0.02 * number, -0.01 * number);
  plane->Update();
  return plane->GetOutput();
}

template <class Mapper>
vtkSmartPointer<vtkMapper> BlockMapperOf(vtkPolyData* data)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, data);
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetInputDataObject(blocks);
  return mapper;
}

vtkSmartPointer<vtkMapper> PlainMapperOf(vtkPolyData* data)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  return mapper;
}

/** The second frame of translucent plates, whose mappers a function makes. */
std::vector<unsigned char> PictureOf(
  int numberOfPlates, vtkSmartPointer<vtkMapper> (*mapperOf)(vtkPolyData*))
{
  vtkNew<vtkHeadlessRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetMultiSamples(0);
  window->SetSize(48, 32);
  window->AddRenderer(renderer);
  for (int i = 0; i < numberOfPlates; ++i)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapperOf(PlateAt(i)));
    actor->GetProperty()->SetColor(0.2 + 0.02 * i, 0.5, 1.0 - 0.02 * i);
    actor->GetProperty()->SetOpacity(0.2);
    renderer->AddActor(actor);
  }
  vtkNew<vtkPrefixSumTransparencyPass> method;
  vtkNew<vtkSeeThroughPass> pass;
  pass->SetTranslucentPass(method);
  pass->Attach(renderer);
  window->Render();
  window->Render();
  EXPECT_STREQ(method->GetFallbackReason(), "");
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 47, 31, 0, pixels, 0);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}
}

// Most drivers have 32 units. VTK warns where it has none itself.
TEST(TextureUnits, AreEnoughBesideManyCompositeMappers)
{
  const std::vector<unsigned char> plain = PictureOf(31, PlainMapperOf);
  ASSERT_EQ(plain.size(), 48u * 32u * 3u);
  EXPECT_EQ(PictureOf(31, BlockMapperOf<CompositeMapper>), plain);
}

TEST(TextureUnits, AreFreedByCulledCompositeMappers)
{
  EXPECT_EQ(
    PictureOf(40, BlockMapperOf<vtkCulledCompositePolyDataMapper>), PictureOf(40, PlainMapperOf));
}
