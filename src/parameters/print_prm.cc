#include "parameters/echo.h"
#include "parameters/print_formats.h"
#include "parameters/text.h"

#include <sstream>

namespace vibroimpact::parameters {

namespace {

const std::size_t comment_length = 96;

std::string comment(const std::string &text, int depth) {
  const std::string begin = std::string(2 * static_cast<std::size_t>(depth), ' ') + "#";
  std::string result;
  std::string line = begin;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() + word.size() > comment_length && line != begin) {
      result += line + "\n";
      line = begin;
    }
    line += " " + word;
  }
  return line == begin ? result : result + line + "\n";
}

std::string key_comment(const Key &key) {
  std::string text = key.sentence + " [" + unit_or_kind(key) + "]";
  if (!limits(key).empty())
    text += " " + limits(key) + ".";
  if (key.required)
    text += key.required_when.empty() ? " Required." : " Required when " + key.required_when + ".";
  if (!key.options.empty())
    text += " One of: " + join(key.options, ", ") + ".";
  return text;
}

void write_declared_content(const Section &section, int depth, std::string &text);

void write_declared_section(const Section &section, const std::string &title, int depth,
                            std::string &text) {
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  text += "\n" + comment(section.sentence(), depth) + indent + "subsection " + title + "\n";
  write_declared_content(section, depth + 1, text);
  text += indent + "end\n";
}

void write_declared_content(const Section &section, int depth, std::string &text) {
  for (const Key &key : section.keys())
    text += comment(key_comment(key), depth) +
            assignment(depth, key.name, name_width(section), key.default_value, "");
  for (const auto &subsection : section.subsections())
    write_declared_section(*subsection, subsection->name(), depth, text);
  for (const auto &kind : section.named_subsections())
    write_declared_section(*kind, kind->name() + " NAME", depth, text);
}

} // namespace

std::string print_prm(const Section &declarations) {
  std::string text = comment(declarations.sentence(), 0);
  write_declared_content(declarations, 0, text);
  return text;
}

} // namespace vibroimpact::parameters
