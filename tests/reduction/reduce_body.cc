// The stored body of an earlier run, on any number of ranks.
#include "reduction/reduce_body.h"

#include "common/bytes.h"
#include "reduction/body_file.h"
#include "reduction/parameter_files.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace reduce_body_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using namespace vibroimpact::examples;
using vibroimpact::testing::TemporaryFolder;
using vibroimpact::testing::text_of;

namespace {

const std::string store = "set Store = left.body\n";

std::string bytes_of(const ReducedBody &body) { return to_bytes(body, ""); }

} // namespace

TEST(ReduceBody, StoredBodiesAreLoadedByteForByte) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  const std::string text = head_beam(section("Modes", store));
  const std::string computed = bytes_of(reduced_text(text, folder.path()));
  const std::string file = text_of(folder.path() / "left.body");
  const std::string loaded = bytes_of(reduced_text(text, folder.path()));
  EXPECT_EQ(loaded, computed);
  EXPECT_EQ(text_of(folder.path() / "left.body"), file);
  EXPECT_EQ(computed, broadcast(computed, MPI_COMM_WORLD));
}

// A stored body with another name in it proves that the file was used.
TEST(ReduceBody, TheStoredBodyIsTheOneUsed) {
  const TemporaryFolder folder;
  const std::string text = head_beam(section("Modes", store));
  ReducedBody body = reduced_text(text, folder.path(), MPI_COMM_SELF);
  body.name = "from the file";
  const std::string fingerprint =
      body_values(text).fingerprint() + "mesh = " + content_hash("") + "\n";
  save_body((folder.path() / "left.body").string(), body, fingerprint);
  EXPECT_EQ(reduced_text(text, folder.path(), MPI_COMM_SELF).name, "from the file");
}

TEST(ReduceBody, AnotherDefinitionIsComputedAnew) {
  const TemporaryFolder folder;
  reduced_text(head_beam(section("Modes", store)), folder.path(), MPI_COMM_SELF);
  const std::string changed = head_beam(section("Modes", store + "set Number = 3\n"));
  EXPECT_EQ(reduced_text(changed, folder.path(), MPI_COMM_SELF).size(), 3);
}

TEST(ReduceBody, DamagedFilesAreComputedAnewAndReplaced) {
  const TemporaryFolder folder;
  const std::string text = head_beam(section("Modes", store));
  const std::string file = (folder.path() / "left.body").string();
  const std::string computed = bytes_of(reduced_text(text, folder.path(), MPI_COMM_SELF));
  const std::string content = text_of(file);
  std::ofstream(file, std::ios::binary) << content.substr(0, content.size() / 2);
  EXPECT_EQ(bytes_of(reduced_text(text, folder.path(), MPI_COMM_SELF)).size(), computed.size());
  EXPECT_EQ(text_of(file).size(), content.size());
}

TEST(ReduceBody, AStoreThatCannotBeWrittenIsRefusedOnEveryRank) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  const std::string text = head_beam(section("Modes", "set Store = none/left.body\n"));
  try {
    reduced_text(text, folder.path());
    FAIL();
  } catch (const InputError &error) {
    EXPECT_NE(std::string(error.what()).find("Store"), std::string::npos) << error.what();
  }
}

namespace {

/// The body by way of a cache.
ReducedBody by_cache(const std::string &text, const BodyCache &cache,
                     MPI_Comm communicator = MPI_COMM_SELF) {
  return reduce_body(body_values(text), "left", ".", communicator, cache);
}

std::vector<std::filesystem::path> entries(const std::filesystem::path &folder) {
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  return files;
}

} // namespace

TEST(ReduceBody, TheCacheGivesTheSameBytes) {
  const TemporaryFolder folder(MPI_COMM_WORLD);
  const BodyCache cache{.folder = folder.path() / "bodies", .program = "1"};
  const std::string without = bytes_of(reduced_text(head_beam(), "."));
  EXPECT_EQ(bytes_of(by_cache(head_beam(), cache, MPI_COMM_WORLD)), without);
  const std::string entry = text_of(entries(cache.folder).at(0));
  EXPECT_EQ(bytes_of(by_cache(head_beam(), cache, MPI_COMM_WORLD)), without);
  EXPECT_EQ(entries(cache.folder).size(), 1U);
  EXPECT_EQ(text_of(entries(cache.folder).at(0)), entry);
}

// An entry with other contents proves that it was used, and under whose name it goes.
TEST(ReduceBody, AnEntryOfTheCacheIsUsed) {
  const TemporaryFolder folder;
  const BodyCache cache{.folder = folder.path(), .program = "1"};
  ReducedBody body = by_cache(head_beam(), cache);
  body.name = "another name";
  body.total_mass.setConstant(42);
  const std::string file = entries(folder.path()).at(0).string();
  const std::string bytes = text_of(file);
  Cursor cursor(std::string_view(bytes).substr(bytes.find('\n') + 1 + content_hash("").size()));
  save_body(file, body, cursor.take<std::string>());
  const ReducedBody again = by_cache(head_beam(), cache);
  EXPECT_EQ(again.total_mass[0], 42);
  EXPECT_EQ(again.name, "left");
}

TEST(ReduceBody, OtherBodiesAndProgramsHaveOtherEntries) {
  const TemporaryFolder folder;
  by_cache(head_beam(), {.folder = folder.path(), .program = "1"});
  by_cache(head_beam(section("Modes", "set Number = 3\n")),
           {.folder = folder.path(), .program = "1"});
  by_cache(head_beam(), {.folder = folder.path(), .program = "2"});
  EXPECT_EQ(entries(folder.path()).size(), 3U);
}

TEST(ReduceBody, DamagedEntriesOfTheCacheAreMadeAnew) {
  const TemporaryFolder folder;
  const BodyCache cache{.folder = folder.path(), .program = "1"};
  const std::string sound = bytes_of(by_cache(head_beam(), cache));
  const std::string file = entries(folder.path()).at(0).string();
  const std::string bytes = text_of(file);
  std::string flipped = bytes;
  flipped[bytes.size() / 2] ^= 1;
  for (const std::string &damaged : {std::string(), bytes.substr(0, bytes.size() / 2), flipped}) {
    std::ofstream(file, std::ios::binary) << damaged;
    EXPECT_EQ(bytes_of(by_cache(head_beam(), cache)), sound);
    EXPECT_EQ(text_of(file), bytes);
  }
}

TEST(ReduceBody, ACacheThatCannotBeWrittenCostsNotTheRun) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "file").string();
  std::ofstream(file) << "in the way";
  const BodyCache cache{.folder = file + "/bodies", .program = "1"};
  EXPECT_EQ(bytes_of(by_cache(head_beam(), cache)),
            bytes_of(reduced_text(head_beam(), ".", MPI_COMM_SELF)));
}

TEST(ReduceBody, WithoutACacheNothingIsKept) {
  const TemporaryFolder folder;
  by_cache(head_beam(), {});
  EXPECT_TRUE(entries(folder.path()).empty());
}

} // namespace reduce_body_tests
