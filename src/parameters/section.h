// Declarations: which keys and subsections a parameter file may hold. Every key says its default,
// range, unit, symbol and meaning; the checks, the echo and the manual are all made from this.
#pragma once

#include "parameters/dimension.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vibroimpact::parameters {

/// Admissible range of a number, in SI.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;

  bool contains(double value) const;
  /// "greater than 0", "from 0 to 1", "any"
  std::string sentence(const std::string &unit) const;
};

namespace range {
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any{};
inline constexpr Range positive{.lower = 0, .lower_open = true};
inline constexpr Range non_negative{.lower = 0};
inline constexpr Range fraction{.lower = 0, .upper = 1};
} // namespace range

enum class KeyKind { quantity, quantities, integer, boolean, choice, text, names, variables };

struct Key {
  std::string name;
  KeyKind kind = KeyKind::text;
  std::string default_value{}; ///< as a user would write it; an empty one may mean "must be given"
  std::string symbol{};        ///< as in the theory manual, may be empty
  std::string sentence;
  Dimension dimension{};
  Range range{};
  std::vector<std::string> options{}; ///< for choice
  int minimum_count = 0;              ///< for quantities
  int maximum_count = std::numeric_limits<int>::max();
  bool required = false;       ///< must be given where the section is read
  std::string required_when{}; ///< or only where this holds: "Type = tube"
};

/// A section of the parameter file, as declared. Sections nest; a `kind` can be declared once and
/// stand in a file any number of times under different names ("subsection Body left"). A Section
/// made by its constructor is a whole file: it has the key "Variables", named values that every
/// number in the file may use. Names of keys and sections hold no '/', '=' and '#', and a second
/// declaration of a key throws std::logic_error. It has the key "Units", too; see without_units().
class Section {
public:
  Section(std::string name, std::string sentence);

  /// A number with a unit. An empty default makes the key optional: see Values::has(). With
  /// dimension::any the reader must call Values::require_dimension().
  Section &quantity(std::string name, std::string default_value, Dimension dimension, Range range,
                    std::string symbol, std::string sentence);
  /// Numbers separated by commas (or "->", which reads well between two points).
  Section &quantities(std::string name, std::string default_value, Dimension dimension, Range range,
                      std::string symbol, std::string sentence, int minimum_count,
                      int maximum_count);
  Section &integer(std::string name, std::string default_value, Range range, std::string symbol,
                   std::string sentence);
  Section &boolean(std::string name, std::string default_value, std::string sentence);
  Section &choice(std::string name, std::string default_value, std::vector<std::string> options,
                  std::string sentence);
  Section &text(std::string name, std::string default_value, std::string sentence);
  /// Names separated by commas.
  Section &names(std::string name, std::string default_value, std::string sentence);

  /// The key declared last must be given wherever its section is read, or where `when` holds, such
  /// as "Shape = tube". Its reader must call Values::require().
  Section &required(std::string when = "");

  /// A fixed subsection; calling it again returns the same one.
  Section &subsection(const std::string &name, const std::string &sentence);
  /// A subsection that stands in the file as "subsection KIND NAME", once for each name.
  Section &named_subsection(const std::string &kind, const std::string &sentence);

  /// The same keys and sections for a file with Units = dimensionless: every number is plain, and
  /// defaults are their numbers in SI.
  std::shared_ptr<const Section> without_units() const;

  const std::string &name() const { return name_; }
  const std::string &sentence() const { return sentence_; }
  const std::vector<Key> &keys() const { return keys_; }
  const std::vector<std::unique_ptr<Section>> &subsections() const { return subsections_; }
  const std::vector<std::unique_ptr<Section>> &named_subsections() const { return named_; }
  const Key *find_key(const std::string &key) const;
  const Section *find_subsection(const std::string &subsection) const;
  const Section *find_named(const std::string &kind) const;

private:
  Section &add(Key key);
  std::unique_ptr<Section> plain_copy() const;
  static std::unique_ptr<Section> nested(const std::string &name, const std::string &sentence);

  std::string name_;
  std::string sentence_;
  std::vector<Key> keys_;
  std::vector<std::unique_ptr<Section>> subsections_;
  std::vector<std::unique_ptr<Section>> named_;
};

} // namespace vibroimpact::parameters
