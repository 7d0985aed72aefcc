#include "output/run_folder.h"

#include "common/error.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace run_folder_tests {

namespace fs = std::filesystem;
using testing::TemporaryFolder;
using testing::text_of;
using testing::thrown_message;
using testing::write_text;

const std::string parameters = "set Title = beams\n"
                               "subsection Contact heads\n"
                               "  set Clearance = 5 mm\n"
                               "  subsection Hertz\n"
                               "    set Exponent = 1.5\n"
                               "  end\n"
                               "end\n"
                               "subsection Contact stop\n"
                               "  set Clearance = 9 mm\n"
                               "end\n";

class RunFolderTest : public ::testing::Test {
protected:
  std::string error(ExistingFolder existing, const std::string &echo = parameters) {
    return thrown_message<InputError>([&] { prepare(existing, echo); });
  }
  void prepare(ExistingFolder existing, const std::string &echo = parameters) {
    RunFolder run(MPI_COMM_WORLD, folder, existing, echo);
  }

  TemporaryFolder temporary{MPI_COMM_WORLD};
  fs::path folder = temporary.path() / "output" / "beams";
};

TEST_F(RunFolderTest, MakesANewFolderAndKeepsTheParameters) {
  const RunFolder run(MPI_COMM_WORLD, folder, ExistingFolder::refuse, parameters);
  EXPECT_FALSE(run.resumed());
  EXPECT_EQ(text_of(folder / "parameters.prm"), parameters);
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(RunFolderTest, RefusesAFolderWithFilesOnEveryRank) {
  prepare(ExistingFolder::refuse);
  EXPECT_EQ(error(ExistingFolder::refuse), "the result folder " + folder.string() +
                                               " exists and is not empty; use --overwrite or "
                                               "--resume");
}

TEST_F(RunFolderTest, TakesAnEmptyFolder) {
  fs::create_directories(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(error(ExistingFolder::refuse), "no error");
}

TEST_F(RunFolderTest, ResumesWithTheSameParameters) {
  prepare(ExistingFolder::refuse);
  const RunFolder run(MPI_COMM_WORLD, folder, ExistingFolder::resume, parameters);
  EXPECT_TRUE(run.resumed());
}

TEST_F(RunFolderTest, ShowsWhichParametersDiffer) {
  prepare(ExistingFolder::refuse);
  std::string other = parameters;
  other.replace(other.find("1.5"), 3, "1.4");
  other.replace(other.find("5 mm"), 4, "9 mm"); // also the value of the other contact
  EXPECT_EQ(error(ExistingFolder::resume, other),
            "cannot resume " + folder.string() +
                ", it was computed with other parameters:"
                "\n  stored: Contact heads/Clearance = 5 mm"
                "\n  stored: Contact heads/Hertz/Exponent = 1.5"
                "\n  given:  Contact heads/Clearance = 9 mm"
                "\n  given:  Contact heads/Hertz/Exponent = 1.4");
}

TEST_F(RunFolderTest, CommentsAreNoDifference) {
  EXPECT_EQ(parameter_differences(parameters, "# a remark\n\n" + parameters), "");
}

TEST_F(RunFolderTest, NothingToResume) {
  EXPECT_EQ(error(ExistingFolder::resume),
            "nothing to resume: " + folder.string() + " holds no parameters.prm");
}

TEST_F(RunFolderTest, OverwriteRemovesOnlyWhatWasWritten) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    RunFolder run(MPI_COMM_SELF, folder, ExistingFolder::refuse, parameters);
    for (const fs::path &file :
         {run.results_file(), run.summary_file(), run.log_file(), run.journal_file(0),
          run.journal_file(12), run.claim("modes/left-mode-001.vtu"), run.claim("modes.pvd"),
          run.claim("release/frame-00001.vtu")})
      write_text(file, "mine");
    write_text(folder / "notes.txt", "foreign");
    write_text(folder / "release" / "mine.vtu", "foreign");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  prepare(ExistingFolder::overwrite, "set Title = other\n");
  EXPECT_EQ(text_of(folder / "parameters.prm"), "set Title = other\n");
  EXPECT_EQ(text_of(folder / "notes.txt"), "foreign");
  EXPECT_EQ(text_of(folder / "release" / "mine.vtu"), "foreign");
  std::set<std::string> left;
  for (const auto &entry : fs::recursive_directory_iterator(folder))
    left.insert(fs::relative(entry.path(), folder).string());
  EXPECT_EQ(left, (std::set<std::string>{"journal", "notes.txt", "parameters.prm", "release",
                                         "release/mine.vtu"}));
}

TEST_F(RunFolderTest, AListThatLeadsOutsideIsNotFollowed) {
  const fs::path outside = temporary.path() / "precious.txt";
  write_text(outside, "foreign");
  prepare(ExistingFolder::refuse);
  write_text(folder / "journal" / "written_files.txt",
             "../../precious.txt\n" + outside.string() + "\n");
  MPI_Barrier(MPI_COMM_WORLD);
  prepare(ExistingFolder::overwrite);
  EXPECT_EQ(text_of(outside), "foreign");
}

TEST_F(RunFolderTest, SecondRunAtTheSameTimeIsRefused) {
  const RunFolder first(MPI_COMM_WORLD, folder, ExistingFolder::refuse, parameters);
  EXPECT_EQ(error(ExistingFolder::resume),
            "another run is at work in the result folder " + folder.string());
}

TEST_F(RunFolderTest, UnwritablePlaceNamesFolderAndReason) {
  folder = "/proc/beams";
  const std::string message = thrown_message<InputError>([&] { prepare(ExistingFolder::refuse); });
  EXPECT_EQ(message.rfind("the result folder /proc/beams cannot be used: ", 0), 0U) << message;
  EXPECT_NE(message.find("--output"), std::string::npos) << message;
}

TEST_F(RunFolderTest, JournalsOfAllRanksAreFoundInOrder) {
  const RunFolder run(MPI_COMM_WORLD, folder, ExistingFolder::refuse, parameters);
  for (const int rank : {10, 0, 2})
    write_text(run.journal_file(rank), "");
  write_text(folder / "journal" / "rank-x.journal", "foreign");
  EXPECT_EQ(run.journal_files(), (std::vector<fs::path>{run.journal_file(0), run.journal_file(2),
                                                        run.journal_file(10)}));
  MPI_Barrier(MPI_COMM_WORLD);
}

} // namespace run_folder_tests
} // namespace vibroimpact::output
