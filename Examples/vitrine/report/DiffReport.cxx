#include "report/DiffReport.h"

#include "Version.h"
#include "report/Json.h"
#include "report/TextTable.h"

namespace program
{

namespace
{
const char* const Picture = "picture";

/** How far a baseline is, and how far it may be; a line for each measure. */
std::string DescribeMeasures(const BaselineDiff& baseline, const DiffTolerance& tolerance)
{
  if (!baseline.Problem.empty())
  {
    return baseline.Problem;
  }
  std::string text = vitrine::DescribeDifference(baseline.Difference, Picture, "baseline");
  if (tolerance.Share > 0.0)
  {
    text += "\n  pixels that may differ: " + std::to_string(baseline.Allowed);
  }
  text += "\n  FLIP " + FormatCell("%.6f", baseline.Error.Flip);
  return tolerance.Flip ? text + ", and may be " + FormatCell("%g", *tolerance.Flip) : text;
}

std::string DescribeMatch(const PictureDiff& diff)
{
  const BaselineDiff& baseline = diff.Baselines[diff.Closest];
  return diff.File + " matches " + baseline.File + ": the largest difference is " +
    std::to_string(baseline.Difference.Largest) + "/255, and " +
    std::to_string(baseline.Difference.DifferentPixels) + " pixels differ by more than " +
    std::to_string(diff.Tolerance.Steps) + "/255\n";
}

Json PixelJson(const vitrine::DifferentPixel& pixel)
{
  return { { "x", pixel.X }, { "y", pixel.Y }, { Picture, pixel.Test },
    { "baseline", pixel.Reference } };
}

Json BaselineJson(const BaselineDiff& baseline)
{
  if (!baseline.Problem.empty())
  {
    return { { "file", baseline.File }, { "matches", false }, { "problem", baseline.Problem } };
  }
  const vitrine::PictureDifference& difference = baseline.Difference;
  Json first = Json::array();
  for (const vitrine::DifferentPixel& pixel : difference.First)
  {
    first.push_back(PixelJson(pixel));
  }
  return { { "file", baseline.File }, { "matches", baseline.IsMatch },
    { "largest_difference", difference.Largest },
    { "different_pixels", difference.DifferentPixels }, { "pixels", difference.Pixels },
    { "first", first }, { "error", ErrorJson(baseline.Error) } };
}
}

std::string ToText(const PictureDiff& diff)
{
  if (diff.IsMatch())
  {
    return DescribeMatch(diff);
  }
  const BaselineDiff& closest = diff.Baselines[diff.Closest];
  std::string text =
    diff.File + " and " + closest.File + ": " + DescribeMeasures(closest, diff.Tolerance) + "\n";
  for (std::size_t i = 0; i < diff.Baselines.size(); ++i)
  {
    if (i != diff.Closest)
    {
      const BaselineDiff& other = diff.Baselines[i];
      text += other.File + " is not closer: " +
        (other.Problem.empty() ? std::to_string(other.Difference.DifferentPixels) + " pixels differ"
                               : other.Problem) +
        "\n";
    }
  }
  return text;
}

std::string ToJson(const PictureDiff& diff)
{
  Json baselines = Json::array();
  for (const BaselineDiff& baseline : diff.Baselines)
  {
    baselines.push_back(BaselineJson(baseline));
  }
  return JsonText({ { "vitrine", Version }, { Picture, diff.File },
    { "settings",
      { { "tolerance", diff.Tolerance.Steps }, { "share", diff.Tolerance.Share },
        { "flip", OrNull(diff.Tolerance.Flip) } } },
    { "matches", diff.IsMatch() }, { "closest", diff.Baselines[diff.Closest].File },
    { "baselines", baselines } });
}

}
