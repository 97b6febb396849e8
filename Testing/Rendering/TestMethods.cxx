#include "TestMethods.h"

#include "TestMessages.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkImageData.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkStencilMaskTransparencyPass.h"
#include "vtkStencilRoutedTransparencyPass.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

std::ostream& operator<<(std::ostream& os, const Method& method)
{
  return os << method.Name;
}

const std::vector<Method>& ExactMethods()
{
  // An 8-bit target rounds once, which is half a step. Storage of half floats adds less than a quarter, that of compact
  // nodes little more than half, storage of 8 bits up to half a step for each layer that shows, mostly in alpha.
  static const std::vector<Method> methods = {
    { "LinkedListHalfFloat", [] { return vtkSmartPointer<vtkLinkedListTransparencyPass>::New(); },
      0.75 },
    { "LinkedListEightBit",
      []
      {
        auto pass = vtkSmartPointer<vtkLinkedListTransparencyPass>::New();
        pass->SetColorStorageToEightBit();
        return pass;
      },
      1.4 },
    { "PrefixSumPredicted", [] { return vtkSmartPointer<vtkPrefixSumTransparencyPass>::New(); },
      0.75 },
    { "PrefixSumCountedCompact",
      []
      {
        auto pass = vtkSmartPointer<vtkPrefixSumTransparencyPass>::New();
        pass->PredictionOff();
        pass->SetColorStorageToCompact();
        return pass;
      },
      1.1 },
  };
  return methods;
}

const std::vector<Method>& MaskMethods()
{
  // Colours are kept in 8 bits, as LinkedListEightBit does.
  static const std::vector<Method> methods = {
    { "StencilMask9",
      []
      {
        auto pass = vtkSmartPointer<vtkStencilMaskTransparencyPass>::New();
        pass->SetNumberOfLayers(9);
        return pass;
      },
      1.4, 9, 0.2, "take one sample", "3.2" },
  };
  return methods;
}

const std::vector<Method>& RoutedMethods()
{
  // IEEE half floats have a bit less than what the lists keep.
  static const std::vector<Method> methods = {
    { "StencilRoutedHalfFloat",
      [] { return vtkSmartPointer<vtkStencilRoutedTransparencyPass>::New(); }, 0.75, 224, 0.0,
      "takes one sample", "3.2" },
  };
  return methods;
}

const std::vector<Method>& AllMethods()
{
  static const std::vector<Method> methods = []
  {
    std::vector<Method> all = ExactMethods();
    all.insert(all.end(), RoutedMethods().begin(), RoutedMethods().end());
    all.insert(all.end(), MaskMethods().begin(), MaskMethods().end());
    all.push_back(
      { "Truth", [] { return vtkSmartPointer<vtkTruthTransparencyPass>::New(); }, 0.51 });
    return all;
  }();
  return methods;
}

std::vector<Method> MethodsThat(bool (*is)(const Method& method))
{
  std::vector<Method> methods;
  std::copy_if(AllMethods().begin(), AllMethods().end(), std::back_inserter(methods), is);
  return methods;
}

const std::vector<Method>& ABufferMethods()
{
  static const std::vector<Method> methods = MethodsThat([](const Method& method)
    { return vtkABufferTransparencyPass::SafeDownCast(method.Make()) != nullptr; });
  return methods;
}

vtkSmartPointer<vtkABufferTransparencyPass> MakeABuffer(const Method& method)
{
  return vtkABufferTransparencyPass::SafeDownCast(method.Make());
}

vtkSmartPointer<vtkSeeThroughPass> MakeSeeThrough(const Method& method)
{
  auto seeThrough = vtkSmartPointer<vtkSeeThroughPass>::New();
  const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
  seeThrough->SetTranslucentPass(pass);
  return seeThrough;
}

const std::vector<Method>& MultisamplingMethods()
{
  static const std::vector<Method> methods =
    MethodsThat([](const Method& method) { return method.RefusesSamples.empty(); });
  return methods;
}

const std::vector<Method>& SingleSampleMethods()
{
  static const std::vector<Method> methods =
    MethodsThat([](const Method& method) { return !method.RefusesSamples.empty(); });
  return methods;
}

double DistanceFromTruth(const Picture& picture, vtkImageData* truth, double besides)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const int* size = truth->GetDimensions();
  if (size[0] != picture.Width || size[1] != picture.Height)
  {
    return infinite;
  }
  const auto* value = static_cast<const float*>(truth->GetScalarPointer());
  std::vector<double> distances;
  for (const unsigned char byte : picture.Bytes)
  {
    const double distance = std::abs(byte - 255.0 * std::min(*value++, 1.0f));
    distances.push_back(distance >= 0.0 ? distance : infinite); // NaN is neither
  }
  std::sort(distances.rbegin(), distances.rend());
  return distances[static_cast<std::size_t>(besides * static_cast<double>(distances.size()))];
}

Picture ExpectTruth(TestScene& scene, vtkTransparencyPass* pass, double tolerance, double besides)
{
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  EXPECT_STREQ(truth->GetFallbackReason(), "");
  EXPECT_GT(truth->GetNumberOfFragments(), 0);

  scene.Use(pass);
  const Picture picture = scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  const double slack = besides > 0.0 ? 0.05 : 0.0;
  const auto fragments = static_cast<double>(truth->GetNumberOfFragments());
  EXPECT_NEAR(static_cast<double>(pass->GetNumberOfFragments()), fragments, slack * fragments);
  EXPECT_EQ(pass->GetMaximumNumberOfLayers(), truth->GetMaximumNumberOfLayers());
  EXPECT_NEAR(pass->GetMeanNumberOfLayers(), truth->GetMeanNumberOfLayers(),
    slack * truth->GetMeanNumberOfLayers());
  EXPECT_LE(DistanceFromTruth(picture, truth->GetResult(), besides), tolerance);
  return picture;
}

void ExpectAllAreTruth(TestScene& scene, double slack)
{
  for (const Method& method : ExactMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), slack * method.Tolerance);
  }
  for (const Method& method : RoutedMethods())
  {
    SCOPED_TRACE(method.Name);
    ExpectTruth(scene, method.Make(), slack * method.Tolerance);
  }
}

void ExpectRefusal(vtkTransparencyPass* pass, const std::string& text)
{
  const std::string reason = pass->GetFallbackReason();
  EXPECT_NE(reason.find(text), std::string::npos) << reason;
  const std::vector<std::string> messages = TakeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}
