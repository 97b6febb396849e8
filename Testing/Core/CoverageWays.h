/**
 * Where samples of an s-buffer are that meshes get into: anywhere or at centres of pixels.
 */
#ifndef VITRINE_TESTING_COVERAGE_WAYS_H
#define VITRINE_TESTING_COVERAGE_WAYS_H

#include "Core/culling/cover/FaceCoverage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace coverage
{

using Facing = vitrine::MeshProjection::Facing;

const std::size_t MostTestSpans = 1u << 15; // many more than are used

struct Way
{
  int PixelsPerLine; ///< 0 for samples anywhere

  vitrine::SampleGrid Samples() const
  {
    return this->PixelsPerLine == 0 ? vitrine::SampleGrid()
                                    : vitrine::SampleGrid::AtCentres(this->PixelsPerLine);
  }

  /** From a line's lower side to the lowest samples in it. */
  double Inset() const { return this->PixelsPerLine == 0 ? 0.0 : 0.5 / this->PixelsPerLine; }

  /** Whether all samples of a line lie between. */
  bool IsBetween(int line, double low, double high) const
  {
    return line + this->Inset() > low && line + 1 - this->Inset() < high;
  }
};

inline std::string NameOf(const Way& way)
{
  return way.PixelsPerLine == 0 ? "Anywhere" : "AtCentres" + std::to_string(way.PixelsPerLine);
}

inline std::string NameOfParameter(const ::testing::TestParamInfo<Way>& info)
{
  return NameOf(info.param);
}

/** What GoogleTest prints; else it does the bytes. */
inline void PrintTo(const Way& way, std::ostream* out)
{
  *out << NameOf(way);
}

const Way AllWays[] = { { 0 }, { 1 }, { 2 }, { 4 }, { 8 }, { 24 } };

/** Tests of every way. */
class EachWay : public ::testing::TestWithParam<Way>
{
};

}

#endif
