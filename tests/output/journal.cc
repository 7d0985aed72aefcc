#include "output/journal.h"

#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace vibroimpact::output {
namespace journal_tests {

using testing::TemporaryFolder;
using testing::text_of;
using testing::thrown_message;
using testing::write_text;

std::vector<std::string> records_of(const std::filesystem::path &file) {
  std::vector<std::string> records;
  JournalRecords(file).visit([&](std::string_view payload) { records.emplace_back(payload); });
  return records;
}

class JournalTest : public ::testing::Test {
protected:
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "rank-00000.journal";
};

TEST_F(JournalTest, GivesBackItsRecords) {
  const std::vector<std::string> records = {"first", "", std::string(100000, 'z'), "l\0st"};
  for (const std::string &record : records)
    JournalWriter(file).append(record);
  EXPECT_EQ(records_of(file), records);
}

TEST_F(JournalTest, MissingFileIsEmpty) { EXPECT_TRUE(records_of(file).empty()); }

TEST_F(JournalTest, ReadsUpToTheLastCompleteRecordWhereverItIsTorn) {
  const std::vector<std::string> records = {"first", "second one", "x", ""};
  std::vector<std::size_t> ends = {0};
  for (const std::string &record : records) {
    JournalWriter(file).append(record);
    ends.push_back(std::filesystem::file_size(file));
  }
  const std::string whole = text_of(file);
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    write_text(file, whole.substr(0, size));
    std::size_t complete = 0;
    while (complete < records.size() && ends[complete + 1] <= size)
      ++complete;
    const std::vector<std::string> expected(records.begin(),
                                            records.begin() + static_cast<long>(complete));
    EXPECT_EQ(records_of(file), expected) << "torn at byte " << size;
    JournalWriter(file).append("after");
    std::vector<std::string> continued = expected;
    continued.push_back("after");
    EXPECT_EQ(records_of(file), continued) << "resumed after byte " << size;
  }
}

TEST_F(JournalTest, StopsAtEveryDamagedByte) {
  JournalWriter(file).append("intact");
  const std::size_t end = std::filesystem::file_size(file);
  JournalWriter(file).append("damaged");
  const std::string whole = text_of(file);
  for (std::size_t position = end; position < whole.size(); ++position) {
    std::string damaged = whole;
    damaged[position] = static_cast<char>(damaged[position] ^ 0x10);
    write_text(file, damaged);
    EXPECT_EQ(records_of(file), std::vector<std::string>{"intact"}) << "byte " << position;
  }
}

TEST_F(JournalTest, RecordsAreThoseThereWereWhenItWasOpened) {
  JournalWriter journal(file);
  journal.append("first");
  const std::size_t whole = std::filesystem::file_size(file);
  journal.append("second");
  const JournalRecords both(file);
  EXPECT_EQ(both.size(), std::filesystem::file_size(file));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  const JournalRecords one(file);
  EXPECT_EQ(one.size(), whole);
  JournalWriter(file).append("third");
  std::vector<std::string> records;
  one.visit([&](std::string_view payload) { records.emplace_back(payload); });
  EXPECT_EQ(records, std::vector<std::string>{"first"});
}

// Longer than the disk is left alone: some appends find the synchronisation before still going on.
TEST_F(JournalTest, GoesOnWhileTheDiskIsBusy) {
  std::vector<std::string> records;
  {
    JournalWriter journal(file);
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(700);
    while (std::chrono::steady_clock::now() < end) {
      journal.append(records.emplace_back(std::to_string(records.size())));
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    EXPECT_EQ(records_of(file), records);
    journal.synchronise();
  }
  EXPECT_EQ(records_of(file), records);
}

TEST_F(JournalTest, ZerosAreNoRecord) {
  JournalWriter(file).append("intact");
  write_text(file, text_of(file) + std::string(64, '\0'));
  EXPECT_EQ(records_of(file), std::vector<std::string>{"intact"});
}

TEST_F(JournalTest, FullDiskNamesPathAndReason) {
  std::filesystem::create_symlink("/dev/full", file);
  JournalWriter journal(file);
  const std::string message = thrown_message<std::runtime_error>([&] { journal.append("x"); });
  EXPECT_EQ(message, file.string() + ": cannot write: No space left on device");
}

TEST_F(JournalTest, UnwritableFolderNamesPathAndReason) {
  const std::filesystem::path nowhere = "/proc/rank-00000.journal"; // not even root may write
  const std::string message =
      thrown_message<std::runtime_error>([&] { JournalWriter writer(nowhere); });
  EXPECT_EQ(message.rfind(nowhere.string() + ": cannot open the file for writing: ", 0), 0U)
      << message;
}

} // namespace journal_tests
} // namespace vibroimpact::output
