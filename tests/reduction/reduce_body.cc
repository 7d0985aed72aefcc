// The stored body of an earlier run, on any number of ranks.
#include "reduction/reduce_body.h"

#include "reduction/body_file.h"
#include "reduction/parameter_files.h"
#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace vibroimpact;
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
