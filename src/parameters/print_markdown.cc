#include "parameters/check_value.h"
#include "parameters/print_formats.h"
#include "parameters/text.h"
#include "parameters/units.h"

#include <cctype>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

std::string escaped(const std::string &text) {
  std::string result;
  for (const char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string code(const std::string &text) { return text.empty() ? "" : "`" + escaped(text) + "`"; }

std::string code_list(const std::vector<std::string> &words) {
  std::vector<std::string> parts;
  parts.reserve(words.size());
  for (const std::string &word : words)
    parts.push_back(code(word));
  return join(parts, ", ");
}

std::string default_of(const Key &key) {
  if (!key.required)
    return code(key.default_value);
  return "**required**" + (key.required_when.empty() ? "" : " when " + escaped(key.required_when));
}

void write_table(const Section &section, std::ostream &out) {
  if (section.keys().empty())
    return;
  out << "\n| Key | Default | Unit | Range / options | Symbol | Meaning |\n"
      << "|---|---|---|---|---|---|\n";
  for (const Key &key : section.keys())
    out << "| " << code(key.name) << " | " << default_of(key) << " | " << escaped(unit_or_kind(key))
        << " | " << (key.options.empty() ? escaped(limits(key)) : code_list(key.options)) << " | "
        << escaped(key.symbol) << " | " << escaped(key.sentence) << " |\n";
}

void write_sections(const Section &section, const std::string &path, int depth, std::ostream &out);

void write_section(const Section &section, const std::string &title, int depth, std::ostream &out) {
  out << "\n" << std::string(std::min(depth, 6), '#') << " " << title << "\n";
  if (!section.sentence().empty())
    out << "\n" << section.sentence() << "\n";
  write_table(section, out);
  write_sections(section, title + " / ", depth + 1, out);
}

void write_sections(const Section &section, const std::string &path, int depth, std::ostream &out) {
  for (const auto &subsection : section.subsections())
    write_section(*subsection, path + subsection->name(), depth, out);
  for (const auto &kind : section.named_subsections())
    write_section(*kind, path + kind->name() + " NAME", depth, out);
}

/// To the heading of a section: as the pages of GitHub name it.
std::string link_to(const std::string &title, const std::string &shown) {
  std::string anchor;
  for (const char c : title)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ' || c == '-')
      anchor += '-';
  return "[" + shown + "](#" + anchor + ")";
}

/// One line for each section of the file, with the sections in it.
void write_contents(const Section &declarations, std::ostream &out) {
  const auto line = [&out](const Section &section, const std::string &title) {
    std::vector<std::string> inner;
    for (const auto &subsection : section.subsections())
      inner.push_back(link_to(title + " / " + subsection->name(), subsection->name()));
    for (const auto &kind : section.named_subsections())
      inner.push_back(link_to(title + " / " + kind->name() + " NAME", kind->name() + " NAME"));
    out << "- " << link_to(title, title) << (inner.empty() ? "" : ": ") << join(inner, ", ")
        << "\n";
  };
  out << "\nSections:\n\n";
  for (const auto &subsection : declarations.subsections())
    line(*subsection, subsection->name());
  for (const auto &kind : declarations.named_subsections())
    line(*kind, kind->name() + " NAME");
}

void write_numbers_help(std::ostream &out) {
  out << "\nA number may carry a unit and be an expression; without a unit it is in SI, except "
         "that "
         "a frequency must say which it is. Units: "
      << code_list(unit_names()) << ", their powers, products and quotients (`N s/m`, `kg/m^3`, "
      << "`N/m^1.5`). Functions: " << code_list(function_names()) << "; constant: `pi`.\n";
}

} // namespace

std::string unit_or_kind(const Key &key) {
  switch (key.kind) {
  case KeyKind::quantity:
  case KeyKind::quantities:
    return si_unit(key.dimension);
  case KeyKind::integer:
    return "whole number";
  case KeyKind::boolean:
    return "true or false";
  case KeyKind::choice:
    return "choice";
  case KeyKind::names:
    return "names";
  case KeyKind::variables:
    return "variables";
  case KeyKind::text:
    break;
  }
  return "text";
}

std::string limits(const Key &key) {
  std::vector<std::string> parts;
  const bool is_number = key.kind == KeyKind::quantity || key.kind == KeyKind::quantities ||
                         key.kind == KeyKind::integer;
  if (is_number && key.range.sentence("") != "any")
    parts.push_back(key.range.sentence(""));
  if (key.kind == KeyKind::quantities)
    parts.push_back(count_sentence(key));
  return join(parts, "; ");
}

std::string print_markdown(const Section &declarations) {
  std::ostringstream out;
  out << "# " << (declarations.name().empty() ? "Parameters" : declarations.name()) << "\n";
  if (!declarations.sentence().empty())
    out << "\n" << declarations.sentence() << "\n";
  write_numbers_help(out);
  write_contents(declarations, out);
  write_table(declarations, out);
  write_sections(declarations, "", 2, out);
  return out.str();
}

} // namespace vibroimpact::parameters
