#include "structure/gmsh_data.h"

#include "structure/beam_definition.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace vibroimpact::structure {

void fail_mesh(const std::string &problem) {
  throw DefinitionError("Geometry", "", "Mesh", problem);
}

GmshData::GmshData(std::string section, const std::string &content, bool binary)
    : section_(std::move(section)), in_(content, std::ios::binary | std::ios::in), binary_(binary) {
}

void GmshData::broken() const {
  fail_mesh("must be a complete Gmsh file, but its section $" + section_ +
            " breaks off or is damaged");
}

template <class T> T GmshData::bytes() {
  T value{};
  if (!in_.read(reinterpret_cast<char *>(&value), sizeof value))
    broken();
  return value;
}

int GmshData::integer() {
  return binary_ ? bytes<std::int32_t>() : static_cast<int>(text_integer());
}

std::size_t GmshData::count() { return binary_ ? bytes<std::uint64_t>() : text_count(); }

double GmshData::real() {
  double value = 0;
  if (binary_) {
    value = bytes<double>();
  } else {
    const std::string word = text_word();
    char *end = nullptr;
    value = std::strtod(word.c_str(), &end);
    if (*end != '\0')
      broken();
  }
  if (!std::isfinite(value))
    broken();
  return value;
}

Vector3 GmshData::vector() {
  const double x = real();
  const double y = real();
  return {x, y, real()};
}

long GmshData::text_integer() {
  long value = 0;
  if (!(in_ >> value))
    broken();
  return value;
}

std::size_t GmshData::text_count() {
  const long number = text_integer();
  if (number < 0)
    broken();
  return static_cast<std::size_t>(number);
}

std::string GmshData::text_word() {
  std::string word;
  if (!(in_ >> word))
    broken();
  return word;
}

std::string GmshData::quoted() {
  std::string skipped;
  std::string text;
  if (!std::getline(in_, skipped, '"') || !std::getline(in_, text, '"'))
    broken();
  return text;
}

void GmshData::end_line() {
  std::string rest;
  std::getline(in_, rest);
}

GmshFile::GmshFile(const std::string &content) {
  split(content);
  read_format();
}

// The end of a section is found by its name, so that binary data is not mistaken for lines.
void GmshFile::split(const std::string &content) {
  std::size_t position = 0;
  while (position < content.size()) {
    const std::size_t line_end = std::min(content.find('\n', position), content.size());
    std::string line = content.substr(position, line_end - position);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    position = line_end + 1;
    if (line.empty() || line.front() != '$')
      continue;
    const std::string name = line.substr(1);
    const std::size_t end = content.find("$End" + name, position);
    if (end == std::string::npos)
      fail_mesh("must be a complete Gmsh file, but its section $" + name + " does not end");
    sections_[name] += content.substr(position, end - position);
    position = std::min(content.find('\n', end), content.size()) + 1;
  }
}

void GmshFile::read_format() {
  if (!has("MeshFormat"))
    fail_mesh("must be a Gmsh file (.msh), but has no section $MeshFormat");
  GmshData format("MeshFormat", sections_.at("MeshFormat"), true);
  version_ = format.text_word();
  binary_ = format.text_integer() != 0;
  if (version_ != "2.2" && version_ != "4.1")
    fail_mesh("must be a Gmsh file of version 2.2 or 4.1, but is " + version_);
  if (format.text_integer() != 8)
    fail_mesh("must be a Gmsh file with numbers of 8 bytes");
  format.end_line();
  if (binary_ && format.integer() != 1)
    fail_mesh("must be a binary Gmsh file in the byte order of this machine (or an ASCII one)");
}

GmshData GmshFile::section(const std::string &name) const {
  const auto found = sections_.find(name);
  if (found == sections_.end())
    fail_mesh("must be a Gmsh file, but has no section $" + name);
  return {name, found->second, binary_};
}

} // namespace vibroimpact::structure
