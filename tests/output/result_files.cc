#include "output/result_files.h"

#include "common/error.h"
#include "output/example_results.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace vibroimpact::output {
namespace result_files_tests {

namespace fs = std::filesystem;
using testing::Example;
using testing::TemporaryFolder;
using testing::text_of;
using testing::thrown_message;

struct Ranks {
  int rank = 0;
  int size = 1;
  explicit Ranks(MPI_Comm communicator) {
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
  }
};

/// Points are distributed to the ranks after a shuffle that all ranks do alike.
void run_analysis(FileSink &sink, const Example &example, MPI_Comm communicator, unsigned seed) {
  const Ranks ranks(communicator);
  std::vector<std::size_t> order(example.points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  sink.begin(example.header);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (static_cast<int>(i) % ranks.size == ranks.rank)
      sink.store(example.points[order[i]]);
  sink.end();
}

class ResultFiles : public ::testing::Test {
protected:
  void run(MPI_Comm communicator, const fs::path &folder, unsigned seed) {
    RunFolder run_folder(communicator, folder, ExistingFolder::refuse, "set Title = example\n");
    FileSink sink(communicator, run_folder, testing::example_information(),
                  testing::example_bodies());
    for (const Example &example : testing::all_examples())
      run_analysis(sink, example, communicator, seed);
  }

  /// The whole run by one rank in the natural order of the points; on all ranks when it returns.
  void run_reference() {
    if (Ranks(MPI_COMM_WORLD).rank == 0)
      run(MPI_COMM_SELF, reference, 0);
    MPI_Barrier(MPI_COMM_WORLD);
  }

  TemporaryFolder temporary{MPI_COMM_WORLD};
  fs::path folder = temporary.path() / "run";
  fs::path reference = temporary.path() / "reference";
};

TEST_F(ResultFiles, AreTheSameForAnyRanksAndOrder) {
  run_reference();
  run(MPI_COMM_WORLD, folder, 17);
  EXPECT_EQ(text_of(folder / "results.h5"), text_of(reference / "results.h5"));
  EXPECT_EQ(text_of(folder / "summary.txt"), text_of(reference / "summary.txt"));
  EXPECT_EQ(text_of(folder / "summary.json"), text_of(reference / "summary.json"));
  EXPECT_EQ(text_of(folder / "release/frame-00002.vtu"),
            text_of(reference / "release/frame-00002.vtu"));
  EXPECT_GT(fs::file_size(folder / "results.h5"), 10000U);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(ResultFiles, HoldEveryPointAtItsPlace) {
  run(MPI_COMM_WORLD, folder, 5);
  const Hdf5File file = Hdf5File::open(folder / "results.h5");
  const std::string group = "/analysis/map";
  EXPECT_EQ(file.read_attribute(group, "type"), "stepped sweep");
  const std::string field = group + "/point/right.head/displacement_x/peak_to_peak";
  EXPECT_EQ(file.shape(field), (Shape{3, 31, 2}));
  EXPECT_EQ(file.shape(group + "/state"), (Shape{3, 31, 2, 2}));
  const std::vector<double> values = file.read_numbers(field);
  const Example example = testing::grid_example();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto &fields = example.points[i].fields;
    const auto found = std::find_if(fields.begin(), fields.end(), [](const Field &candidate) {
      return candidate.name() == "point/right.head/displacement_x/peak_to_peak";
    });
    EXPECT_EQ(values[i], found->values[0]);
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(ResultFiles, FailedPointsAreMarked) {
  run(MPI_COMM_WORLD, folder, 5);
  const Hdf5File file = Hdf5File::open(folder / "results.h5");
  EXPECT_EQ(file.read_numbers("/analysis/response/status")[1], 1);
  EXPECT_EQ(file.read_strings("/analysis/response/reason")[1],
            "more than 1000 impacts in one period");
  EXPECT_TRUE(std::isnan(file.read_numbers("/analysis/response/steady")[1]));
  EXPECT_NE(text_of(folder / "summary.txt").find("analysis.response.failed_points = 1 [1]\n"),
            std::string::npos);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(ResultFiles, ResumedRunFindsWhatWasStored) {
  const Example example = testing::sweep_example();
  constexpr std::size_t stored_points = 40;
  const Ranks ranks(MPI_COMM_WORLD);
  run_reference();
  {
    RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "set A = 1\n");
    FileSink sink(MPI_COMM_WORLD, run_folder, testing::example_information(), {});
    sink.begin(example.header);
    for (std::size_t i = 0; i < stored_points; ++i)
      if (static_cast<int>(i) % ranks.size == ranks.rank)
        sink.store(example.points[i]);
    MPI_Barrier(MPI_COMM_WORLD); // killed here: no end()
  }
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::resume, "set A = 1\n");
  FileSink sink(MPI_COMM_WORLD, run_folder, testing::example_information(), {});
  sink.begin(example.header);
  for (std::size_t i = 0; i < example.points.size(); ++i) {
    const PointResult *found = sink.find(example.points[i].index);
    ASSERT_EQ(found != nullptr, i < stored_points) << i;
    if (found != nullptr) {
      EXPECT_EQ(found->status, example.points[i].status);
      EXPECT_EQ(found->reason, example.points[i].reason);
      ASSERT_EQ(found->fields.size(), example.points[i].fields.size());
      for (std::size_t f = 0; f < found->fields.size(); ++f)
        EXPECT_EQ(found->fields[f].values, example.points[i].fields[f].values);
    } else if (static_cast<int>(i) % ranks.size == ranks.rank) {
      sink.store(example.points[i]);
    }
  }
  sink.end();
  const Hdf5File resumed = Hdf5File::open(folder / "results.h5");
  const Hdf5File whole = Hdf5File::open(reference / "results.h5");
  const std::string field = "/analysis/response/contact/heads/normal_force/maximum";
  // Compared as bits: a NaN of the failed point equals itself.
  const std::vector<double> here = resumed.read_numbers(field);
  const std::vector<double> there = whole.read_numbers(field);
  ASSERT_EQ(here.size(), there.size());
  EXPECT_EQ(std::memcmp(here.data(), there.data(), here.size() * sizeof(double)), 0);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(ResultFiles, MotionSurvivesTheJournal) {
  const PointResult original = testing::transient_example().points[0];
  {
    RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
    if (Ranks(MPI_COMM_WORLD).rank == 0)
      RecordWriter(run_folder.journal_file(3)).append("release", original);
    MPI_Barrier(MPI_COMM_WORLD);
    const StoredPoints points = read_points(run_folder.journal_files(), "release");
    ASSERT_EQ(points.size(), 1U);
    const Motion &motion = points.find({})->motion.at(0);
    EXPECT_EQ(motion.time, original.motion[0].time);
    ASSERT_EQ(motion.coordinates.size(), 3U);
    EXPECT_EQ(motion.coordinates[1], original.motion[0].coordinates[1]);
    EXPECT_EQ(motion.base_displacement[2], original.motion[0].base_displacement[2]);
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST_F(ResultFiles, AreRebuiltWhileTheAnalysisRuns) {
  const Example example = testing::sweep_example();
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
  FileSink sink(MPI_COMM_WORLD, run_folder, testing::example_information(), {},
                std::chrono::seconds(0));
  sink.begin(example.header);
  if (Ranks(MPI_COMM_WORLD).rank == 0) {
    sink.store(example.points[7]);
    const std::vector<double> status =
        Hdf5File::open(folder / "results.h5").read_numbers("/analysis/response/status");
    EXPECT_EQ(std::count(status.begin(), status.end(), -1.0), 121);
    EXPECT_EQ(status[7], 0);
  }
  sink.end();
}

TEST_F(ResultFiles, OtherAxesInAResumedFolderAreRefused) {
  Example example = testing::sweep_example();
  {
    RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
    FileSink(MPI_COMM_WORLD, run_folder, {}, {}).begin(example.header);
  }
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::resume, "");
  FileSink sink(MPI_COMM_WORLD, run_folder, {}, {});
  example.header.axes[0].values[3] += 1e-9;
  EXPECT_NE(thrown_message<InputError>([&] { sink.begin(example.header); }).find("other axes"),
            std::string::npos);
}

TEST_F(ResultFiles, PointsOutsideTheAxesAreAnError) {
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
  FileSink sink(MPI_COMM_WORLD, run_folder, {}, {});
  sink.begin(testing::sweep_example().header);
  PointResult point;
  point.index = {61, 0};
  EXPECT_THROW(sink.store(point), std::logic_error);
  point.index = {3};
  EXPECT_THROW(sink.store(point), std::logic_error);
}

TEST_F(ResultFiles, ThatCannotBeWrittenAreAnErrorInTheEndOnAllRanks) {
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
  FileSink sink(MPI_COMM_WORLD, run_folder, {}, {});
  sink.begin({"a", "modal", {}});
  const bool first = Ranks(MPI_COMM_WORLD).rank == 0;
  if (first)
    fs::create_directory(run_folder.results_file()); // a folder in the place of the file
  sink.end();
  const std::string message = thrown_message<std::runtime_error>([&] { sink.check_written(); });
  EXPECT_NE(message.find("results.h5: cannot rename"), std::string::npos) << message;
  if (first)
    fs::remove(run_folder.results_file());
  sink.begin({"b", "modal", {}});
  sink.end();
  EXPECT_NO_THROW(sink.check_written()); // what is written later holds everything
  EXPECT_TRUE(fs::is_regular_file(run_folder.results_file()));
}

TEST_F(ResultFiles, AFolderThatIsRemovedIsMadeAgainWithAllPoints) {
  const bool first = Ranks(MPI_COMM_WORLD).rank == 0;
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "set Title = kept\n");
  FileSink sink(MPI_COMM_WORLD, run_folder, {}, {});
  sink.begin({"a", "modal", {}});
  sink.store({.index = {}, .status = Status::failed, .reason = "kept"});
  MPI_Barrier(MPI_COMM_WORLD);
  if (first)
    fs::remove_all(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  sink.end();
  EXPECT_NO_THROW(sink.check_written());
  if (!first)
    return;
  EXPECT_EQ(text_of(RunFolder::parameters_file(folder)), "set Title = kept\n");
  std::size_t found = 0;
  for (const auto &[header, points] : read_run(run_folder.journal_files()))
    points.visit([&](const PointResult &point) { found += point.reason == "kept" ? 1 : 0; });
  EXPECT_EQ(found, 1U);
  EXPECT_TRUE(fs::is_regular_file(run_folder.results_file()));
}

TEST_F(ResultFiles, FullDiskReachesAllRanks) {
  const Ranks ranks(MPI_COMM_WORLD);
  RunFolder run_folder(MPI_COMM_WORLD, folder, ExistingFolder::refuse, "");
  if (ranks.rank == 0)
    fs::create_symlink("/dev/full", run_folder.journal_file(0));
  MPI_Barrier(MPI_COMM_WORLD);
  FileSink sink(MPI_COMM_WORLD, run_folder, {}, {});
  const std::string message = thrown_message<std::runtime_error>([&] {
    sink.begin({"a", "modal", {}});
  });
  EXPECT_EQ(message,
            run_folder.journal_file(0).string() + ": cannot write: No space left on device");
}

} // namespace result_files_tests
} // namespace vibroimpact::output
