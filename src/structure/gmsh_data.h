// The sections of a Gmsh mesh file and the numbers in them, text or binary alike.
#pragma once

#include "common/linear_algebra.h"

#include <map>
#include <sstream>
#include <string>

namespace vibroimpact::structure {

/// Throws the DefinitionError of the key Mesh.
[[noreturn]] void fail_mesh(const std::string &problem);

/// The numbers of one section, one after the other. Running out of them or meeting something else
/// is a damaged file: a DefinitionError.
class GmshData {
public:
  GmshData(std::string section, const std::string &content, bool binary);

  int integer();       ///< 4 bytes
  std::size_t count(); ///< 8 bytes, not negative
  double real();       ///< 8 bytes, finite
  Vector3 vector();
  /// These are text in binary files too.
  long text_integer();
  std::size_t text_count();
  std::string text_word();
  std::string quoted();
  /// Skips the rest of a line of text; binary data begins after it.
  void end_line();

  [[noreturn]] void broken() const;

private:
  template <class T> T bytes();

  std::string section_;
  std::istringstream in_;
  bool binary_;
};

class GmshFile {
public:
  /// Throws DefinitionError for files that are not of version 2.2 or 4.1, or of another byte order.
  explicit GmshFile(const std::string &content);

  const std::string &version() const { return version_; }
  bool binary() const { return binary_; }
  bool has(const std::string &section) const { return sections_.contains(section); }
  /// Throws DefinitionError when there is no such section.
  GmshData section(const std::string &name) const;

private:
  void split(const std::string &content);
  void read_format();

  std::map<std::string, std::string> sections_;
  std::string version_;
  bool binary_ = false;
};

} // namespace vibroimpact::structure
