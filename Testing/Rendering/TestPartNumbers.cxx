// Numbers of the parts of a renderer (scene/PartNumbers).

#include "scene/PartNumbers.h"

#include "vtkActor.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::PartNumbers;

TEST(PartNumbers, ArePropsThatLive)
{
  vtkNew<vtkRenderer> renderer;
  PartNumbers& numbers = PartNumbers::Of(renderer);
  EXPECT_EQ(&PartNumbers::Of(renderer), &numbers);
  vtkNew<vtkActor> first;
  auto second = vtkSmartPointer<vtkActor>::New();
  const std::uint32_t ofFirst = numbers.FirstOf(first);
  const std::uint32_t ofSecond = numbers.FirstOf(second);
  EXPECT_EQ(ofFirst, 1u);
  EXPECT_EQ(ofSecond, 2u);
  EXPECT_EQ(numbers.FirstOf(first), ofFirst);
  EXPECT_EQ(numbers.PartOf(ofFirst).Prop, first);
  EXPECT_EQ(numbers.PartOf(ofSecond).Prop, second.Get());
  EXPECT_EQ(numbers.PartOf(0).Prop, nullptr);
  EXPECT_EQ(numbers.PartOf(3).Prop, nullptr);
  second = nullptr;
  EXPECT_EQ(numbers.PartOf(ofSecond).Prop, nullptr);
  // Thousands of props come and go, some of them at the address of another one.
  for (int i = 0; i < 5000; ++i)
  {
    vtkNew<vtkActor> brief;
    EXPECT_EQ(numbers.PartOf(numbers.FirstOf(brief)).Prop, brief);
  }
  EXPECT_EQ(numbers.FirstOf(first), ofFirst);
  EXPECT_EQ(numbers.PartOf(ofFirst).Prop, first);
}

TEST(PartNumbers, AreFlatIndicesOfBlocks)
{
  vtkNew<vtkRenderer> renderer;
  PartNumbers& numbers = PartNumbers::Of(renderer);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> group;
  vtkNew<vtkPolyData> leaf;
  blocks->SetBlock(0, leaf);
  blocks->SetBlock(2, group); // Block 1 is empty, and counts.
  group->SetBlock(0, leaf);
  vtkNew<vtkCulledCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkActor> other;
  const std::uint32_t first = numbers.FirstOf(actor);
  EXPECT_EQ(numbers.FirstOf(other), first + 5);
  EXPECT_EQ(numbers.PartOf(first + 4).Prop, actor);
  EXPECT_EQ(numbers.PartOf(first + 4).Block, 4u);
  EXPECT_EQ(numbers.PartOf(first + 5).Prop, other);
  // Data that grow get new numbers. The old ones stay valid.
  group->SetBlock(1, leaf);
  const std::uint32_t again = numbers.FirstOf(actor);
  EXPECT_EQ(again, first + 6);
  EXPECT_EQ(numbers.FirstOf(actor), again);
  EXPECT_EQ(numbers.PartOf(first + 4).Block, 4u);
  EXPECT_EQ(numbers.PartOf(again + 5).Block, 5u);
}

TEST(PartNumbers, AreGoneWithTheirRenderer)
{
  vtkNew<vtkActor> actor;
  for (int i = 0; i < 100; ++i)
  {
    vtkNew<vtkRenderer> renderer; // some have the address of one before
    EXPECT_EQ(PartNumbers::Of(renderer).FirstOf(actor), 1u);
  }
}

}
