#include "parameters/scanned_file.h"
#include "parameters/text.h"

// Without this Boost 1.74 prints a message about its own use of the placeholders.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>

#include <sstream>

namespace vibroimpact::parameters {

namespace {

using Tree = boost::property_tree::ptree;

/// The reader of the library calls itself for each level of brackets.
void check_depth(const std::string &text, const std::string &name) {
  constexpr int deepest = 50;
  int depth = 0;
  int line = 1;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    line += c == '\n' ? 1 : 0;
    i += quoted && c == '\\' ? 1 : 0; // the next character is part of the string
    quoted = quoted != (c == '"');
    depth += quoted ? 0 : c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (depth > deepest)
      refuse_place({.source = name, .line = line}, {}, "brackets nest more than 50 deep");
  }
}

Tree parsed(const std::string &text, const std::string &name) {
  check_depth(text, name);
  Tree tree;
  std::istringstream stream(text);
  try {
    boost::property_tree::read_json(stream, tree);
  } catch (const boost::property_tree::json_parser_error &error) {
    refuse_place({.source = name, .line = static_cast<int>(error.line())}, {},
                 "this is not valid JSON: " + error.message());
  }
  return tree;
}

class JsonScanner {
public:
  explicit JsonScanner(std::string file) : file_(std::move(file)) {}

  void scan_object(const Tree &object, ScannedEntry &section) {
    for (const auto &[name, child] : object) {
      path_.push_back(name);
      section.entries.push_back(scan_entry(name, child));
      path_.pop_back();
    }
  }

private:
  ScannedEntry scan_entry(const std::string &name, const Tree &child) {
    ScannedEntry entry{.name = name,
                       .value = normalised(child.data()),
                       .origin = {.kind = Origin::Kind::json, .source = file_, .order = order_++}};
    entry.kind = kind_of(child);
    if (!is_plain_text(name) || !is_plain_text(child.data()))
      refuse_place(entry.origin, {},
                   "a key or value holds a character that is no text, such as a "
                   "NUL byte or a letter in another encoding than UTF-8");
    if (child.data().find_first_of("#\n\r") != std::string::npos || entry.value.ends_with('\\'))
      refuse_value(entry.origin, path_, entry.value,
                   "a value may not hold '#' or a line break, nor end in '\\'");
    if (entry.kind == ScannedEntry::Kind::section)
      scan_object(child, entry);
    return entry;
  }

  /// The property tree keeps the elements of an array as children without a name.
  static ScannedEntry::Kind kind_of(const Tree &child) {
    if (!child.data().empty())
      return ScannedEntry::Kind::key;
    if (child.empty())
      return ScannedEntry::Kind::empty;
    return child.front().first.empty() ? ScannedEntry::Kind::array : ScannedEntry::Kind::section;
  }

  std::string file_;
  std::vector<std::string> path_;
  int order_ = 0;
};

} // namespace

ScannedEntry scan_json(const std::string &text, const std::string &name) {
  const Tree tree = parsed(text, name);
  ScannedEntry file{.name = {}, .origin = {.kind = Origin::Kind::json, .source = name}};
  if (!tree.data().empty() || (!tree.empty() && tree.front().first.empty()))
    refuse_place(file.origin, {}, "the file must hold one object: { \"KEY\": \"VALUE\", ... }");
  JsonScanner(name).scan_object(tree, file);
  return file;
}

} // namespace vibroimpact::parameters
