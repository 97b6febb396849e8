// Settings of the passes and the culler: defaults, ranges, names, and what a value out of range does.
#include "TestMessages.h"
#include "vtkAssemblyIndex.h"
#include "vtkClusteredLightsPass.h"
#include "vtkDeferredLightsPass.h"
#include "vtkHierarchicalSBufferCuller.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkPartLevels.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkSmartPointer.h"
#include "vtkStencilMaskTransparencyPass.h"
#include "vtkStencilRoutedTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double LeastInt = std::numeric_limits<int>::min();
constexpr double MostInt = std::numeric_limits<int>::max();

/** A setting of a class. Values are given as double, whatever its type is. */
struct Setting
{
  const char* Class;
  const char* Name;
  double Default;
  std::vector<double> Good;
  std::vector<double> Bad;
  std::string Range; ///< as errors tell it
  std::function<vtkSmartPointer<vtkObject>()> Make;
  std::function<void(vtkObject*, double)> Set;
  std::function<double(vtkObject*)> Get;
  std::function<std::string(double)> Text; ///< of a value of the setting's type
};

std::ostream& operator<<(std::ostream& os, const Setting& setting)
{
  return os << setting.Class << "::" << setting.Name;
}

using Values = std::vector<double>;

/** Completes a setting by functions for its object, which are generic lambdas. */
template <class Class, class Setter, class Getter>
Setting With(Setting setting, const Setter& set, const Getter& get)
{
  using Value = decltype(get(static_cast<Class*>(nullptr)));
  setting.Make = []
  { return vtkSmartPointer<vtkObject>(vtk::TakeSmartPointer<vtkObject>(Class::New())); };
  setting.Set = [set](vtkObject* object, double value)
  { set(static_cast<Class*>(object), static_cast<Value>(value)); };
  setting.Get = [get](vtkObject* object)
  { return static_cast<double>(get(static_cast<Class*>(object))); };
  setting.Text = [](double value)
  {
    std::ostringstream text;
    text.precision(15);
    text << static_cast<Value>(value);
    return text.str();
  };
  return setting;
}

