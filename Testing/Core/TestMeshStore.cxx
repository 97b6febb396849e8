// Meshes beyond a budget of memory are in a file: the same answers, nothing left behind, and errors that tell why.
#include "MeasuredShapes.h"

#include "Core/measure/AssemblyIndex.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#ifndef _WIN32 // what limits files, and removes those that are open
#include <sys/resource.h>
#endif

namespace mesh_store_tests
{

using namespace measured_shapes;
using vitrine::AssemblyIndex;
using vitrine::Clash;
using vitrine::MeshStore;

const vitrine::ClashLimits Limits{ 0.2, 0.02 };

/** Parts that overlap, of shapes that they share and, with uneven places, of their own. */
void Fill(AssemblyIndex& index)
{
  std::mt19937 random(51);
  const std::uint32_t shapes[] = { index.AddMesh(Ball(1, 16)), index.AddMesh(Torus(1, 0.4, 16)),
    index.AddMesh(Sheet(2, 1, 9)), index.AddMesh(Ball(0.3, 9)) };
  for (int i = 0; i < 40; ++i)
  {
    glm::dmat4 place = RandomPlace(random, 3, 0.5, 1.5);
    place = i % 9 == 0 ? glm::scale(place, glm::dvec3(1, 2, 1)) : place;
    index.Add(shapes[i % 4], place);
  }
  index.Build();
}

/** All numbers of an index's answers, which have to be the same to the last bit. */
std::vector<double> Answers(const AssemblyIndex& index)
{
  std::vector<double> numbers;
  for (const Clash& clash : index.Clashes(Limits, [](double) { return true; }))
  {
    numbers.insert(numbers.end(),
      { double(clash.First), double(clash.Second), double(int(clash.Kind)),
        double(int(clash.Enclosure)), clash.Depth, clash.Distance, clash.Place.x });
  }
  std::mt19937 random(52);
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 point = Point(random, -4, 4);
    const auto near = index.Nearest(point);
    numbers.insert(numbers.end(), { double(near->Part), near->Point.Distance });
    for (const auto& crossing : index.Crossings({ point, glm::normalize(Point(random, -1, 1)) }))
    {
      numbers.insert(numbers.end(), { double(crossing.Part), crossing.Distance });
    }
    for (const std::uint32_t part : index.PartsWithin(point, 3))
    {
      numbers.push_back(part);
    }
  }
  return numbers;
}

TEST(MeshStore, GivesTheSameAnswersWithAnyBudget)
{
  AssemblyIndex whole;
  Fill(whole);
  const std::vector<double> answers = Answers(whole);
  EXPECT_GT(answers.size(), 500u);
  EXPECT_EQ(whole.Store().ReadCount(), 0u);
  const std::size_t all = whole.Store().ResidentBytes();
  for (const std::size_t budget : { std::size_t(0), all / 4, all })
  {
    SCOPED_TRACE(budget);
    AssemblyIndex index;
    index.SetMemoryBudget(budget);
    Fill(index);
    EXPECT_EQ(Answers(index), answers);
    EXPECT_LE(index.Store().ResidentBytes(), budget);
    EXPECT_EQ(index.Store().ReadCount() > 0, budget < all);
  }
  whole.SetMemoryBudget(all / 4); // once parts are there
  EXPECT_LE(whole.Store().ResidentBytes(), all / 4);
  EXPECT_EQ(Answers(whole), answers);
  EXPECT_GT(whole.Store().ReadCount(), 0u);
}

TEST(MeshStore, CountsWhatMeshesTake)
{
  const Mesh ball = Ball(1, 64);
  const std::size_t counted = MeshStore::BytesOf(*ball);
  const std::size_t taken = ball->Points().size() * (24 + 4) + ball->TriangleCount() * 16 +
    ball->Tree().Bytes() + sizeof(vitrine::PartMesh);
  EXPECT_GT(counted, taken * 0.6);
  EXPECT_LT(counted, taken * 1.6);
}

TEST(MeshStore, KeepsAMeshThatIsHeld)
{
  AssemblyIndex index;
  index.SetMemoryBudget(0);
  Fill(index);
  const vitrine::PlacedPart held = index.At(0);
  const glm::dvec3 before = held.Mesh().Points()[5];
  Answers(index);
  EXPECT_EQ(held.Mesh().Points()[5], before);
}

#ifndef _WIN32
/** The folder for temporary files, for as long as this is there. */
class TemporaryFolder
{
public:
  explicit TemporaryFolder(const std::string& path)
  {
    const char* const before = std::getenv("TMPDIR");
    this->Before = before ? before : "";
    setenv("TMPDIR", path.c_str(), 1);
  }
  ~TemporaryFolder()
  {
    this->Before.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", this->Before.c_str(), 1);
  }

private:
  std::string Before;
};

TEST(MeshStore, LeavesNoFile)
{
  const auto folder = std::filesystem::path(testing::TempDir()) /
    ("mesh-store-" + std::to_string(std::random_device()()));
  std::filesystem::create_directory(folder);
  {
    const TemporaryFolder here(folder.string());
    AssemblyIndex index;
    index.SetMemoryBudget(0);
    Fill(index);
    EXPECT_TRUE(std::filesystem::is_empty(folder)); // it has no name already
  }
  std::filesystem::remove_all(folder);
}

TEST(MeshStore, TellsWhereNoFileCanBe)
{
  AssemblyIndex index;
  Fill(index);
  const std::vector<double> answers = Answers(index);
  const TemporaryFolder nowhere("/there/is/no/such/folder");
  EXPECT_THROW(index.SetMemoryBudget(0), std::runtime_error);
  EXPECT_EQ(Answers(index), answers);
}

/** A limit of the size of files stands for a full disk. */
class SmallDisk
{
public:
  explicit SmallDisk(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->Before);
    const rlimit small{ bytes, this->Before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->Before);
    std::signal(SIGXFSZ, SIG_DFL);
  }

private:
  rlimit Before{};
};

TEST(MeshStore, TellsOfAFullDisk)
{
  AssemblyIndex index;
  index.SetMemoryBudget(0);
  std::string told;
  {
    const SmallDisk small(40000); // room for the first ball and not for the second
    index.Add(Ball(1, 24), glm::dmat4(1.0));
    try
    {
      index.Add(Ball(1, 24), At({ 1, 0, 0 }));
    }
    catch (const std::runtime_error& error)
    {
      told = error.what();
    }
  }
  EXPECT_NE(told.find("cannot be written to a temporary file"), std::string::npos) << told;
  EXPECT_EQ(index.Count(), 1u);
  index.Add(Ball(1, 24), At({ 1, 0, 0 })); // there is room again
  EXPECT_EQ(index.Clashes(Limits, [](double) { return true; }).size(), 1u);
}
#endif

}
