/**
 * Pictures, and the one comparison of them in these tests. A failure leaves pictures to look at.
 */
#ifndef VITRINE_TEST_PICTURE_H
#define VITRINE_TEST_PICTURE_H

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkRenderWindow;

using Rgba = std::array<double, 4>;

/** The bytes of a window, RGBA, row 0 at the bottom. */
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  Rgba At(int x, int y) const;

  /** For pictures that are to differ; Matches() says more where two are to be the same. */
  bool operator==(const Picture& other) const { return this->Bytes == other.Bytes; }
  bool operator!=(const Picture& other) const { return !(*this == other); }
};

Picture ReadPicture(vtkRenderWindow* window);

/** An image of bytes, RGB or RGBA; the former is opaque. */
Picture ToPicture(vtkImageData* image);

/** The colour of the pixels, if they all have the same; else expects so and fails. */
Rgba UniformColor(const Picture& picture);

/** What two pictures that are compared are called, in messages and as names of files. */
struct PictureNames
{
  std::string Test = "got";
  std::string Reference = "expected";
};

/**
 * Whether no channel of any pixel differs by more than `tolerance` steps of 1/255. The `besides` share of the pixels,
 * those that differ most, is left out.
 *
 *     EXPECT_TRUE(Matches(scene.Render(), expected));
 *
 * A failure tells how many pixels differ, and the coordinates and values of the first ones. It writes both pictures
 * and their difference as PNG files, and names them. They go to a folder for each test, below Testing/Pictures of the
 * build tree, or below the folder that the environment variable VITRINE_TEST_OUTPUT names. The first failure of a test
 * empties its folder. Only the first three failures of a test write files. The files have no alpha; the message has
 * it.
 */
testing::AssertionResult Matches(const Picture& test, const Picture& reference, int tolerance = 0,
  double besides = 0.0, const PictureNames& names = {});

/** A pixel of a picture: the column from the left and the row from the bottom, from 0 on. */
using PixelPlace = std::array<int, 2>;

/** The first pixel that differs, row by row from the top; nothing if none does, or the sizes do. */
std::optional<PixelPlace> FirstDifference(const Picture& a, const Picture& b);

/** The largest difference of any channel, in steps of 1/255, for pictures that are to differ; 256 if their sizes do. */
int LargestDifference(const Picture& a, const Picture& b);

#endif
