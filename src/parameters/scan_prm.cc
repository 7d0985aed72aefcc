#include "parameters/scanned_file.h"
#include "parameters/text.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

const std::string default_mark = "default";

struct Line {
  std::string text; ///< continued lines joined, comment removed, normalised
  std::string comment;
  int number; ///< of its first part
};

class LineReader {
public:
  LineReader(const std::string &text, std::string file) : stream_(text), file_(std::move(file)) {}

  bool next(Line &line) {
    std::string raw;
    if (!next_raw(raw))
      return false;
    line.number = number_;
    while (raw.ends_with('\\'))
      continue_line(raw);
    const std::size_t hash = raw.find('#');
    line.text = normalised(raw.substr(0, hash));
    line.comment = hash == std::string::npos ? "" : normalised(raw.substr(hash + 1));
    if (!is_plain_text(line.text))
      refuse_place({.source = file_, .line = line.number}, {},
                   "this line holds a character that is no text, such as a NUL byte or a letter in "
                   "another encoding than UTF-8");
    return true;
  }

private:
  bool next_raw(std::string &raw) {
    if (!std::getline(stream_, raw))
      return false;
    ++number_;
    if (number_ == 1 && raw.starts_with("\xEF\xBB\xBF")) // byte order mark
      raw.erase(0, 3);
    while (!raw.empty() && (raw.back() == ' ' || raw.back() == '\t' || raw.back() == '\r'))
      raw.pop_back();
    return true;
  }

  void continue_line(std::string &raw) {
    raw.back() = ' ';
    const Origin here{.source = file_, .line = number_};
    if (raw.find('#') != std::string::npos)
      refuse_place(here, {}, "a comment cannot be continued by '\\': the next line would be lost");
    std::string more;
    if (!next_raw(more))
      refuse_place(here, {}, "the last line ends in '\\', but no line follows");
    raw += more;
  }

  std::istringstream stream_;
  std::string file_;
  int number_ = 0;
};

/// One set of nested entries, filled from a file and those it includes.
class PrmScanner {
public:
  ScannedEntry scan(const std::string &text, const std::string &name) {
    root_.origin.source = name;
    open_.push_back(&root_);
    scan_file(text, name);
    return std::move(root_);
  }

private:
  void scan_file(const std::string &text, const std::string &name) {
    files_.push_back(name);
    const std::size_t depth = open_.size();
    LineReader reader(text, name);
    for (Line line; reader.next(line);)
      scan_line(line, depth);
    if (open_.size() > depth)
      refuse_place(open_.back()->origin, path_,
                   "this subsection is not closed: its 'end' is missing");
    files_.pop_back();
  }

  void scan_line(const Line &line, std::size_t depth) {
    if (line.text.empty())
      return;
    const std::size_t blank = line.text.find(' ');
    const std::string word = line.text.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : line.text.substr(blank + 1);
    if ((word == "subsection" || word == "SUBSECTION") && !rest.empty())
      begin_section(rest, line);
    else if ((word == "end" || word == "END") && rest.empty())
      end_section(line, depth);
    else if ((word == "set" || word == "SET") && rest.find('=') != std::string::npos)
      set_key(rest, line);
    else if ((word == "include" || word == "INCLUDE") && !rest.empty())
      include(rest, line);
    else
      refuse_line(word, line);
  }

  Origin origin_of(const Line &line) {
    return {.source = files_.back(), .line = line.number, .order = order_++};
  }

  void begin_section(const std::string &name, const Line &line) {
    constexpr std::size_t deepest = 50;
    if (path_.size() == deepest)
      refuse_place(origin_of(line), {}, "subsections nest more than 50 deep");
    ScannedEntry section{.name = name, .origin = origin_of(line)};
    section.marked_as_default = line.comment == default_mark;
    open_.back()->entries.push_back(std::move(section));
    open_.push_back(&open_.back()->entries.back());
    path_.push_back(name);
  }

  void end_section(const Line &line, std::size_t depth) {
    if (open_.size() == depth)
      refuse_place(origin_of(line), {}, "this 'end' closes nothing: no subsection is open here");
    open_.pop_back();
    path_.pop_back();
  }

  void set_key(const std::string &assignment, const Line &line) {
    const std::size_t equals = assignment.find('=');
    ScannedEntry key{.kind = ScannedEntry::Kind::key,
                     .name = normalised(assignment.substr(0, equals)),
                     .value = normalised(assignment.substr(equals + 1)),
                     .origin = origin_of(line)};
    if (key.name.empty())
      refuse_place(key.origin, path_, "a key is missing between 'set' and '='");
    key.marked_as_default = line.comment == default_mark;
    open_.back()->entries.push_back(std::move(key));
  }

  void include(const std::string &file, const Line &line) {
    const std::filesystem::path folder = std::filesystem::path(files_.back()).parent_path();
    const std::string name = (folder / file).string();
    const Origin here = origin_of(line);
    for (const std::string &open : files_)
      if (same_file(open, name))
        refuse_place(here, {}, "the file includes itself: " + chain(name));
    constexpr std::size_t longest_chain = 50;
    if (files_.size() == longest_chain)
      refuse_place(here, {}, "files include each other more than 50 deep");
    if (std::error_code ignored; files_.size() > 1 && !std::filesystem::exists(name, ignored))
      refuse_place(here, {},
                   "the file '" + name + "' does not exist; it is included by way of " +
                       chain(name));
    scan_file(file_content(name, here), name);
  }

  static bool same_file(const std::filesystem::path &a, const std::filesystem::path &b) {
    return a.lexically_normal() == b.lexically_normal();
  }

  /// "a.prm -> b.prm -> LAST"
  std::string chain(const std::string &last) const { return join(files_, " -> ") + " -> " + last; }

  [[noreturn]] void refuse_line(const std::string &word, const Line &line) {
    std::string problem = "'" + line.text + "' cannot be read";
    if (word == "set" || word == "SET")
      problem += ": '=' is missing; write 'set KEY = VALUE'";
    else if (word == "subsection" || word == "SUBSECTION" || word == "include")
      problem += ": a name is missing after it";
    else if (line.text.find('=') != std::string::npos && nearest(word, {"set"}).empty())
      problem += ": 'set' is missing; write 'set " + line.text + "'";
    else
      problem += ": a line is 'subsection NAME', 'set KEY = VALUE', 'include FILE', 'end', or a "
                 "comment that begins with '#'";
    refuse_place(origin_of(line), path_, problem);
  }

  ScannedEntry root_{};
  std::vector<ScannedEntry *> open_; ///< entries are appended only to the innermost open one
  std::vector<std::string> path_;
  std::vector<std::string> files_; ///< from the outermost to the one being read
  int order_ = 0;
};

} // namespace

ScannedEntry scan_prm(const std::string &text, const std::string &name) {
  return PrmScanner().scan(text, name);
}

std::string file_content(const std::string &file, const Origin &origin) {
  const std::vector<std::string> nowhere;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    refuse_place(origin, nowhere, "the file '" + file + "' does not exist");
  if (!std::filesystem::is_regular_file(file, ignored))
    refuse_place(origin, nowhere, "'" + file + "' is not a file");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream)
    refuse_place(origin, nowhere, "the file '" + file + "' cannot be read; check its permissions");
  return content.str();
}

} // namespace vibroimpact::parameters
