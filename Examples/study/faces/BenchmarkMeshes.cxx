#include "study/faces/BenchmarkMeshes.h"

#include <cmath>
#include <random>

namespace
{

float Uniform(std::mt19937& random, float low, float high)
{
  return low + (high - low) * static_cast<float>(random() / 4294967296.0);
}

void AddSphere(BenchmarkMesh& mesh, const glm::vec3& centre, std::uint32_t steps)
{
  constexpr float pi = 3.14159265f;
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.Points.size() / 3);
  for (std::uint32_t i = 0; i <= steps; ++i)
  {
    for (std::uint32_t j = 0; j <= steps; ++j)
    {
      const float polar = pi * i / steps;
      const float around = 2 * pi * j / steps;
      mesh.Points.insert(mesh.Points.end(),
        { centre.x + std::sin(polar) * std::cos(around),
          centre.y + std::sin(polar) * std::sin(around), centre.z + std::cos(polar) });
    }
  }
  for (std::uint32_t i = 0; i < steps; ++i)
  {
    for (std::uint32_t j = 0; j < steps; ++j)
    {
      const std::uint32_t a = first + i * (steps + 1) + j;
      const std::uint32_t b = a + steps + 1;
      mesh.Corners.insert(mesh.Corners.end(), { a, a + 1, b, a + 1, b + 1, b });
    }
  }
}

void AddSoup(BenchmarkMesh& mesh, std::uint32_t count, std::mt19937& random)
{
  const float size = 0.5f / std::cbrt(static_cast<float>(count));
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const float x = Uniform(random, 0, 1);
    const float y = Uniform(random, 0, 1);
    const float z = Uniform(random, 0, 1);
    for (std::uint32_t corner = 0; corner < 3; ++corner)
    {
      mesh.Corners.push_back(3 * i + corner);
      for (const float place : { x, y, z })
      {
        mesh.Points.push_back(place + Uniform(random, 0, size));
      }
    }
  }
}

void Shuffle(BenchmarkMesh& mesh, std::mt19937& random)
{
  for (std::uint32_t i = static_cast<std::uint32_t>(mesh.Corners.size() / 3) - 1; i > 0; --i)
  {
    const std::uint32_t j = random() % (i + 1);
    for (int corner = 0; corner < 3; ++corner)
    {
      std::swap(mesh.Corners[3 * i + corner], mesh.Corners[3 * j + corner]);
    }
  }
}

}

BenchmarkMesh::BenchmarkMesh(Kinds kind, std::uint32_t triangleCount)
{
  std::mt19937 random(1);
  if (kind == Kinds::Soup)
  {
    AddSoup(*this, triangleCount, random);
    return;
  }
  constexpr std::uint32_t spheres = 16;
  const std::uint32_t steps =
    static_cast<std::uint32_t>(std::sqrt(triangleCount / (2.0 * spheres)));
  for (std::uint32_t i = 0; i < spheres; ++i)
  {
    const float x = Uniform(random, 0, 4);
    const float y = Uniform(random, 0, 4);
    AddSphere(*this, { x, y, Uniform(random, 0, 4) }, steps);
  }
  if (kind == Kinds::Shuffled)
  {
    Shuffle(*this, random);
  }
}
