/** The results of `clash` for people and for programs. */
#ifndef VITRINE_CLASH_REPORT_H
#define VITRINE_CLASH_REPORT_H

#include <array>
#include <string>
#include <vector>

namespace program
{

/** Two parts that clash, as vtkAssemblyIndex::FindClashes() tells it. */
struct PartClash
{
  std::array<std::string, 2> Parts; ///< their paths
  std::array<std::string, 2> Names; ///< shorter, for people
  std::array<bool, 2> IsClosed;
  std::string Kind; ///< "interfering", "touching" or "near"
  double Depth;     ///< 0 unless interfering
  double Distance;
  std::array<double, 3> Position;
  std::string Inside; ///< the part that lies wholly in the other one, or empty
};

struct ClashTable
{
  std::string Scene;
  std::size_t Parts = 0;
  std::size_t OpenParts = 0;
  double Clearance = 0.0;
  double Tolerance = 0.0;
  std::vector<PartClash> Clashes; ///< in order of what is to be shown
};

/** A line for each pair, interferences first. Pairs that touch are only counted unless they are to be listed. */
std::string ToText(const ClashTable& table, bool listsTouching);
std::string ToJson(const ClashTable& table);

}
#endif
