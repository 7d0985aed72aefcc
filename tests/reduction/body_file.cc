#include "reduction/body_file.h"

#include "common/error.h"
#include "reduction/beam_bodies.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace body_file_tests {

using namespace vibroimpact;
using namespace vibroimpact::reduction;
using vibroimpact::testing::TemporaryFolder;

namespace {

const ReducedBody &example() {
  static const ReducedBody body =
      reduce(examples::body_of(examples::square_beam(5), 6), MPI_COMM_SELF);
  return body;
}

std::string refusal(const std::string &bytes, const std::string &fingerprint) {
  std::string reason;
  EXPECT_FALSE(from_bytes(bytes, fingerprint, reason));
  return reason;
}

} // namespace

TEST(BodyFile, RoundTripKeepsEveryByte) {
  const std::string bytes = to_bytes(example(), "print");
  std::string reason;
  const auto copy = from_bytes(bytes, "print", reason);
  ASSERT_TRUE(copy) << reason;
  EXPECT_EQ(to_bytes(*copy, "print"), bytes);
  EXPECT_EQ(copy->recovery.shapes, example().recovery.shapes);
  EXPECT_EQ(copy->recovery.lines, example().recovery.lines);
  EXPECT_EQ(copy->points[0].rows, example().points[0].rows);
  EXPECT_EQ(copy->damping, example().damping);
}

TEST(BodyFile, AnotherFingerprintIsRefused) {
  EXPECT_NE(refusal(to_bytes(example(), "one"), "other").find("another definition"),
            std::string::npos);
}

TEST(BodyFile, AnyDamagedByteIsRefused) {
  const std::string bytes = to_bytes(example(), "print");
  for (std::size_t i = 0; i < bytes.size(); i += 97) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_NE(refusal(damaged, "print"), "") << i;
  }
}

TEST(BodyFile, AnyShorterFileIsRefused) {
  const std::string bytes = to_bytes(example(), "print");
  for (std::size_t size = 0; size < bytes.size(); size += 101)
    EXPECT_NE(refusal(bytes.substr(0, size), "print"), "") << size;
}

TEST(BodyFile, SavedFilesAreCompleteAndAlone) {
  const TemporaryFolder folder;
  save_body((folder.path() / "left.body").string(), example(), "print");
  save_body((folder.path() / "left.body").string(), example(), "print");
  EXPECT_EQ(read_file((folder.path() / "left.body").string()), to_bytes(example(), "print"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(BodyFile, FoldersThatDoNotExistAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THROW(save_body((folder.path() / "none/left.body").string(), example(), ""), InputError);
  EXPECT_FALSE(read_file((folder.path() / "none/left.body").string()));
}

// Published values of the 64-bit FNV-1a hash.
TEST(BodyFile, ContentHashIsFnv1a) {
  EXPECT_EQ(content_hash(""), "cbf29ce484222325");
  EXPECT_EQ(content_hash("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(content_hash("foobar"), "85944171f73967e8");
}

} // namespace body_file_tests
