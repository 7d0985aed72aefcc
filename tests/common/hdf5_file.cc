#include "common/hdf5_file.h"

#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>
#include <hdf5.h>

namespace vibroimpact {
namespace hdf5_file_tests {

using testing::TemporaryFolder;
using testing::thrown_message;

class Hdf5FileTest : public ::testing::Test {
protected:
  TemporaryFolder folder;
  std::filesystem::path name = folder.path() / "a.h5";
};

TEST_F(Hdf5FileTest, GivesBackWhatWasWritten) {
  Hdf5File file = Hdf5File::create(name);
  file.write("/a/b/numbers", {2, 3}, std::vector<double>{1, 2, 3, 4, 5, 6.5});
  file.write("/a/b/whole", {2}, std::vector<std::int64_t>{-7, 8});
  file.write("/a/words", {3}, std::vector<std::string>{"één", "", "three words here"});
  file.write("/scalar", {}, std::vector<double>{3.5});
  file.set_attribute("/a/b/numbers", "unit", "m/s^2");
  file.set_attribute("/", "version", "1.2");
  file.close();

  const Hdf5File again = Hdf5File::open(name);
  EXPECT_EQ(again.shape("/a/b/numbers"), (Shape{2, 3}));
  EXPECT_EQ(again.read_numbers("/a/b/numbers"), (std::vector<double>{1, 2, 3, 4, 5, 6.5}));
  EXPECT_EQ(again.read_numbers("/a/b/whole"), (std::vector<double>{-7, 8}));
  EXPECT_EQ(again.read_strings("/a/words"),
            (std::vector<std::string>{"één", "", "three words here"}));
  EXPECT_EQ(again.shape("/scalar"), Shape{});
  EXPECT_EQ(again.read_numbers("/scalar"), std::vector<double>{3.5});
  EXPECT_EQ(again.read_attribute("/a/b/numbers", "unit"), "m/s^2");
  EXPECT_EQ(again.read_attribute("/", "version"), "1.2");
}

TEST_F(Hdf5FileTest, ListsMembersInTheOrderOfWriting) {
  Hdf5File file = Hdf5File::create(name);
  for (const char *path : {"/g/zeta", "/g/alpha", "/g/middle/x"})
    file.write(path, {}, std::vector<double>{0});
  EXPECT_EQ(file.members("/g"), (std::vector<std::string>{"zeta", "alpha", "middle"}));
  EXPECT_TRUE(file.is_group("/g/middle"));
  EXPECT_FALSE(file.is_group("/g/zeta"));
  EXPECT_TRUE(file.contains("/g/middle/x"));
  EXPECT_FALSE(file.contains("/g/nothing/x"));
}

TEST_F(Hdf5FileTest, KeepsEmptyArrays) {
  Hdf5File file = Hdf5File::create(name);
  file.write("/none", {0}, std::vector<double>{});
  file.write("/no_words", {2, 0}, std::vector<std::string>{});
  file.set_attribute("/none", "names", std::vector<std::string>{});
  EXPECT_EQ(file.shape("/no_words"), (Shape{2, 0}));
  EXPECT_TRUE(file.read_numbers("/none").empty());
}

TEST_F(Hdf5FileTest, HoldsLongAttributes) {
  const std::string echo(200000, 'x'); // above the 64 kB of a plain attribute
  Hdf5File file = Hdf5File::create(name);
  file.set_attribute("/", "parameters", echo);
  file.close();
  EXPECT_EQ(Hdf5File::open(name).read_attribute("/", "parameters"), echo);
}

TEST_F(Hdf5FileTest, OneScaleServesManyDatasets) {
  constexpr int datasets = 6000; // the list of users is then longer than 64 kB
  Hdf5File file = Hdf5File::create(name);
  file.write("/x", {1}, std::vector<double>{0});
  file.make_scale("/x");
  for (int i = 0; i < datasets; ++i) {
    const std::string path = "/y" + std::to_string(i);
    file.write(path, {1}, std::vector<double>{0});
    file.attach_scale(path, 0, "/x");
  }
  file.close();
  EXPECT_EQ(Hdf5File::open(name).members("/").size(), 1U + datasets);
}

TEST_F(Hdf5FileTest, IsTheSameWhenWrittenAgain) {
  const auto write = [](const std::filesystem::path &file_name) {
    Hdf5File file = Hdf5File::create(file_name);
    file.write("/g/x", {2}, std::vector<double>{1, 2});
    file.make_scale("/g/x");
    file.write("/g/y", {2}, std::vector<double>{3, 4});
    file.attach_scale("/g/y", 0, "/g/x");
    file.write("/g/words", {1}, std::vector<std::string>{"word"});
    file.close();
  };
  write(name);
  write(folder.path() / "b.h5");
  EXPECT_EQ(testing::text_of(name), testing::text_of(folder.path() / "b.h5"));
}

TEST_F(Hdf5FileTest, ErrorsNameFileObjectAndReason) {
  const std::string nowhere = folder.path() / "missing" / "a.h5";
  std::string message =
      thrown_message<std::runtime_error>([&] { Hdf5File::create(nowhere).close(); });
  EXPECT_EQ(message, nowhere + ": cannot create the file: No such file or directory");

  message = thrown_message<std::runtime_error>([&] { Hdf5File::create("/dev/full").close(); });
  EXPECT_EQ(message, "/dev/full: cannot write: No space left on device");

  testing::write_text(name, "no hdf5");
  message = thrown_message<std::runtime_error>([&] { Hdf5File::open(name); });
  EXPECT_NE(message.find("a.h5: cannot open the file"), std::string::npos) << message;

  Hdf5File file = Hdf5File::create(name);
  message = thrown_message<std::runtime_error>([&] { file.read_numbers("/g/none"); });
  EXPECT_NE(message.find("/g/none"), std::string::npos) << message;
  file.write("/twice", {}, std::vector<double>{0});
  EXPECT_THROW(file.write("/twice", {}, std::vector<double>{0}), std::runtime_error);
}

// The exception says all: the library prints no stack of errors beside it, even where the program
// opens a file before it makes one.
TEST_F(Hdf5FileTest, ErrorsAreNotPrinted) {
  testing::write_text(name, "no hdf5");
  H5Eset_auto2(H5E_DEFAULT, reinterpret_cast<H5E_auto2_t>(H5Eprint2), stderr);
  ::testing::internal::CaptureStderr();
  EXPECT_THROW(Hdf5File::open(name), std::runtime_error);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// The library must not learn of it: whatever is written after the disk is full, the program lives,
// and the first reason is given when the file is to be complete.
TEST_F(Hdf5FileTest, GoesOnWithAFullDiskUpToTheEnd) {
  std::filesystem::create_symlink("/dev/full", name);
  for (const bool completed : {true, false}) {
    Hdf5File file = Hdf5File::create(name);
    const std::vector<double> many(1000000, 1.5);
    file.write("/x", {many.size()}, std::vector<double>(many.size(), 0.5));
    file.make_scale("/x");
    for (int i = 0; i < 20; ++i) {
      const std::string path = "/group/" + std::to_string(i) + "/y";
      file.write(path, {many.size()}, many);
      file.attach_scale(path, 0, "/x");
      file.set_attribute(path, "description", "a value over x");
    }
    EXPECT_EQ(file.members("/group").size(), 20U);
    EXPECT_EQ(file.read_attribute("/group/7/y", "description"), "a value over x");
    if (completed) {
      EXPECT_EQ(thrown_message<std::runtime_error>([&] { file.close(); }),
                name.string() + ": cannot write: No space left on device");
    }
  }
}

TEST_F(Hdf5FileTest, ValuesMustFillTheShape) {
  Hdf5File file = Hdf5File::create(name);
  EXPECT_THROW(file.write("/x", {2, 2}, std::vector<double>{1, 2, 3}), std::logic_error);
}

} // namespace hdf5_file_tests
} // namespace vibroimpact
