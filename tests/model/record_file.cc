// Records in text and HDF5 files, sound and broken.
#include "model/record_file.h"
#include "common/hdf5_file.h"
#include "model/excitation.h"
#include "model/histories.h"
#include "reduction/named_file.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace vibroimpact::model {
namespace record_file_tests {

const RecordLayout by_number{.time_column = "1", .value_column = "2", .separator = "comma"};

void expect_samples(const Samples &samples, const std::vector<double> &time,
                    const std::vector<double> &value) {
  EXPECT_EQ(samples.time, time);
  EXPECT_EQ(samples.value, value);
}

TEST(RecordFileTest, TextWithCommentsAndBlanks) {
  expect_samples(read_text_record("# a record\n\n0, 1.5\n 0.5 ,-2e-3\r\n% end\n1,+3", by_number),
                 {0, 0.5, 1}, {1.5, -2e-3, 3});
}

TEST(RecordFileTest, FirstLineMayNameTheColumns) {
  const std::string text = "time;\"a x\";a y\n0;1;2\n1;3;4\n";
  expect_samples(read_text_record(text, {"time", "a y", "semicolon"}), {0, 1}, {2, 4});
  expect_samples(read_text_record(text, {"1", "a x", "semicolon"}), {0, 1}, {1, 3});
  expect_samples(read_text_record(text, {"1", "3", "semicolon"}), {0, 1}, {2, 4});
}

TEST(RecordFileTest, AByteOrderMarkIsNoPartOfTheFirstName) {
  const std::string mark = "\xEF\xBB\xBF";
  expect_samples(read_text_record(mark + "time,a\n0,1\n1,3\n", {"time", "a", "comma"}), {0, 1},
                 {1, 3});
  expect_samples(read_text_record(mark + "0,1\n1,3\n", by_number), {0, 1}, {1, 3});
}

TEST(RecordFileTest, BlanksAndTabsSeparate) {
  expect_samples(read_text_record("  0  1\t2\n1\t\t3 4\n", {"1", "3", "space"}), {0, 1}, {2, 4});
}

struct Broken {
  std::string text;
  RecordLayout layout;
  std::string key;
  std::string says;
};

TEST(RecordFileTest, SaysWhatIsWrongAndWhere) {
  const std::vector<Broken> list = {
      {"0,1\n1,two\n", by_number, "Value column", "line 2 of the record has 'two'"},
      {"#\n0,1\n1,nan\n", by_number, "Value column", "line 3"},
      {"0,1\ninf,2\n", by_number, "Time column", "line 2"},
      {"0,1\n1,2,\n1,,\n", {"1", "3", "comma"}, "Value column", "has only 2 columns"},
      {"0,1\n1,1e999\n", by_number, "Value column", "line 2"},
      {"0,1\n1,2\n1,3\n", by_number, "Time column", "increase, but in line 3"},
      {"0,1\n1,2\n0.5,3\n", by_number, "Time column", "0.5 follows 1"},
      {"0,1\n", by_number, "File", "two samples at least; this one has 1"},
      {"a,b\n", by_number, "File", "this one has 0"},
      {"0 1\n1 2\n", by_number, "Value column", "is the separator right?"},
      {"0;1\nx;2\n", {"1", "2", "semicolon"}, "Time column", "line 2"},
      {"time,force\n0,1\n1,2\n", {"time", "forces", "comma"}, "Value column", "time, force"},
      {"0,1\n1,2\n", {"0", "2", "comma"}, "Time column", "a number from 1"},
      {"0,x\n1,2\n2,3\n", by_number, "Value column", "line 1"},
  };
  for (const Broken &broken : list)
    try {
      read_text_record(broken.text, broken.layout);
      ADD_FAILURE() << "accepted: " << broken.text;
    } catch (const RecordError &error) {
      EXPECT_EQ(error.key(), broken.key) << broken.text;
      EXPECT_NE(std::string(error.what()).find(broken.says), std::string::npos) << error.what();
    }
}

// What an excitation makes of a record of 0, 1, 3 at 0, 1, 2 s: between the samples and after them.
TimeFunctionPointer history_of(const std::string &more, Given given, bool moves_base) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "record.csv") << "0,0\n1,1\n2,3\n";
  const auto root = std::make_shared<parameters::Section>("", "");
  declare_excitations(*root);
  const std::string text = "subsection Excitation shake\nset History = recorded\n"
                           "subsection Recorded\nset File = record.csv\n" +
                           more + "end\nend\n";
  const auto set = parameters::ParameterSet::parse(root, text, "test.prm", false);
  const HistoryContext context{.type = "recorded",
                               .given = given,
                               .moves_base = moves_base,
                               .dimension = parameters::dimension::length,
                               .file_folder = folder.path().string(),
                               .file_checksums = {}};
  return create_history(set->root().instance("Excitation", "shake"), context);
}

