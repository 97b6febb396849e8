// Spans in an s-buffer: putting them in, and asking what they hide.

#include "Core/culling/buffer/SBuffer.h"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace
{

using namespace vitrine;

constexpr int BufferColumns = 480;
constexpr int BufferLines = 270;

struct LineSegment
{
  int Line;
  Segment Covered;
};

// Anywhere on the screen, most of them a few columns long and some half a line.
std::vector<LineSegment> RandomSegments(std::size_t count)
{
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(random() / 4294967296.0); };
  std::vector<LineSegment> segments(count);
  for (LineSegment& segment : segments)
  {
    segment.Line = static_cast<int>(random() % BufferLines);
    const float left = uniform() * BufferColumns - 5.0f;
    const float share = uniform();
    const float length = 0.1f + share * share * share * BufferColumns / 2;
    const float depth = 0.05f + 0.9f * uniform();
    const float rightDepth = depth + 0.05f * uniform();
    segment.Covered = { left, left + length, depth, rightDepth, 0 };
  }
  return segments;
}

void Fill(SBuffer& buffer, const std::vector<LineSegment>& segments)
{
  buffer.Clear();
  for (const LineSegment& segment : segments)
  {
    buffer.Insert(segment.Line, segment.Covered);
  }
}

void InsertSegments(benchmark::State& state)
{
  const auto segments = RandomSegments(static_cast<std::size_t>(state.range(0)));
  SBuffer buffer(BufferColumns, BufferLines);
  for (auto _ : state)
  {
    Fill(buffer, segments);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["comparisons"] = static_cast<double>(buffer.Counts().Comparisons);
}
BENCHMARK(InsertSegments)->Arg(1000)->Arg(100000)->Unit(benchmark::kMicrosecond);

// Of buffers with few spans and with many.
template <class IsHidden>
void AskAtPlaces(benchmark::State& state, const IsHidden& isHidden)
{
  SBuffer buffer(BufferColumns, BufferLines);
  Fill(buffer, RandomSegments(static_cast<std::size_t>(state.range(0))));
  const auto places = RandomSegments(4096);
  std::size_t asked = 0;
  std::size_t hidden = 0;
  for (auto _ : state)
  {
    hidden += isHidden(buffer, places[asked++ % places.size()]);
  }
  state.counters["hidden_share"] = static_cast<double>(hidden) / static_cast<double>(asked);
}

void TestRectangles(benchmark::State& state)
{
  AskAtPlaces(state,
    [](const SBuffer& buffer, const LineSegment& place)
    {
      const float bottom = static_cast<float>(place.Line);
      return buffer.Hides({ place.Covered.Left, place.Covered.Left + 4.0f, bottom, bottom + 4.0f,
        0.5f * place.Covered.LeftDepth });
    });
}
BENCHMARK(TestRectangles)->Arg(1000)->Arg(100000);

void TestSegments(benchmark::State& state)
{
  AskAtPlaces(state,
    [](SBuffer& buffer, const LineSegment& place)
    {
      float shown;
      return buffer.Hides(place.Line, Hideable(place.Covered), shown);
    });
}
BENCHMARK(TestSegments)->Arg(1000)->Arg(100000);

}
