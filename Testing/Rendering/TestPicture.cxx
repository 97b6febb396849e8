#include "TestPicture.h"

#include "study/image/PictureDifference.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace
{

namespace fs = std::filesystem;

constexpr int MostFailuresWritten = 3; // of a test

vitrine::PictureView ViewOf(const Picture& picture)
{
  return { picture.Width, picture.Height, 4, picture.Bytes.data() };
}

bool HaveEqualSizes(const Picture& a, const Picture& b)
{
  return a.Width == b.Width && a.Height == b.Height && a.Bytes.size() == b.Bytes.size();
}

/** Row 0 at the bottom, as VTK's images have it. */
void WritePng(const fs::path& path, int width, int height, const std::vector<unsigned char>& rgb)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(rgb.begin(), rgb.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
}

std::vector<unsigned char> ColorsOf(const Picture& picture)
{
  std::vector<unsigned char> colors;
  for (std::size_t i = 0; i < picture.Bytes.size(); i += 4)
  {
    colors.insert(colors.end(), &picture.Bytes[i], &picture.Bytes[i] + 3);
  }
  return colors;
}

/** Names of tests have slashes. */
std::string AsFileName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c) && c != '.'; }, '-');
  return name;
}

fs::path FolderOf(const testing::TestInfo& test)
{
  const char* output = std::getenv("VITRINE_TEST_OUTPUT");
  const std::string name = std::string(test.test_suite_name()) + "." + test.name();
  return fs::path(output && *output ? output : VITRINE_TEST_OUTPUT_DEFAULT) / AsFileName(name);
}

/** The number of a failure among those of the running test, from 1 on. */
int CountFailure(const testing::TestInfo& test)
{
  static const testing::TestInfo* last = nullptr;
  static int failures = 0;
  failures = last == &test ? failures + 1 : 1;
  last = &test;
  return failures;
}

/** Writes the pictures of a failure. Returns a sentence that says where they are. */
std::string WritePictures(
  const Picture& test, const Picture& reference, int tolerance, const PictureNames& names)
{
  const testing::TestInfo* running = testing::UnitTest::GetInstance()->current_test_info();
  const int failure = CountFailure(*running);
  if (failure > MostFailuresWritten)
  {
    return "no pictures are written of any more failures of this test";
  }
  const fs::path folder = FolderOf(*running);
  std::error_code error;
  if (failure == 1)
  {
    fs::remove_all(folder, error);
  }
  fs::create_directories(folder, error);
  const std::string number = std::to_string(failure) + "-";
  const auto write = [&](const std::string& name, const std::vector<unsigned char>& colors)
  { WritePng(folder / (number + name + ".png"), test.Width, test.Height, colors); };
  write(names.Test, ColorsOf(test));
  write(names.Reference, ColorsOf(reference));
  write("difference", vitrine::DrawDifference(ViewOf(test), ViewOf(reference), tolerance));
  return "pictures: " + (folder / number).string() + "{" + names.Test + "," + names.Reference +
    ",difference}.png";
}

std::string SizeOf(const Picture& picture)
{
  return std::to_string(picture.Width) + " x " + std::to_string(picture.Height);
}

}

Rgba Picture::At(int x, int y) const
{
  const unsigned char* p = this->Bytes.data() + 4 * (static_cast<std::size_t>(y) * this->Width + x);
  return { p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0 };
}

Picture ReadPicture(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetSize()[0];
  picture.Height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> data;
  window->GetRGBACharPixelData(0, 0, picture.Width - 1, picture.Height - 1, 0, data);
  picture.Bytes.assign(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  return picture;
}

Picture ToPicture(vtkImageData* image)
{
  Picture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  const int channels = image->GetNumberOfScalarComponents();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    picture.Bytes.insert(picture.Bytes.end(), bytes + channels * i, bytes + channels * i + 3);
    picture.Bytes.push_back(channels == 4 ? bytes[channels * i + 3] : 255);
  }
  return picture;
}

Rgba UniformColor(const Picture& picture)
{
  for (std::size_t i = 4; i < picture.Bytes.size(); ++i)
  {
    if (picture.Bytes[i] != picture.Bytes[i - 4])
    {
      ADD_FAILURE() << "pixel " << i / 4 << " differs from the one before it";
      break;
    }
  }
  return picture.At(0, 0);
}

testing::AssertionResult Matches(const Picture& test, const Picture& reference, int tolerance,
  double besides, const PictureNames& names)
{
  if (!HaveEqualSizes(test, reference))
  {
    return testing::AssertionFailure() << names.Test << " has " << SizeOf(test) << " pixels, "
                                       << names.Reference << " " << SizeOf(reference);
  }
  const vitrine::PictureDifference difference =
    vitrine::FindDifference(ViewOf(test), ViewOf(reference), tolerance);
  const std::size_t allowed = difference.PixelsOfShare(besides);
  if (difference.DifferentPixels <= allowed)
  {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure()
    << vitrine::DescribeDifference(difference, names.Test, names.Reference) << "\n"
    << (allowed > 0 ? "as many may differ as " + std::to_string(allowed) + "\n" : "")
    << WritePictures(test, reference, tolerance, names);
}

std::optional<PixelPlace> FirstDifference(const Picture& a, const Picture& b)
{
  if (!HaveEqualSizes(a, b))
  {
    return std::nullopt;
  }
  const vitrine::PictureDifference difference = vitrine::FindDifference(ViewOf(a), ViewOf(b), 0);
  if (difference.First.empty())
  {
    return std::nullopt;
  }
  const vitrine::DifferentPixel& first = difference.First.front();
  return PixelPlace{ first.X, a.Height - 1 - first.Y };
}

int LargestDifference(const Picture& a, const Picture& b)
{
  return HaveEqualSizes(a, b) ? vitrine::FindDifference(ViewOf(a), ViewOf(b), 0).Largest : 256;
}