// A base stays where its displacement ends, and goes on at the velocity with which the record of
// that ends; a force and an acceleration are over.
TEST(RecordFileTest, WhatHoldsAfterTheRecord) {
  const std::string spline = "set Interpolation = cubic spline\n";
  const TimeFunctionPointer displaced = history_of(spline, Given::displacement, true);
  EXPECT_NEAR(displaced->value(7), 3, 1e-15);
  EXPECT_EQ(displaced->rate(7), 0);
  const TimeFunctionPointer velocity = history_of("", Given::velocity, true);
  EXPECT_NEAR(velocity->rate(7), 3, 1e-15);
  EXPECT_NEAR(velocity->value(4), 0.5 + 2 + 2 * 3, 1e-14); // the areas under the lines
  const TimeFunctionPointer acceleration = history_of("", Given::acceleration, true);
  EXPECT_EQ(acceleration->acceleration(7), 0);
  EXPECT_NEAR(acceleration->rate(7), 2.5, 1e-15);
  EXPECT_EQ(history_of("", Given::displacement, false)->value(7), 0);
}

TEST(RecordFileTest, UnitsScaleAndOffset) {
  const TimeFunctionPointer history = history_of("set Time unit = ms\nset Time offset = 1 ms\n"
                                                 "set Unit = mm\nset Scale factor = -2\n",
                                                 Given::displacement, false);
  EXPECT_NEAR(history->value(1.5e-3), -1e-3, 1e-15);
  EXPECT_NEAR(history->value(2.5e-3), -4e-3, 1e-15);
  EXPECT_EQ(history->value(0.5e-3), 0);
}

TEST(RecordFileTest, Hdf5) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder.path() / "record.h5").string();
  EXPECT_TRUE(reduction::is_hdf5(file));
  EXPECT_FALSE(reduction::is_hdf5("record.csv"));
  Hdf5File made = Hdf5File::create(file);
  made.write("/run/time", {3}, std::vector<double>{0, 1, 2});
  made.write("/run/force", {3}, std::vector<double>{4, 5, 6});
  made.write("/run/short", {2}, std::vector<double>{4, 5});
  made.write("/run/square", {1, 3}, std::vector<double>{4, 5, 6});
  made.write("/run/back", {3}, std::vector<double>{0, 1, 0.5});
  made.write("/run/gap", {3}, std::vector<double>{0, std::nan(""), 0.5});
  made.close();
  expect_samples(read_hdf5_record(file, {"/run/time", "/run/force", ""}), {0, 1, 2}, {4, 5, 6});
  const std::vector<Broken> list = {
      {"", {"/run/time", "/run/none", ""}, "Value column", "path of a dataset"},
      {"", {"1", "/run/force", ""}, "Time column", "path of a dataset"},
      {"", {"/run", "/run/force", ""}, "Time column", "path of a dataset"},
      {"", {"/run/time", "/run/short", ""}, "Value column", "2 values for 3 instants"},
      {"", {"/run/time", "/run/square", ""}, "Value column", "this one has 2"},
      {"", {"/run/time", "/run/gap", ""}, "Value column", "sample 2"},
      {"", {"/run/back", "/run/force", ""}, "Time column", "in sample 3"},
  };
  for (const Broken &broken : list)
    try {
      read_hdf5_record(file, broken.layout);
      ADD_FAILURE() << "accepted: " << broken.layout.value_column;
    } catch (const RecordError &error) {
      EXPECT_EQ(error.key(), broken.key);
      EXPECT_NE(std::string(error.what()).find(broken.says), std::string::npos) << error.what();
    }
  EXPECT_THROW(read_hdf5_record((folder.path() / "none.h5").string(), by_number), RecordError);
}

} // namespace record_file_tests
} // namespace vibroimpact::model
