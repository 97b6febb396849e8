#include "Errors.h"
#include "chart/ChartRecord.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

namespace fs = std::filesystem;
using program::ChartRecord;
using program::InputError;
using program::Json;

/** A folder of its own for each test. */
class ChartRecordTest : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "chart-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    this->Folder = name;
  }

  void TearDown() override { fs::remove_all(this->Folder); }

  ChartRecord Open(const Json& head) const { return { this->Chart(), head, "--there" }; }

  std::string Chart() const { return (this->Folder / "chart").string(); }

  std::string Read(const std::string& name) const
  {
    std::ifstream file(this->Chart() + "/" + name, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  void Write(const std::string& name, const std::string& text) const
  {
    fs::create_directory(this->Chart());
    std::ofstream(this->Chart() + "/" + name, std::ios::binary) << text;
  }

  /** What is said where a record cannot be begun; empty if it can. */
  std::string Refusal(const Json& head) const
  {
    try
    {
      this->Open(head);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  }

  fs::path Folder;
};

Json Head()
{
  return { { "vitrine", "1" }, { "build", "a" }, { "device", { { "renderer", "any" } } },
    { "settings", { { "input", "a.stl" } } } };
}

Json Row(int step)
{
  return { { "part", "layers" }, { "step", step }, { "scene", "stack" }, { "method", "blend" },
    { "width", 8 }, { "height", 8 }, { "frame_ms", { { "median", 1.5 } } } };
}
}

TEST_F(ChartRecordTest, BeginsWithoutRows)
{
  ChartRecord record = this->Open(Head());
  EXPECT_EQ(record.GoOn(), "");
  EXPECT_TRUE(record.Rows("results").empty());
  EXPECT_TRUE(record.Rows("failures").empty());
  EXPECT_EQ(Json::parse(this->Read("chart.json"))["results"], Json::array());
}

TEST_F(ChartRecordTest, GoesOnWithTheRowsThatAreThere)
{
  this->Open(Head()).Add("results", Json::array({ Row(0), Row(1) }));
  ChartRecord record = this->Open(Head());
  EXPECT_NE(record.GoOn().find("has 2 results already"), std::string::npos);
  EXPECT_EQ(record.Rows("results"), Json::array({ Row(0), Row(1) }));
  EXPECT_TRUE(record.Has("results", { { "part", "layers" }, { "step", 1 } }));
  EXPECT_FALSE(record.Has("results", { { "part", "layers" }, { "step", 2 } }));
  EXPECT_FALSE(record.Has("failures", { { "part", "layers" } }));
}

TEST_F(ChartRecordTest, MeasuresAnewWhereItDoesNotGoOn)
{
  this->Open(Head()).Add("results", Json::array({ Row(0), Row(1) }));
  ChartRecord record = this->Open(Head());
  record.Add("results", Json::array({ Row(5) }));
  EXPECT_EQ(Json::parse(this->Read("chart.json"))["results"], Json::array({ Row(5) }));
}

TEST_F(ChartRecordTest, GoesOnWithNamesThatAreNotUTF8)
{
  Json head = Head();
  head["settings"]["input"] = "caf\xe9.stl";
  this->Open(head).Add("results", Json::array({ Row(0) }));
  EXPECT_EQ(this->Refusal(head), "");
  EXPECT_NE(this->Open(head).GoOn(), "");
}

TEST_F(ChartRecordTest, LeavesWhatWasMeasuredOtherwise)
{
  this->Open(Head()).Add("results", Json::array({ Row(0) }));
  const std::string before = this->Read("chart.json");
  for (const auto& [key, words] :
    { std::pair("vitrine", "by another version"), std::pair("build", "by another build"),
      std::pair("device", "on another device"), std::pair("settings", "with other settings") })
  {
    Json head = Head();
    head[key] = "other";
    const std::string refusal = this->Refusal(head);
    EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("--there"), std::string::npos) << refusal;
    EXPECT_EQ(this->Read("chart.json"), before);
  }
}

TEST_F(ChartRecordTest, LeavesPicturesOfNoChart)
{
  this->Write("mine", "");
  fs::create_directory(this->Chart() + "/pictures");
  EXPECT_NE(this->Refusal(Head()).find("pictures"), std::string::npos);
  EXPECT_FALSE(fs::exists(this->Chart() + "/chart.json"));
}

TEST_F(ChartRecordTest, IsOfOneRunAtATime)
{
  {
    const ChartRecord record = this->Open(Head());
    EXPECT_NE(this->Refusal(Head()).find("another run"), std::string::npos);
  }
  EXPECT_EQ(this->Refusal(Head()), "");
}

TEST_F(ChartRecordTest, RemovesRowsByTheirValues)
{
  {
    ChartRecord record = this->Open(Head());
    record.Add("results", Json::array({ Row(0), Row(1), Row(2) }));
    record.Remove("results", { { "step", 1 } });
    record.Remove("results", { { "step", 7 } });
    record.Remove("failures", { { "step", 0 } });
  }
  EXPECT_EQ(Json::parse(this->Read("chart.json"))["results"], Json::array({ Row(0), Row(2) }));
}

TEST_F(ChartRecordTest, TakesListsOfRowsOnly)
{
  Json document = Head();
  for (const auto& [key, value] : { std::pair("results", Json::object()),
         std::pair("results", Json("rows")), std::pair("failures", Json(3)) })
  {
    document["results"] = Json::array();
    document[key] = value;
    this->Write("chart.json", document.dump());
    EXPECT_NE(this->Refusal(Head()).find("is not the chart.json of a chart"), std::string::npos);
  }
}

TEST_F(ChartRecordTest, RefusesDamagedRows)
{
  Json document = Head();
  document["results"] = Json::array({ Row(0), Row(-1) });
  this->Write("chart.json", document.dump());
  EXPECT_THROW(this->Open(Head()).GoOn(), InputError);
  document["results"] = Json::array({ Row(0) });
  document["failures"] = Json::array({ Row(0) });
  this->Write("chart.json", document.dump());
  EXPECT_THROW(this->Open(Head()).GoOn(), InputError);
}

TEST_F(ChartRecordTest, FindsWhatIsInTheWayBeforeAnythingIsMeasured)
{
  for (const char* name : { "chart.json", "index.html", "error.png", "growth.png" })
  {
    fs::create_directories(this->Chart() + "/" + name);
    EXPECT_NE(this->Refusal(Head()).find(name), std::string::npos);
    fs::remove(this->Chart() + "/" + name);
  }
  EXPECT_EQ(this->Refusal(Head()), "");
}

TEST_F(ChartRecordTest, LeavesPagesAndPlotsOfOthers)
{
  for (const char* name : { "index.html", "error.png", "growth.png" })
  {
    this->Write(name, "mine");
    const std::string refusal = this->Refusal(Head());
    EXPECT_NE(refusal.find(std::string(name) + ": is of no chart"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("--there"), std::string::npos) << refusal;
    EXPECT_EQ(this->Read(name), "mine");
    EXPECT_FALSE(fs::exists(this->Chart() + "/pictures"));
    fs::remove(this->Chart() + "/" + name);
  }
}

TEST_F(ChartRecordTest, WritesPicturesIntoAFolderOfTheirOwn)
{
  ChartRecord record = this->Open(Head());
  EXPECT_EQ(record.AddPicture("a", std::vector<std::uint8_t>(12, 7), { 2, 2 }), "pictures/a.png");
  EXPECT_EQ(this->Read("pictures/a.png").substr(1, 3), "PNG");
}
