#include "transparency/ranks/FrameFacts.h"

#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <cstddef>
#include <initializer_list>

namespace vitrine
{
namespace
{

std::string SizeText(const FrameFacts& facts)
{
  return std::to_string(facts.Width) + " x " + std::to_string(facts.Height) + " pixels";
}

// A number that depends on all numbers that were added (FNV-1a).
struct Fingerprint
{
  std::uint64_t Value = 14695981039346656037u;

  void Add(const double* numbers, std::size_t count)
  {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(numbers);
    for (std::size_t i = 0; i < count * sizeof(double); ++i)
    {
      this->Value = (this->Value ^ bytes[i]) * 1099511628211u;
    }
  }
  void Add(std::initializer_list<double> numbers) { this->Add(numbers.begin(), numbers.size()); }
};

// Returns what is different about `facts`, and of `first`, those of rank 0.
std::string Compare(const FrameFacts& facts, const FrameFacts& first)
{
  if (facts.Width != first.Width || facts.Height != first.Height)
  {
    return "draws " + SizeText(facts) + " and rank 0 " + SizeText(first) +
      "; give all windows one size";
  }
  if (!(facts.Region == first.Region))
  {
    return "draws another part of the window than rank 0; give all renderers one viewport";
  }
  if (facts.Samples != first.Samples)
  {
    return "draws " + std::to_string(facts.Samples) + " samples a pixel and rank 0 " +
      std::to_string(first.Samples) + "; call SetMultiSamples() alike";
  }
  if (facts.ColorFormat != first.ColorFormat || facts.DepthFormat != first.DepthFormat)
  {
    return "has another format of pixels than rank 0; make all windows alike";
  }
  if (facts.ColorStorage != first.ColorStorage || facts.PictureRank != first.PictureRank ||
    facts.ToleranceSteps != first.ToleranceSteps || facts.ToleranceSlope != first.ToleranceSlope)
  {
    return "has another color storage, coincidence tolerance or picture rank than rank 0; give all "
           "passes one "
           "setting";
  }
  if (facts.Matrices != first.Matrices)
  {
    return "has another camera than rank 0; call SynchronizeCamera() on all ranks before they "
           "render, and give their cameras the same transforms";
  }
  if (facts.Look != first.Look)
  {
    return "has other lights or another background than rank 0; give all renderers the same";
  }
  return {};
}

}

std::uint64_t LookOf(vtkRenderer* renderer)
{
  Fingerprint look;
  look.Add(renderer->GetBackground(), 3);
  look.Add(renderer->GetBackground2(), 3);
  look.Add({ double(renderer->GetGradientBackground()), double(renderer->GetTexturedBackground()),
    renderer->GetBackgroundAlpha() });
  vtkCollectionSimpleIterator at;
  vtkLightCollection* const lights = renderer->GetLights();
  for (lights->InitTraversal(at); vtkLight* const light = lights->GetNextLight(at);)
  {
    look.Add(light->GetPosition(), 3);
    look.Add(light->GetFocalPoint(), 3);
    look.Add(light->GetAmbientColor(), 3);
    look.Add(light->GetDiffuseColor(), 3);
    look.Add(light->GetSpecularColor(), 3);
    look.Add(light->GetAttenuationValues(), 3);
    look.Add(
      { double(light->GetSwitch()), double(light->GetLightType()), double(light->GetPositional()),
        light->GetIntensity(), light->GetConeAngle(), light->GetExponent() });
  }
  return look.Value;
}

std::string FindDifference(const std::vector<Message>& factsOfRanks)
{
  std::vector<FrameFacts> facts(factsOfRanks.size());
  for (std::size_t rank = 0; rank < facts.size(); ++rank)
  {
    if (!TakeValue(factsOfRanks[rank], facts[rank]))
    {
      return "rank " + std::to_string(rank) + " has another version of this library than others";
    }
    const std::string difference = Compare(facts[rank], facts[0]);
    if (!difference.empty())
    {
      return "rank " + std::to_string(rank) + " " + difference;
    }
  }
  return {};
}

}
