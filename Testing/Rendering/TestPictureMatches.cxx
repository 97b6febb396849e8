// The comparison of pictures that all tests here use: what it lets pass, what it says, and the files that it leaves.
#include "TestPicture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

namespace
{

namespace fs = std::filesystem;

/** The folder of pictures is one of its own while a test fails on purpose. */
class PictureMatches : public testing::Test
{
protected:
  PictureMatches() { setenv("VITRINE_TEST_OUTPUT", this->Folder.c_str(), 1); }

  ~PictureMatches() override
  {
    unsetenv("VITRINE_TEST_OUTPUT");
    fs::remove_all(this->Folder);
  }

  /** 4 x 3 pixels of one colour. */
  static Picture Plain()
  {
    Picture picture;
    picture.Width = 4;
    picture.Height = 3;
    for (int pixel = 0; pixel < 12; ++pixel)
    {
      picture.Bytes.insert(picture.Bytes.end(), { 10, 20, 30, 255 });
    }
    return picture;
  }

  /** The same, but for one step in one channel of the pixel in the top left corner. */
  static Picture WithOneStep()
  {
    Picture picture = Plain();
    picture.Bytes[4 * 8 + 1] = 21;
    return picture;
  }

  /** Names of files, with the folder of this test. */
  std::set<std::string> Files() const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(this->Folder))
    {
      if (entry.is_regular_file())
      {
        names.insert(fs::relative(entry.path(), this->Folder).string());
      }
    }
    return names;
  }

  const fs::path Folder =
    fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(PictureMatches, ToleratesWhatItIsTold)
{
  EXPECT_TRUE(Matches(Plain(), Plain()));
  EXPECT_TRUE(Matches(WithOneStep(), Plain(), 1));
  EXPECT_TRUE(Matches(WithOneStep(), Plain(), 0, 1.0 / 12.0));
  EXPECT_FALSE(fs::exists(this->Folder)) << "what matches writes nothing";
  EXPECT_FALSE(Matches(WithOneStep(), Plain(), 0, 0.99 / 12.0));
}

TEST_F(PictureMatches, TellsOneStepOfOnePixel)
{
  const testing::AssertionResult result = Matches(WithOneStep(), Plain());
  EXPECT_FALSE(result);
  const std::string message = result.message();
  EXPECT_NE(
    message.find("1 of 12 pixels differ, and the largest difference is 1/255"), message.npos);
  EXPECT_NE(message.find("pixel 0, 0 from the top left: got 10 21 30 255, expected 10 20 30 255"),
    message.npos)
    << message;
  EXPECT_NE(message.find("1-{got,expected,difference}.png"), message.npos) << message;
}

TEST_F(PictureMatches, LeavesPicturesToLookAt)
{
  EXPECT_FALSE(Matches(WithOneStep(), Plain(), 0, 0.0, { "culled", "plain" }));
  const std::string folder = "PictureMatches.LeavesPicturesToLookAt/";
  EXPECT_EQ(this->Files(),
    (std::set<std::string>{
      folder + "1-culled.png", folder + "1-plain.png", folder + "1-difference.png" }));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((this->Folder / (folder + "1-difference.png")).c_str());
  reader->Update();
  vtkImageData* const difference = reader->GetOutput();
  ASSERT_EQ(difference->GetDimensions()[0], 4);
  ASSERT_EQ(difference->GetDimensions()[1], 3);
  EXPECT_EQ(
    difference->GetScalarComponentAsDouble(0, 2, 0, 0), 255.0);       // red in the top left corner
  EXPECT_EQ(difference->GetScalarComponentAsDouble(0, 0, 0, 0), 5.0); // dark elsewhere
}

TEST_F(PictureMatches, LeavesThoseOfThreeFailures)
{
  for (int failure = 0; failure < 5; ++failure)
  {
    EXPECT_FALSE(Matches(WithOneStep(), Plain()));
  }
  EXPECT_EQ(this->Files().size(), 9u);
}

TEST_F(PictureMatches, TellsUnequalSizes)
{
  Picture wide = Plain();
  wide.Width = 6;
  wide.Height = 2;
  const testing::AssertionResult result = Matches(wide, Plain(), 255);
  EXPECT_FALSE(result);
  EXPECT_STREQ(result.message(), "got has 6 x 2 pixels, expected 4 x 3");
}

}
