#include "TestGroups.h"

#include "Core/lists/CoincidentGroup.h"
#include "vtkTolerantTransparencyPass.h"

#include <algorithm>

void SetTolerance(vtkTransparencyPass* pass, double steps, double slope)
{
  if (auto* tolerant = vtkTolerantTransparencyPass::SafeDownCast(pass))
  {
    tolerant->SetCoincidenceSteps(steps);
    tolerant->SetCoincidenceSlope(slope);
  }
}

vtkSmartPointer<vtkTransparencyPass> MakeTolerant(const Method& method, double steps, double slope)
{
  vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
  SetTolerance(pass, steps, slope);
  return pass;
}

std::vector<Method> TolerantMethods()
{
  return MethodsThat([](const Method& method)
    { return vtkTolerantTransparencyPass::SafeDownCast(method.Make()) != nullptr; });
}

Groups RandomGroups(int layers, const std::vector<int>& sizes, double alpha, std::uint64_t seed)
{
  Groups groups;
  groups.Plates = RandomPlates(layers, alpha, seed);
  while (static_cast<int>(groups.Heights.size()) < layers)
  {
    const int number = static_cast<int>(groups.Sizes.size());
    const int left = layers - static_cast<int>(groups.Heights.size());
    groups.Sizes.push_back(std::min(sizes[number % sizes.size()], left));
    groups.Heights.insert(groups.Heights.end(), groups.Sizes.back(), -number);
  }
  for (double& height : groups.Heights)
  {
    height = 0.9 + 1.8 * height / static_cast<double>(groups.Sizes.size());
  }
  return groups;
}

std::vector<double> Noisy(const std::vector<double>& heights, std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<double> noisy = heights;
  for (double& height : noisy)
  {
    height += Noise * random.Unit();
  }
  return noisy;
}

Rgba ClosedForm(const Groups& groups)
{
  std::vector<Rgba> layers;
  std::size_t at = 0;
  for (const int size : groups.Sizes)
  {
    vitrine::CoincidentGroup group;
    for (const std::size_t end = at + size; at < end; ++at)
    {
      group.Add(groups.Plates[at][3], groups.Plates[at].data());
    }
    Rgba mean = { 0.0, 0.0, 0.0, 1.0 - group.Transmittance() };
    group.AddColor(1.0 / std::max(mean[3], 1e-30), mean.data());
    layers.push_back(mean);
  }
  return CompositePlates(layers, TestBackground);
}
