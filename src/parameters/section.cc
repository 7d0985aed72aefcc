#include "parameters/section.h"

#include "parameters/file_units.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace vibroimpact::parameters {

namespace {

void check_name(const std::string &name) {
  if (name != normalised(name) || name.empty() || name.find_first_of("/=#") != std::string::npos)
    throw std::logic_error("'" + name + "' cannot name a key or section of the parameter file");
}

std::string bound(double value, const std::string &unit) {
  const bool without_unit = unit.empty() || unit == "1" || value == 0;
  return number_text(value) + (without_unit ? "" : " " + unit);
}

template <class List> auto find_by_name(const List &list, const std::string &name) {
  for (const auto &section : list)
    if (section->name() == name)
      return section.get();
  return static_cast<decltype(list.front().get())>(nullptr);
}

Section &found_or_added(std::vector<std::unique_ptr<Section>> &list,
                        std::unique_ptr<Section> added) {
  check_name(added->name());
  if (Section *found = find_by_name(list, added->name()))
    return *found;
  list.push_back(std::move(added));
  return *list.back();
}

} // namespace

bool Range::contains(double value) const {
  return (lower_open ? value > lower : value >= lower) &&
         (upper_open ? value < upper : value <= upper);
}

std::string Range::sentence(const std::string &unit) const {
  const std::string from = bound(lower, unit);
  const std::string to = bound(upper, unit);
  if (std::isinf(lower) && std::isinf(upper))
    return "any";
  if (std::isinf(upper))
    return (lower_open ? "greater than " : "greater than or equal to ") + from;
  if (std::isinf(lower))
    return (upper_open ? "less than " : "less than or equal to ") + to;
  if (!lower_open && !upper_open)
    return "from " + from + " to " + to;
  return (lower_open ? "greater than " : "from ") + from + " and " +
         (upper_open ? "less than " : "up to ") + to;
}

Section::Section(std::string name, std::string sentence)
    : name_(std::move(name)), sentence_(std::move(sentence)) {
  add({.name = "Variables",
       .kind = KeyKind::variables,
       .sentence = "Named values for use in every number of the file: NAME = VALUE, separated by "
                   "commas; later ones may use earlier ones."});
  choice(
      units_key, "SI", {"SI", dimensionless_units},
      "With dimensionless every number of the file is plain, as are all results: no unit is read "
      "or written, and frequencies are angular.");
}

std::unique_ptr<Section> Section::nested(const std::string &name, const std::string &sentence) {
  auto section = std::make_unique<Section>(name, sentence);
  section->keys_.clear();
  return section;
}

Section &Section::add(Key key) {
  check_name(key.name);
  if (find_key(key.name) != nullptr)
    throw std::logic_error("key '" + key.name + "' of section '" + name_ + "' is declared twice");
  keys_.push_back(std::move(key));
  return *this;
}

Section &Section::quantity(std::string name, std::string default_value, Dimension dimension,
                           Range range, std::string symbol, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::quantity,
              .default_value = std::move(default_value),
              .symbol = std::move(symbol),
              .sentence = std::move(sentence),
              .dimension = dimension,
              .range = range});
}

Section &Section::quantities(std::string name, std::string default_value, Dimension dimension,
                             Range range, std::string symbol, std::string sentence,
                             int minimum_count, int maximum_count) {
  return add({.name = std::move(name),
              .kind = KeyKind::quantities,
              .default_value = std::move(default_value),
              .symbol = std::move(symbol),
              .sentence = std::move(sentence),
              .dimension = dimension,
              .range = range,
              .minimum_count = minimum_count,
              .maximum_count = maximum_count});
}

Section &Section::integer(std::string name, std::string default_value, Range range,
                          std::string symbol, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::integer,
              .default_value = std::move(default_value),
              .symbol = std::move(symbol),
              .sentence = std::move(sentence),
              .range = range});
}

Section &Section::boolean(std::string name, std::string default_value, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::boolean,
              .default_value = std::move(default_value),
              .sentence = std::move(sentence)});
}

Section &Section::choice(std::string name, std::string default_value,
                         std::vector<std::string> options, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::choice,
              .default_value = std::move(default_value),
              .sentence = std::move(sentence),
              .options = std::move(options)});
}

Section &Section::text(std::string name, std::string default_value, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::text,
              .default_value = std::move(default_value),
              .sentence = std::move(sentence)});
}

Section &Section::names(std::string name, std::string default_value, std::string sentence) {
  return add({.name = std::move(name),
              .kind = KeyKind::names,
              .default_value = std::move(default_value),
              .sentence = std::move(sentence)});
}

Section &Section::required(std::string when) {
  if (keys_.empty() || !keys_.back().default_value.empty())
    throw std::logic_error("a required key of section '" + name_ + "' must have an empty default");
  keys_.back().required = true;
  keys_.back().required_when = std::move(when);
  return *this;
}

Section &Section::subsection(const std::string &name, const std::string &sentence) {
  return found_or_added(subsections_, nested(name, sentence));
}

Section &Section::named_subsection(const std::string &kind, const std::string &sentence) {
  return found_or_added(named_, nested(kind, sentence));
}

std::shared_ptr<const Section> Section::without_units() const { return plain_copy(); }

std::unique_ptr<Section> Section::plain_copy() const {
  std::unique_ptr<Section> copy = nested(name_, sentence_);
  for (Key key : keys_) {
    if (key.kind == KeyKind::quantity || key.kind == KeyKind::quantities)
      key.default_value = plain_text(key.default_value);
    key.dimension = {};
    copy->keys_.push_back(std::move(key));
  }
  for (const auto &subsection : subsections_)
    copy->subsections_.push_back(subsection->plain_copy());
  for (const auto &kind : named_)
    copy->named_.push_back(kind->plain_copy());
  return copy;
}

const Key *Section::find_key(const std::string &key) const {
  for (const Key &candidate : keys_)
    if (candidate.name == key)
      return &candidate;
  return nullptr;
}

const Section *Section::find_subsection(const std::string &subsection) const {
  return find_by_name(subsections_, subsection);
}

const Section *Section::find_named(const std::string &kind) const {
  return find_by_name(named_, kind);
}

} // namespace vibroimpact::parameters