#define SETTING(Class, Name, Default, Good, Bad, Range)                                            \
  With<Class>(                                                                                     \
    { #Class, #Name, Default, Good, Bad, Range, nullptr, nullptr, nullptr, nullptr },              \
    [](auto* object, auto value) { object->Set##Name(value); },                                    \
    [](auto* object) { return object->Get##Name(); })

std::vector<Setting> AllSettings()
{
  const Values notNegative = { 0.0, 0.5, 1e30, Largest };
  const Values noDistance = { -1.0, -1e-300, Infinity, -Infinity, NaN };
  const std::string finite = "0 to 1.79769313486232e+308";
  const Values noByte = { -1.0, -1e18 };
  const std::string colors = "0 (half float), 1 (eight bit) or 2 (compact)";
  return {
    SETTING(vtkLinkedListTransparencyPass, CoincidenceSteps, 0.0, notNegative, noDistance, finite),
    SETTING(vtkLinkedListTransparencyPass, CoincidenceSlope, 0.0, notNegative, noDistance, finite),
    SETTING(vtkTruthTransparencyPass, CoincidenceSteps, 0.0, notNegative, noDistance, finite),
    SETTING(vtkTruthTransparencyPass, CoincidenceSlope, 0.0, notNegative, noDistance, finite),
    SETTING(vtkLinkedListTransparencyPass, ColorStorage, 0.0, (Values{ 1.0, 2.0, 0.0 }),
      (Values{ -1.0, 3.0, LeastInt, MostInt }), colors),
    SETTING(vtkPrefixSumTransparencyPass, ColorStorage, 0.0, (Values{ 1.0, 2.0, 0.0 }),
      (Values{ -1.0, 3.0, LeastInt, MostInt }), colors),
    SETTING(vtkLinkedListTransparencyPass, MemoryLimit, 0.0, (Values{ 1.0, 1e12, 0.0 }), noByte,
      "0 to 9223372036854775807"),
    SETTING(vtkStencilMaskTransparencyPass, NumberOfLayers, 8.0, (Values{ 4.0, 9.0, 16.0, 8.0 }),
      (Values{ 0.0, -4.0, 5.0, 12.0, 17.0, LeastInt, MostInt }), "4, 8, 9 or 16"),
    SETTING(vtkStencilMaskTransparencyPass, DepthStorage, 0.0, (Values{ 1.0, 0.0 }),
      (Values{ -1.0, 2.0, LeastInt, MostInt }), "0 (full float) or 1 (half float)"),
    SETTING(vtkStencilMaskTransparencyPass, DepthLimit, 0.03, notNegative, noDistance, finite),
    SETTING(vtkStencilMaskTransparencyPass, ColorLimit, 0.03, notNegative, noDistance, finite),
    SETTING(vtkStencilRoutedTransparencyPass, SamplesPerPass, 0.0,
      (Values{ 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 0.0 }),
      (Values{ -1.0, 3.0, 64.0, LeastInt, MostInt }), "0, 1, 2, 4, 8, 16 or 32"),
    SETTING(vtkStencilRoutedTransparencyPass, MaximumNumberOfPasses, 254.0, (Values{ 1.0, 254.0 }),
      (Values{ 0.0, 255.0, LeastInt, MostInt }), "1 to 254"),
    SETTING(vtkStencilRoutedTransparencyPass, ColorStorage, 0.0, (Values{ 1.0, 0.0 }),
      (Values{ -1.0, 2.0, LeastInt, MostInt }), "0 (half float) or 1 (eight bit)"),
    SETTING(vtkClusteredLightsPass, CutOff, 0.5 / 255.0, (Values{ 0.0, 1.0, 0.25 }),
      (Values{ -1e-300, 1.0000001, Infinity, -Infinity, NaN }), "0 to 1"),
    SETTING(vtkClusteredLightsPass, GridSpace, 0.0, (Values{ 1.0, 0.0 }),
      (Values{ -1.0, 2.0, LeastInt, MostInt }), "0 (view) or 1 (world)"),
    SETTING(vtkClusteredLightsPass, TileSize, 64.0, (Values{ 1.0, 4096.0 }),
      (Values{ 0.0, 4097.0, LeastInt, MostInt }), "1 to 4096"),
    SETTING(vtkClusteredLightsPass, NumberOfSlices, 16.0, (Values{ 1.0, 1024.0 }),
      (Values{ 0.0, 1025.0, LeastInt, MostInt }), "1 to 1024"),
    SETTING(vtkClusteredLightsPass, SliceLaw, 0.0, (Values{ 1.0, 2.0, 0.0 }),
      (Values{ -1.0, 3.0, LeastInt, MostInt }), "0 (exponential), 1 (uniform) or 2 (NDC uniform)"),
    SETTING(vtkDeferredLightsPass, Assignment, 2.0, (Values{ 0.0, 1.0, 2.0 }),
      (Values{ -1.0, 3.0, LeastInt, MostInt }), "0 (light volumes), 1 (tiles) or 2 (clusters)"),
    SETTING(vtkAssemblyIndex, MemoryLimit, 0.0, (Values{ 1.0, 1e12, 0.0 }), noByte,
      "0 to 9223372036854775807"),
    SETTING(vtkPartLevels, Pixels, 0.5, (Values{ 0.001, 64.0, 0.5 }),
      (Values{ 0.0, -1.0, 64.5, NaN, Infinity, -Infinity }), "0.001 to 64"),
    SETTING(vtkHierarchicalSBufferCuller, BufferLines, 0.0, (Values{ 1.0, 4096.0, 0.0 }),
      (Values{ -1.0, 4097.0, LeastInt, MostInt }), "0 to 4096"),
  };
}

class Settings : public testing::TestWithParam<Setting>
{
};

TEST_P(Settings, TakeValuesInRange)
{
  const vtkSmartPointer<vtkObject> object = GetParam().Make();
  EXPECT_EQ(GetParam().Get(object), GetParam().Default);
  for (const double value : GetParam().Good)
  {
    const bool isNew = value != GetParam().Get(object);
    const vtkMTimeType before = object->GetMTime();
    GetParam().Set(object, value);
    EXPECT_EQ(GetParam().Get(object), value);
    EXPECT_EQ(object->GetMTime() > before, isNew);
    const vtkMTimeType after = object->GetMTime();
    GetParam().Set(object, value);
    EXPECT_EQ(object->GetMTime(), after);
  }
}

TEST_P(Settings, KeepTheirValueWhereTheNewOneIsOutOfRange)
{
  const vtkSmartPointer<vtkObject> object = GetParam().Make();
  for (const double kept : { GetParam().Default, GetParam().Good.front() })
  {
    GetParam().Set(object, kept);
    const vtkMTimeType before = object->GetMTime();
    for (const double value : GetParam().Bad)
    {
      SCOPED_TRACE(value);
      GetParam().Set(object, value);
      EXPECT_EQ(GetParam().Get(object), kept);
      EXPECT_EQ(object->GetMTime(), before);
      const std::vector<std::string> messages = TakeMessages();
      ASSERT_EQ(messages.size(), 1u);
      const std::string expected = std::string(GetParam().Name) + " cannot be " +
        GetParam().Text(value) + ". The range is " + GetParam().Range + ".";
      EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
      EXPECT_NE(messages[0].find(GetParam().Class), std::string::npos) << messages[0];
    }
  }
}

TEST_P(Settings, ArePrinted)
{
  const vtkSmartPointer<vtkObject> object = GetParam().Make();
  std::ostringstream text;
  object->Print(text);
  EXPECT_NE(text.str().find(std::string("  ") + GetParam().Name + ": "), std::string::npos)
    << text.str();
}

INSTANTIATE_TEST_SUITE_P(All, Settings, testing::ValuesIn(AllSettings()),
  [](const auto& info) { return std::string(info.param.Class) + info.param.Name; });

/** A value of an enumeration: its name, and the method that sets it. */
template <class Class>
struct Named
{
  const char* Name;
  void (Class::*SetTo)();
};

template <class Class>
void ExpectNames(Class* object, void (Class::*set)(int), const char* (Class::*name)(),
  const std::vector<Named<Class>>& values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    (object->*set)(static_cast<int>(i));
    EXPECT_STREQ((object->*name)(), values[i].Name);
    (object->*set)(static_cast<int>((i + 1) % values.size()));
    (object->*values[i].SetTo)();
    EXPECT_STREQ((object->*name)(), values[i].Name);
  }
}

TEST(EnumSettings, HaveNames)
{
  vtkNew<vtkLinkedListTransparencyPass> lists;
  using ABuffer = vtkABufferTransparencyPass;
  ExpectNames<ABuffer>(lists, &ABuffer::SetColorStorage, &ABuffer::GetColorStorageAsString,
    { { "half float", &ABuffer::SetColorStorageToHalfFloat },
      { "eight bit", &ABuffer::SetColorStorageToEightBit },
      { "compact", &ABuffer::SetColorStorageToCompact } });
  vtkNew<vtkStencilMaskTransparencyPass> masks;
  using Masks = vtkStencilMaskTransparencyPass;
  ExpectNames<Masks>(masks, &Masks::SetDepthStorage, &Masks::GetDepthStorageAsString,
    { { "full float", &Masks::SetDepthStorageToFullFloat },
      { "half float", &Masks::SetDepthStorageToHalfFloat } });
  vtkNew<vtkStencilRoutedTransparencyPass> routed;
  using Routed = vtkStencilRoutedTransparencyPass;
  ExpectNames<Routed>(routed, &Routed::SetColorStorage, &Routed::GetColorStorageAsString,
    { { "half float", &Routed::SetColorStorageToHalfFloat },
      { "eight bit", &Routed::SetColorStorageToEightBit } });
  vtkNew<vtkClusteredLightsPass> lights;
  using Lights = vtkClusteredLightsPass;
  ExpectNames<Lights>(lights, &Lights::SetGridSpace, &Lights::GetGridSpaceAsString,
    { { "view", &Lights::SetGridSpaceToView }, { "world", &Lights::SetGridSpaceToWorld } });
  ExpectNames<Lights>(lights, &Lights::SetSliceLaw, &Lights::GetSliceLawAsString,
    { { "exponential", &Lights::SetSliceLawToExponential },
      { "uniform", &Lights::SetSliceLawToUniform },
      { "NDC uniform", &Lights::SetSliceLawToNDCUniform } });
  vtkNew<vtkDeferredLightsPass> deferred;
  using Deferred = vtkDeferredLightsPass;
  ExpectNames<Deferred>(deferred, &Deferred::SetAssignment, &Deferred::GetAssignmentAsString,
    { { "light volumes", &Deferred::SetAssignmentToLightVolumes },
      { "tiles", &Deferred::SetAssignmentToTiles },
      { "clusters", &Deferred::SetAssignmentToClusters } });
}

/** Expects that a setting is a bool, has its default, and is switched off and on. */
#define EXPECT_SWITCH(object, Name, isOn)                                                          \
  static_assert(std::is_same_v<decltype((object)->Get##Name()), bool>);                            \
  EXPECT_EQ((object)->Get##Name(), isOn);                                                          \
  (object)->Name##Off();                                                                           \
  EXPECT_FALSE((object)->Get##Name());                                                             \
  (object)->Name##On();                                                                            \
  EXPECT_TRUE((object)->Get##Name())

TEST(OnOffSettings, AreBooleans)
{
  vtkNew<vtkPrefixSumTransparencyPass> lists;
  EXPECT_SWITCH(lists, Prediction, true);
  EXPECT_SWITCH(lists, MeasureStages, false);
  vtkNew<vtkStencilMaskTransparencyPass> masks;
  EXPECT_SWITCH(masks, Filter, true);
  EXPECT_SWITCH(masks, ShowMarks, false);
  vtkNew<vtkHierarchicalSBufferCuller> culler;
  EXPECT_SWITCH(culler, Culling, true);
  vtkNew<vtkPartLevels> levels;
  EXPECT_SWITCH(levels, ExactWhileStill, true);
  EXPECT_SWITCH(levels, UseCache, true);
}

}
