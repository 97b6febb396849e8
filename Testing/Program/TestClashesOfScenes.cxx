// Clashes of whole scenes beside brute force. VITRINE_CLASH_INPUTS may name other inputs, VITRINE_CLASH_PAIRS how many
// pairs of each are compared at random, and VITRINE_CLASH_CUT of how many parts around a random one all are.
#include "../Core/BruteClash.h"

#include "Core/measure/AssemblyIndex.h"
#include "commands/Options.h"
#include "scene/Matrices.h"
#include "scene/PartTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

using vitrine::AssemblyIndex;
using vitrine::Clash;
using vitrine::ClashLimits;

std::string Setting(const char* name, const std::string& otherwise)
{
  const char* const value = std::getenv(name);
  return value ? value : otherwise;
}

void AddParts(const program::Scene& scene, AssemblyIndex& index)
{
  std::map<vtkPolyData*, std::shared_ptr<const vitrine::PartMesh>> meshes;
  for (const program::Part& part : scene.Parts)
  {
    auto& mesh = meshes[part.Geometry];
    if (!mesh)
    {
      const vitrine::PartTriangles triangles = vitrine::ReadTriangles(part.Geometry);
      mesh = std::make_shared<vitrine::PartMesh>(triangles.Points, triangles.Corners);
    }
    index.Add(mesh, part.Transform ? vitrine::MatrixOf(part.Transform) : glm::dmat4(1.0));
  }
  index.Build();
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

bool BoxesOverlap(const AssemblyIndex& index, const Pair& pair, double within)
{
  return DistanceBetween(index.At(pair.first).Bounds(), index.At(pair.second).Bounds()) <= within;
}

/** All pairs of the parts that are nearest to one, whose boxes overlap. */
std::vector<Pair> PairsOfCut(
  const AssemblyIndex& index, std::size_t size, double within, std::mt19937& random)
{
  const vitrine::WideBox& centre = index.At(random() % index.Count()).Bounds();
  std::vector<std::pair<double, std::uint32_t>> parts;
  for (std::uint32_t part = 0; part < index.Count(); ++part)
  {
    parts.emplace_back(DistanceBetween(index.At(part).Bounds(), centre), part);
  }
  std::sort(parts.begin(), parts.end());
  parts.resize(std::min(size, parts.size()));
  std::vector<Pair> pairs;
  for (const auto& a : parts)
  {
    for (const auto& b : parts)
    {
      const Pair pair(a.second, b.second);
      if (a.second < b.second && BoxesOverlap(index, pair, within))
      {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

std::vector<Pair> RandomPairs(
  const AssemblyIndex& index, std::size_t size, double within, std::mt19937& random)
{
  std::vector<Pair> pairs;
  for (std::size_t tries = 0; pairs.size() < size && tries < 100000000; ++tries)
  {
    const std::uint32_t a = random() % index.Count();
    const std::uint32_t b = random() % index.Count();
    if (a != b && BoxesOverlap(index, { a, b }, within))
    {
      pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  return pairs;
}

TEST(ClashesOfScenes, AreThoseOfBruteForce)
{
  std::istringstream inputs(Setting("VITRINE_CLASH_INPUTS", "demo:assembly,parts=300"));
  for (std::string input; inputs >> input;)
  {
    SCOPED_TRACE(input);
    AssemblyIndex index;
    AddParts(program::LoadInput(input), index);
    const double tolerance = glm::length(index.Bounds().High - index.Bounds().Low) / 1000;
    const ClashLimits limits{ 2 * tolerance, tolerance };
    std::map<Pair, Clash> found;
    for (const Clash& clash : index.Clashes(limits, [](double) { return true; }))
    {
      found.emplace(Pair(clash.First, clash.Second), clash);
    }
    std::mt19937 random(5);
    std::vector<Pair> pairs =
      PairsOfCut(index, std::stoul(Setting("VITRINE_CLASH_CUT", "10")), limits.Clearance, random);
    const std::vector<Pair> more = RandomPairs(
      index, std::stoul(Setting("VITRINE_CLASH_PAIRS", "12")), limits.Clearance, random);
    pairs.insert(pairs.end(), more.begin(), more.end());
    std::map<std::string, int> counts;
    for (const Pair& pair : pairs)
    {
      const auto truth = brute_clash::Compare(index.At(pair.first), index.At(pair.second), limits);
      const auto at = found.find(pair);
      ASSERT_EQ(at != found.end(), truth.has_value()) << pair.first << " " << pair.second;
      ++counts[!truth ? "none" : std::to_string(static_cast<int>(truth->Kind))];
      if (truth)
      {
        EXPECT_EQ(at->second.Kind, truth->Kind) << pair.first << " " << pair.second;
        EXPECT_NEAR(at->second.Depth, truth->Depth, 1e-6 * tolerance);
        EXPECT_NEAR(at->second.Distance, truth->Distance, 1e-6 * tolerance);
      }
    }
    std::cout << input << ": " << pairs.size() << " pairs;";
    for (const auto& [kind, count] : counts)
    {
      std::cout << " " << kind << ": " << count;
    }
    std::cout << "\n";
    EXPECT_GT(counts["0"], 0);
    EXPECT_GT(counts["1"], 0);
  }
}

}
