// Input that cannot be used: every message names the place, the key, its value and what is allowed.
//
// The tables in broken/ hold files without and with mistakes:
//
//   [sound]                    a file that is accepted, up to the next bracket
//   [other of sound]           another one, made of it by the changes and lines that follow
//   [mistakes in sound, other] one mistake a line, and what the message must say:
//   FROM => TO | WORDS | WORDS         FROM, where it first occurs, is replaced
//   FROM +> LINES && FROM <+ LINES     lines behind and before, several changes
//   FROM => TO | == MESSAGE            the whole message
//
// Line breaks in an entry are written as \n. The indentation of lines counts nowhere.
#include "common/hdf5_file.h"
#include "parameters/text.h"
#include "support/simulation_files.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>

namespace vibroimpact {
namespace broken_input_tests {

using testing::changed;
using testing::message_of;
using Texts = std::vector<std::string>;

Texts split(const std::string &text, const std::string &separator) {
  Texts parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find(separator, begin)) != std::string::npos;
       begin = end + separator.size())
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

std::string trimmed(const std::string &text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::string without_indentation(const std::string &text, const std::string &line_break) {
  Texts lines = split(text, line_break);
  std::transform(lines.begin(), lines.end(), lines.begin(), trimmed);
  return parameters::join(lines, "\n");
}

std::string with_breaks(const std::string &text) { return without_indentation(text, "\\n"); }

/// The changes of an entry.
std::string changed_by(std::string text, const std::string &entry) {
  for (const std::string &change : split(entry, " && ")) {
    const std::size_t sign =
        std::min({change.find(" =>"), change.find(" +> "), change.find(" <+ ")});
    if (sign == std::string::npos) {
      text += trimmed(change) + "\n";
      continue;
    }
    const std::string from = with_breaks(change.substr(0, sign));
    const std::string lines = with_breaks(change.substr(sign + 3));
    const char kind = change[sign + 1];
    text = changed(text, from,
                   kind == '='   ? lines
                   : kind == '+' ? from + "\n" + lines
                                 : lines + "\n" + from);
  }
  return text;
}

/// `mistake`: a line of a table.
void expect_refused(const std::string &sound, const std::string &mistake) {
  const Texts words = split(mistake, " | ");
  const std::string message = message_of(changed_by(sound, words[0]));
  ASSERT_NE(message, "") << "accepted";
  ASSERT_GT(words.size(), 1U) << "a mistake without words";
  for (const std::string &word : std::span(words).subspan(1))
    if (word.starts_with("== "))
      EXPECT_EQ(without_indentation(message, "\n"), with_breaks(word.substr(3)));
    else
      EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in:\n" << message;
  EXPECT_EQ(message.find("Stacktrace"), std::string::npos);
  EXPECT_LT(message.size(), 1500U);
  EXPECT_LE(std::count(message.begin(), message.end(), '\n'), 2) << message;
}

/// One table, taken line by line.
class Table {
public:
  void take(const std::string &line) {
    if (line.starts_with("["))
      begin(line.substr(1, line.size() - 2));
    else if (!line.starts_with("#"))
      for (const std::string &name : names_)
        mistakes_ ? expect_refused(files_.at(name), line)
                  : void(files_.at(name) = changed_by(files_.at(name), line));
  }
  void expect_files_accepted() const {
    for (const auto &[name, text] : files_)
      EXPECT_EQ(message_of(text), "") << "of the file " << name;
  }

private:
  void begin(const std::string &head) {
    mistakes_ = head.starts_with("mistakes in ");
    names_ = mistakes_ ? split(head.substr(12), ", ") : split(head, " of ");
    if (mistakes_)
      return;
    files_[names_[0]] = names_.size() > 1 ? files_.at(names_[1]) : "";
    names_.resize(1);
  }

  std::map<std::string, std::string> files_;
  Texts names_; ///< of the files that lines belong to
  bool mistakes_ = false;
};

/// The files that tables name, in the present folder.
void write_files() {
  const auto write = [](const char *name, const char *text) { std::ofstream(name) << text; };
  std::filesystem::create_directory_symlink(VIBROIMPACT_SOURCE_DIR "/meshes", "meshes");
  write("modes.csv",
        "mode,frequency,damping ratio,tip.z,middle.z\n1,10,0.01,2,1\n2,60,0.01,-2,1\n");
  write("empty.csv", "");
  write("quake.csv", "t,a\n0,1\n1,2\n2,3\n");
  write("text.csv", "t,a\n0,1\n1,2\n2,x\n");
  write("text.h5", "no HDF5");
  Hdf5File modes = Hdf5File::create("modes.h5");
  for (const std::string body : {"/body/one/", "/body/two/"}) {
    modes.write(body + "frequency", {2}, std::vector<double>{10, 60});
    modes.set_attribute(body + "frequency", "unit", body == "/body/one/" ? "Hz" : "1");
    modes.write(body + "damping_ratio", {2}, std::vector<double>{0.01, 0.01});
    modes.write(body + "mass", {2}, std::vector<double>{1, 1});
    modes.write(body + "point", {1}, std::vector<std::string>{"tip"});
  }
  modes.write("/body/one/point_rows", {1, 3, 2}, std::vector<double>(6, 1));
  modes.close();
  std::filesystem::create_directory("states");
  Hdf5File states = Hdf5File::create("states/results.h5");
  states.write("/analysis/sweep/state", {3, 2}, std::vector<double>{1, 2, 3, 4, std::nan(""), 6});
  states.write("/analysis/one/state", {2}, std::vector<double>{1, 2});
  states.write("/analysis/other/state", {3}, std::vector<double>{1, 2, 3});
  states.close();
}

class BrokenInputTest : public ::testing::TestWithParam<std::filesystem::path> {
protected:
  static void SetUpTestSuite() {
    std::filesystem::current_path(folder.emplace().path());
    write_files();
  }
  static void TearDownTestSuite() {
    std::filesystem::current_path(before);
    folder.reset(); // all ranks meet there, before MPI ends
  }

private:
  inline static std::optional<testing::TemporaryFolder> folder;
  inline static const std::filesystem::path before = std::filesystem::current_path();
};

TEST_P(BrokenInputTest, IsRefusedWithOneClearMessage) {
  Table table;
  std::ifstream file(GetParam());
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    SCOPED_TRACE(GetParam().filename().string() + ":" + std::to_string(++number));
    table.take(line);
  }
  table.expect_files_accepted();
}

std::vector<std::filesystem::path> tables() {
  const std::filesystem::path folder(VIBROIMPACT_SOURCE_DIR "/tests/simulation/broken");
  std::vector<std::filesystem::path> files{std::filesystem::directory_iterator(folder), {}};
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Tables, BrokenInputTest, ::testing::ValuesIn(tables()),
                         [](const auto &info) { return info.param.stem().string(); });

TEST(BrokenInputOverrideTest, IsNamed) {
  const std::string file = R"(subsection Body block
  set Type = lumped
  subsection Mass head
    set Mass = 2 kg
  end
end
)";
  const std::string message =
      message_of(file, {{.path = "Body/block/Mass/head/Mass", .value = "5 m", .origin = "--set"}});
  EXPECT_NE(message.find("--set Body/block/Mass/head/Mass=5 m"), std::string::npos) << message;
}

} // namespace broken_input_tests
} // namespace vibroimpact
