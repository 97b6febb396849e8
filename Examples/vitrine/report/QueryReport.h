/** The answers of `query` for people and for programs. */
#ifndef VITRINE_QUERY_REPORT_H
#define VITRINE_QUERY_REPORT_H

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace program
{

struct CrossedSurface
{
  std::string Part;
  double Distance;
  std::array<double, 3> Position;
  bool IsEntering;
};

struct CrossedWall
{
  std::string Part;
  double Start;
  double End;
};

struct RayAnswer
{
  std::vector<CrossedSurface> Crossings;
  std::vector<CrossedWall> Walls;
};

struct NearestAnswer
{
  std::string Part;
  std::array<double, 3> Position;
  double Distance;
};

struct DistanceAnswer
{
  std::array<std::string, 2> Parts;
  double Distance;
  std::array<std::array<double, 3>, 2> Positions;
};

struct SightAnswer
{
  std::array<std::string, 2> Parts;
  bool MaySee;
};

/** What was asked for; the rest is empty. */
struct QueryAnswers
{
  std::string Scene;
  std::optional<RayAnswer> Ray;
  std::optional<NearestAnswer> Nearest;
  std::optional<std::vector<std::string>> InBox;
  std::optional<std::vector<std::string>> InSphere;
  std::optional<DistanceAnswer> Distance;
  std::optional<SightAnswer> Sight;
};

std::string ToText(const QueryAnswers& answers);
std::string ToJson(const QueryAnswers& answers);

}
#endif
