#include "faces/FaceOrders.h"

#include "study/faces/FaceNeighbours.h"
#include "study/faces/FaceOrder.h"
#include "study/faces/FaceScan.h"
#include "study/faces/ScreenFaces.h"

#include <chrono>
#include <optional>

namespace program
{

namespace
{

using vitrine::FaceOrder;
using vitrine::FaceOrderStatements;
using vitrine::SBuffer;
using vitrine::ScreenFaces;

const std::size_t MostSpans = std::size_t{ 1 } << 22; // so that none is refused

/** A way to insert faces. */
struct Way
{
  const char* Name;
  std::optional<FaceOrderStatements> Statements; ///< none: no order is asked for

  bool NeedsNeighbours() const { return this->Statements && this->Statements->Neighbours; }
};

const std::vector<Way>& AllWays()
{
  static const std::vector<Way> ways = {
    { "compared", std::nullopt },
    { "none", FaceOrderStatements{ false, false, false } },
    { "1", FaceOrderStatements{ true, false, false } },
    { "2", FaceOrderStatements{ false, true, false } },
    { "3", FaceOrderStatements{ false, false, true } },
    { "all", FaceOrderStatements{} },
  };
  return ways;
}

void FindNeighbours(ScreenFaces& faces)
{
#ifdef VITRINE_HAS_MESH_TOPOLOGY
  faces.Neighbours = vitrine::FindFaceNeighbours(faces.Points.size(), faces.Corners, faces.Ends());
#else
  static_cast<void>(faces);
#endif
}

/** One round. */
void Insert(SBuffer& buffer, const ScreenFaces& faces, const Way& way, FaceOrderResult& result)
{
  FaceOrder order(way.Statements.value_or(FaceOrderStatements()));
  buffer.Clear();
  const auto begin = std::chrono::steady_clock::now();
  for (const std::uint32_t face : faces.Sequence)
  {
    if (way.Statements)
    {
      InsertFace(buffer, faces.Face(face), order);
    }
    else
    {
      InsertFace(buffer, faces.Face(face));
    }
  }
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  result.Milliseconds.push_back(passed.count());
  result.Comparisons = buffer.Counts().Comparisons;
  result.Lookups = order.Counts().Lookups;
  result.EndChecks = order.Counts().EndChecks;
}

FaceOrderRun Measure(const std::string& name, const std::string& sequence, const ScreenFaces& faces,
  const PictureSize& size, int rounds)
{
  FaceOrderRun run{ name, sequence, faces.Sequence.size(), {} };
  for (const Way& way : AllWays())
  {
    const bool isSkipped = way.NeedsNeighbours() && faces.Neighbours.empty();
    run.Results.push_back({ way.Name, isSkipped ? "built without OpenMesh" : "", {} });
  }
  SBuffer buffer(size.Width, size.Height, {}, MostSpans);
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < run.Results.size(); ++i)
    {
      if (run.Results[i].Skipped.empty())
      {
        Insert(buffer, faces, AllWays()[i], run.Results[i]);
      }
    }
  }
  return run;
}

void AddRuns(
  FaceOrderComparison& comparison, const std::string& name, ScreenFaces faces, int rounds)
{
  const PictureSize& size = comparison.Size;
  faces.Project(size.Width, size.Height);
  FindNeighbours(faces);
  comparison.Runs.push_back(Measure(name, "as-stored", faces, size, rounds));
  faces.SortFrontToBack();
  comparison.Runs.push_back(Measure(name, "front-to-back", faces, size, rounds));
}

}

FaceOrderComparison MeasureFaceOrders(const PictureSize& size, int rounds)
{
  FaceOrderComparison comparison{ size, {} };
  AddRuns(comparison, "boxes", vitrine::TurnedBoxes(), rounds);
  AddRuns(comparison, "spheres", vitrine::CrossingSpheres(), rounds);
  return comparison;
}

double SavedShare(const FaceOrderRun& run, const FaceOrderResult& result)
{
  const double all = static_cast<double>(run.Results.front().Comparisons);
  return all > 0.0 ? 1.0 - static_cast<double>(result.Comparisons) / all : 0.0;
}

}
