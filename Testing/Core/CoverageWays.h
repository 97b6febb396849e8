/**
 * The ways in which a mesh gets into an s-buffer: by its outline or face by face, with samples anywhere or at centres of pixels.
 */
#ifndef VITRINE_TESTING_COVERAGE_WAYS_H
#define VITRINE_TESTING_COVERAGE_WAYS_H

#include "Core/culling/FaceCoverage.h"
#include "Core/culling/OutlineCoverage.h"

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
  bool IsByFaces;
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

class Inserter
{
public:
  explicit Inserter(const Way& way)
    : IsByFaces(way.IsByFaces)
  {
  }

  void Insert(vitrine::SBuffer& buffer, vitrine::MeshProjection& projection, Facing facing,
    std::uint32_t part)
  {
    if (this->IsByFaces)
    {
      this->Faces.Insert(buffer, projection, facing, part);
    }
    else
    {
      this->Outline.Insert(buffer, projection, facing, part);
    }
  }

private:
  bool IsByFaces;
  vitrine::FaceCoverage Faces;
  vitrine::OutlineCoverage Outline;
};

inline std::string NameOf(const Way& way)
{
  const std::string samples =
    way.PixelsPerLine == 0 ? "Anywhere" : "AtCentres" + std::to_string(way.PixelsPerLine);
  return (way.IsByFaces ? "Faces" : "Outline") + samples;
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

const Way AllWays[] = { { false, 0 }, { false, 1 }, { false, 2 }, { false, 4 }, { false, 8 },
  { true, 0 }, { true, 1 }, { true, 2 }, { true, 4 }, { true, 8 }, { true, 24 } };

/** Tests of every way. */
class EachWay : public ::testing::TestWithParam<Way>
{
};

}

#endif
