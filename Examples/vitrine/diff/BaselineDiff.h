/**
 * A picture beside the baselines of which it should match one.
 */
#ifndef VITRINE_BASELINE_DIFF_H
#define VITRINE_BASELINE_DIFF_H

#include "assembly/PngDecoder.h"
#include "study/image/ImageError.h"
#include "study/image/PictureDifference.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace program
{

/** How far a picture may be from a baseline, and still matches it. */
struct DiffTolerance
{
  int Steps = 0;              ///< largest difference of any channel, in 1/255
  double Share = 0.0;         ///< of the pixels, which may differ by more
  std::optional<double> Flip; ///< the largest mean of FLIP, which is not asked for without
};

/** What was found of one baseline. */
struct BaselineDiff
{
  std::string File;
  std::string
    Problem; ///< why it could not be compared; empty if it could, and void is the rest if not
  vitrine::PictureDifference Difference;
  vitrine::ImageError Error;
  std::size_t Allowed = 0; ///< pixels that may differ by more than the tolerance
  bool IsMatch = false;
};

/** A picture and all of its baselines. */
struct PictureDiff
{
  std::string File;
  DiffTolerance Tolerance;
  std::vector<BaselineDiff> Baselines;
  std::size_t Closest =
    0; ///< the first one that matches, or else the one with the fewest different pixels

  bool IsMatch() const { return this->Baselines[this->Closest].IsMatch; }
};

/** Whether one of the files exists. */
bool IsAnyThere(const std::vector<std::string>& files);

/** Read a PNG with its alpha. Throws InputError if there is none, or it is no whole PNG. */
vitrine::PngPicture ReadPng(const std::string& path);

/**
 * Compare a PNG with others, one at least. One of another size, or that is not there, matches nothing.
 *
 * Throws InputError if the picture or a baseline cannot be read, or if no baseline is there.
 */
PictureDiff CompareWithBaselines(const std::string& file, const std::vector<std::string>& baselines,
  const DiffTolerance& tolerance);

/** Write difference.png, from a baseline, and FLIP's heat map flip.png into a folder, which is made. */
void WriteDiffPictures(
  const std::string& folder, const PictureDiff& diff, const BaselineDiff& baseline);

}
#endif
