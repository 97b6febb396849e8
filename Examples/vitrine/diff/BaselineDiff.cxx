#include "diff/BaselineDiff.h"

#include "Errors.h"
#include "OutputFile.h"
#include "OutputPicture.h"
#include "report/HeatMap.h"
#include "scene/files/FileBytes.h"
#include "study/image/Flip.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace program
{

namespace
{
const int Channels = 4;

vitrine::PictureView ViewOf(const vitrine::PngPicture& picture)
{
  return { picture.Width, picture.Height, Channels, picture.Pixels.data() };
}

/** The colours alone, as FLIP and the other measures take them. */
vitrine::Image ColorsOf(const vitrine::PngPicture& picture)
{
  vitrine::Image image{ picture.Width, picture.Height, {} };
  for (std::size_t i = 0; i < picture.Pixels.size(); ++i)
  {
    if (i % Channels < 3)
    {
      image.Rgb.push_back(static_cast<float>(picture.Pixels[i]) / 255.0f);
    }
  }
  return image;
}

std::string SizeOf(const vitrine::PngPicture& picture)
{
  return std::to_string(picture.Width) + "x" + std::to_string(picture.Height);
}

BaselineDiff Compare(
  const vitrine::PngPicture& picture, const std::string& file, const DiffTolerance& tolerance)
{
  BaselineDiff diff;
  diff.File = file;
  const vitrine::PngPicture baseline = ReadPng(file);
  if (baseline.Width != picture.Width || baseline.Height != picture.Height)
  {
    diff.Problem =
      "the baseline has " + SizeOf(baseline) + " pixels, and the picture " + SizeOf(picture);
    return diff;
  }
  diff.Difference = vitrine::FindDifference(ViewOf(picture), ViewOf(baseline), tolerance.Steps);
  diff.Error = vitrine::CompareImages(ColorsOf(picture), ColorsOf(baseline));
  diff.Allowed = diff.Difference.PixelsOfShare(tolerance.Share);
  diff.IsMatch = diff.Difference.DifferentPixels <= diff.Allowed &&
    (!tolerance.Flip || diff.Error.Flip <= *tolerance.Flip);
  return diff;
}

/** Less is closer. */
auto Distance(const BaselineDiff& diff)
{
  return std::make_tuple(
    !diff.IsMatch, !diff.Problem.empty(), diff.Difference.DifferentPixels, diff.Difference.Largest);
}

bool IsThere(const std::string& path)
{
  std::error_code error;
  return std::filesystem::exists(path, error);
}
}

bool IsAnyThere(const std::vector<std::string>& files)
{
  return std::any_of(files.begin(), files.end(), IsThere);
}

vitrine::PngPicture ReadPng(const std::string& path)
{
  CheckReadable(path);
  vitrine::PngPicture picture = vitrine::DecodePng(ReadBytes(path), vitrine::PngChannels::Rgba);
  if (picture.Pixels.empty())
  {
    throw InputError(path, "is no whole PNG of at most 16384 pixels a side");
  }
  return picture;
}

PictureDiff CompareWithBaselines(const std::string& file, const std::vector<std::string>& baselines,
  const DiffTolerance& tolerance)
{
  if (!IsAnyThere(baselines))
  {
    throw InputError(baselines.front(), "no such file; with --update it is made");
  }
  const vitrine::PngPicture picture = ReadPng(file);
  PictureDiff diff{ file, tolerance, {}, 0 };
  for (const std::string& baseline : baselines)
  {
    diff.Baselines.push_back(IsThere(baseline) ? Compare(picture, baseline, tolerance)
                                               : BaselineDiff{ baseline, "no such file", {}, {} });
  }
  const auto closest = std::min_element(diff.Baselines.begin(), diff.Baselines.end(),
    [](const BaselineDiff& a, const BaselineDiff& b) { return Distance(a) < Distance(b); });
  diff.Closest = static_cast<std::size_t>(closest - diff.Baselines.begin());
  return diff;
}

void WriteDiffPictures(
  const std::string& folder, const PictureDiff& diff, const BaselineDiff& baseline)
{
  const vitrine::PngPicture picture = ReadPng(diff.File), reference = ReadPng(baseline.File);
  const PictureSize size{ picture.Width, picture.Height };
  MakeFolder(folder);
  WritePicture(folder + "/difference.png",
    vitrine::DrawDifference(ViewOf(picture), ViewOf(reference), diff.Tolerance.Steps), size);
  WritePicture(folder + "/flip.png",
    HeatMapOfShares(vitrine::FlipErrorMap(ColorsOf(picture), ColorsOf(reference)).Values), size);
}

}
