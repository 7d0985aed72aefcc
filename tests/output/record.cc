#include "output/record.h"

#include "temporary_folder.h"
#include "text_of.h"

#include <cmath>
#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace record_tests {

namespace fs = std::filesystem;
using testing::TemporaryFolder;
using testing::thrown_message;

PointResult point(std::size_t row, std::size_t column, double value) {
  PointResult result;
  result.index = {row, column};
  result.fields = {{Label("force", "N", "largest force on the head"), {}, {value}},
                   {Label("state", "SI", "state at the end", {"state"}), {2}, {value, -value}}};
  result.summary = {{Label("force", "N", ""), value}};
  return result;
}

class RecordTest : public ::testing::Test {
protected:
  StoredPoints points(const std::string &analysis) { return read_points({file}, analysis); }

  TemporaryFolder folder;
  fs::path file = folder.path() / "rank-00000.journal";
};

TEST_F(RecordTest, PointComesBackAsItWas) {
  PointResult original = point(3, 1, 1e-300);
  original.status = Status::failed;
  original.reason = "diverged";
  RecordWriter(file).append("map", original);
  const StoredPoints stored = points("map");
  const PointResult *found = stored.find({3, 1});
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->index, original.index);
  EXPECT_EQ(found->status, Status::failed);
  EXPECT_EQ(found->reason, "diverged");
  ASSERT_EQ(found->fields.size(), 2U);
  EXPECT_EQ(found->fields[1].name(), "state");
  EXPECT_EQ(found->fields[1].unit(), "SI");
  EXPECT_EQ(found->fields[1].description(), "state at the end");
  EXPECT_EQ(found->fields[1].dimensions(), original.fields[1].dimensions());
  EXPECT_EQ(found->fields[1].shape, original.fields[1].shape);
  EXPECT_EQ(found->fields[1].values, original.fields[1].values);
  EXPECT_EQ(found->summary[0].value, 1e-300);
  EXPECT_EQ(stored.find({1, 3}), nullptr);
}

TEST_F(RecordTest, PointsAreVisitedInTheOrderOfTheirIndex) {
  RecordWriter writer(file);
  for (const std::size_t i : {7, 2, 300, 0, 256})
    writer.append("map", point(i, 5 - i % 2, static_cast<double>(i)));
  std::vector<double> visited;
  points("map").visit([&](const PointResult &p) { visited.push_back(p.fields[0].values[0]); });
  EXPECT_EQ(visited, (std::vector<double>{0, 2, 7, 256, 300}));
}

TEST_F(RecordTest, TheFirstOfTwoEqualPointsCounts) {
  RecordWriter writer(file);
  for (const double value : {1.0, 2.0})
    writer.append("map", point(0, 0, value));
  EXPECT_EQ(points("map").size(), 1U);
  EXPECT_EQ(points("map").find({0, 0})->fields[0].values[0], 1);
}

TEST_F(RecordTest, NamesAndDescriptionsAreWrittenOnce) {
  RecordWriter writer(file);
  writer.append("map", point(0, 0, 1));
  const std::uintmax_t first = fs::file_size(file);
  for (std::size_t i = 1; i <= 1000; ++i)
    writer.append("map", point(i, 0, 1));
  // prefix 12, kind and layout 5, index 9, status 1, reason 4, length of the state 8, 4 numbers 32
  EXPECT_EQ(fs::file_size(file) - first, 1000U * 71U);
}

TEST_F(RecordTest, OtherFieldsAreAnotherLayout) {
  RecordWriter writer(file);
  PointResult without = point(1, 0, 4);
  without.fields.erase(without.fields.begin());
  without.summary.clear();
  writer.append("map", point(0, 0, 3));
  writer.append("map", without);
  writer.append("other", point(0, 0, 6));
  writer.append("map", point(2, 0, 5));
  const StoredPoints stored = points("map");
  EXPECT_EQ(stored.size(), 3U);
  EXPECT_EQ(stored.find({0, 0})->fields[0].values[0], 3);
  ASSERT_EQ(stored.find({1, 0})->fields.size(), 1U);
  EXPECT_EQ(stored.find({1, 0})->fields[0].values, (std::vector<double>{4, -4}));
  EXPECT_EQ(stored.find({2, 0})->fields[0].values[0], 5);
  EXPECT_EQ(points("other").find({0, 0})->fields[0].values[0], 6);
}

TEST_F(RecordTest, AResumedRunNumbersItsLayoutsAnew) {
  RecordWriter(file).append("map", point(0, 0, 1));
  PointResult other = point(1, 0, 2);
  other.fields[0].label = Label("displacement", "m", "of the head");
  RecordWriter(file).append("map", other);
  const StoredPoints stored = points("map");
  EXPECT_EQ(stored.find({0, 0})->fields[0].name(), "force");
  EXPECT_EQ(stored.find({1, 0})->fields[0].name(), "displacement");
}

TEST_F(RecordTest, JournalsOfSeveralRanksMakeOneAnalysis) {
  const fs::path second = folder.path() / "rank-00001.journal";
  AnalysisHeader header{"map", "stepped sweep", {}};
  RecordWriter(file).append(header);
  RecordWriter(file).append("map", point(1, 0, 10));
  RecordWriter(second).append("map", point(0, 0, 20));
  const std::vector<StoredAnalysis> run = read_run({file, second});
  ASSERT_EQ(run.size(), 1U);
  EXPECT_EQ(run[0].header.type, "stepped sweep");
  ASSERT_EQ(run[0].points.size(), 2U);
  EXPECT_EQ(run[0].points.find({0, 0})->fields[0].values[0], 20);
}

// Of a point that several runs have worked at, on whatever ranks; what follows a gap is no use.
TEST_F(RecordTest, StepsComeBackInTheirOrder) {
  const fs::path second = folder.path() / "rank-00001.journal";
  const auto bundle = [](std::uint64_t first, std::vector<std::string> steps) {
    return StepBundle{.index = {4}, .first = first, .steps = std::move(steps)};
  };
  const std::string zeros("\0x\0", 3);
  RecordWriter(second).append("map", bundle(3, {"d", "e"}));
  RecordWriter(file).append("map", bundle(0, {"a", zeros, "c"}));
  RecordWriter(file).append("map", bundle(1, {zeros, "c"}));
  RecordWriter(file).append("map", bundle(6, {"g"}));
  RecordWriter(file).append("other", bundle(5, {"f"}));
  RecordWriter(file).append("map", point(0, 0, 1));
  const StoredSteps steps = read_steps({file, second}, "map");
  ASSERT_EQ(steps.count({4}), 1U);
  EXPECT_EQ(steps.at({4}), (std::vector<std::string>{"a", zeros, "c", "d", "e"}));
  EXPECT_EQ(points("map").size(), 1U);
}

TEST_F(RecordTest, AJournalInAnotherFormatIsNamed) {
  const std::string number("\x16\0\0\0", 4); // 22
  for (const auto &[record, reason] :
       {std::pair("?" + number, "a record of unknown kind"),
        std::pair("h" + number, "a record of format 22 instead of 1"),
        std::pair(std::string("h\1\0\0\0\4", 6),
                  "bytes are missing or do not match their header")}) {
    fs::remove(file);
    JournalWriter(file).append(record);
    EXPECT_EQ(thrown_message<std::runtime_error>([&] { points("map"); }),
              file.string() +
                  ": cannot read the journal, another version of the program may have " +
                  "written it (" + reason + ")");
  }
}

} // namespace record_tests
} // namespace vibroimpact::output
