// The values of a parameter file: read once, checked whole, then asked for by key in SI units.
#pragma once

#include "common/error.h"
#include "parameters/section.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

class ParameterSet;
struct Node;
struct Value;
struct VariableTable;

/// One section as the file (with overrides and defaults) has it. Cheap to copy; the ParameterSet
/// behind it is shared. Asking for an undeclared key or with the wrong kind is a std::logic_error;
/// asking for the value of an optional key that is empty is the InputError of require(). Lists,
/// names and text may be empty.
class Values {
public:
  double quantity(const std::string &key) const;
  /// For keys of dimension::any, whose unit depends on other keys: refuses another dimension
  /// than `expected` (a bare number is taken as SI).
  double quantity_of(const std::string &key, const Dimension &expected) const;
  std::vector<double> quantities(const std::string &key) const;
  long integer(const std::string &key) const;
  bool boolean(const std::string &key) const;
  std::string choice(const std::string &key) const;
  std::string text(const std::string &key) const;
  std::vector<std::string> names(const std::string &key) const;

  /// The dimension found, for keys of dimension::any; none for a bare number, which is SI.
  std::optional<Dimension> dimension(const std::string &key) const;
  /// reject() unless every number of the key may have this dimension.
  void require_dimension(const std::string &key, const Dimension &expected) const;
  /// A number that stands inside a text value ("rectangle, 30 mm, 0.75 mm"), in SI; variables and
  /// expressions work as everywhere. reject()s a part of the wrong dimension or range.
  double part(const std::string &key, const std::string &part, const Dimension &expected,
              const Range &range = range::any) const;

  /// Is the value non-empty (given, or a non-empty default)?
  bool has(const std::string &key) const;
  /// Was it given, in the file or by an override?
  bool given(const std::string &key) const;
  /// InputError "must be given" when the value is empty. Its declaration must mark the key as
  /// required, which the reference of all keys shows; std::logic_error without that mark.
  void require(const std::string &key) const;

  Values subsection(const std::string &name) const;
  /// Does it stand in the file, or was a key in it overridden?
  bool subsection_given(const std::string &name) const;
  /// Names under which `kind` stands here, in file order.
  std::vector<std::string> instances(const std::string &kind) const;
  Values instance(const std::string &kind,
                  const std::string &name) const; /// Throws an InputError that names file and line,
                                                  /// key, value and `problem`: a sentence, of which
  /// the key is the subject where it begins with "must".
  [[noreturn]] void reject(const std::string &key, const std::string &problem) const;
  /// The same for the section as a whole.
  [[noreturn]] void reject_section(const std::string &problem) const;
  /// reject() unless `name` is among `known`; suggests the nearest one.
  void require_known(const std::string &key, const std::string &name,
                     const std::vector<std::string> &known) const;

  /// The key's text is the path of another key, as for --set; returns it in its one spelling,
  /// "Contact heads/Clearance" or "Variables/lambda". reject()s a path that leads nowhere.
  std::string key_path(const std::string &key) const;

  /// "file.prm:12: Contact heads / Clearance = 5 mm", for messages of later stages.
  std::string locate(const std::string &key) const;
  /// "file.prm:12: Contact heads / Clearance"
  std::string place(const std::string &key) const;

  /// "Body left/Material"
  std::string path() const;
  /// Every key of the section and below as "path = value in SI" lines, defaults included, in
  /// declared order: equal text means equal physics. Used for caching.
  std::string fingerprint() const;
  /// The file the section belongs to.
  const ParameterSet &parameters() const { return *set_; }

private:
  friend class ParameterSet;
  Values(std::shared_ptr<const ParameterSet> set, const Node &node);
  const Value &value(const std::string &key, const std::vector<KeyKind> &kinds) const;
  const Value &value(const std::string &key) const;
  void require_value(const std::string &key) const;

  std::shared_ptr<const ParameterSet> set_;
  const Node *node_;
};

/// An override from the command line or a parameter grid: "Contact/heads/Clearance" = "7 mm".
/// A named subsection is written with a slash or a blank between kind and name. "Variables/lambda"
/// replaces the value of one variable.
struct Override {
  std::string path;
  std::string value;
  std::string origin; ///< for messages: "--set", or the Values::place() of the key it comes from
};

/// "PATH=VALUE", split at the first '='. Throws InputError without one.
Override split_override(const std::string &text, const std::string &origin);

/// A number of the file in SI.
struct SiNumber {
  double value = 0;
  std::string unit; ///< "N/m", "1", "rad/s"
};

/// A parameter file with everything it needs to be read. Immutable after construction.
class ParameterSet : public std::enable_shared_from_this<ParameterSet> {
public:
  /// Reads `.prm` or `.json` (by suffix), applies the overrides and checks every value.
  /// Throws InputError.
  static std::shared_ptr<const ParameterSet> read(std::shared_ptr<const Section> declarations,
                                                  const std::string &file,
                                                  const std::vector<Override> &overrides = {});
  /// The same from text; `name` stands for the file in messages, `json` chooses the syntax.
  static std::shared_ptr<const ParameterSet> parse(std::shared_ptr<const Section> declarations,
                                                   const std::string &text, const std::string &name,
                                                   bool json,
                                                   const std::vector<Override> &overrides = {});

  /// The same file with more overrides (for grids). Throws InputError.
  std::shared_ptr<const ParameterSet> with(const std::vector<Override> &more) const;

  Values root() const;
  const VariableTable &variables() const;
  /// Units = dimensionless: no number has a unit, and none is to be shown with one.
  bool dimensionless() const;
  /// The one spelling of an override path: "Contact heads/Clearance", "Variables/lambda". Throws
  /// InputError for an unknown path.
  std::string key_path(const std::string &path) const;
  /// The number an override path names; nothing when the key holds no single number. Throws
  /// InputError for an unknown path.
  std::optional<SiNumber> number_at(const std::string &path) const;
  /// The folder relative file names in the file refer to.
  std::string folder() const;
  /// Complete echo in .prm syntax, defaults included; reading it gives the same set. What was not
  /// given is marked by the comment "# default", and does not count as given when read again.
  std::string echo() const;

private:
  friend class Values;
  struct Data;

public:
  explicit ParameterSet(std::shared_ptr<const Data> data);

private:
  std::shared_ptr<const Data> data_;
};

/// The reference of all keys: "markdown", "prm" (all defaults, with comments) or "json".
std::string print_declarations(const Section &declarations, const std::string &format);

} // namespace vibroimpact::parameters
