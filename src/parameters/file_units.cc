#include "parameters/file_units.h"

#include "parameters/expression.h"
#include "parameters/text.h"

#include <array>
#include <charconv>

namespace vibroimpact::parameters {

namespace {

/// The shortest text that is read as the same number.
std::string shortest_text(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

} // namespace

bool is_dimensionless(ScannedEntry &file) {
  std::vector<ScannedEntry> entries;
  const ScannedEntry *units = nullptr;
  entries.reserve(file.entries.size());
  for (ScannedEntry &entry : file.entries) {
    if (entry.name != units_key || entry.kind != ScannedEntry::Kind::key) {
      entries.push_back(std::move(entry));
    } else if (units == nullptr) {
      units = &entries.emplace_back(std::move(entry));
    } else if (entry.value != units->value) {
      refuse_value(entry.origin, {units_key}, entry.value,
                   "all files must have the same Units, but Units = " + units->value + " at " +
                       place(units->origin, {}));
    }
  }
  file.entries = std::move(entries);
  return units != nullptr && units->value == dimensionless_units;
}

void check_plain(const UnitFactor &unit, const std::string &text) {
  if (!(unit.dimension == dimension::none))
    throw Refused("'" + text + "' must not have a unit when Units = dimensionless");
}

std::string plain_text(const std::string &numbers) {
  std::vector<std::string> plain;
  for (const std::string &part : split_list(numbers, true)) {
    const Number number = evaluate(part, {});
    plain.push_back(number.bare ? part : shortest_text(number.value));
  }
  return join(plain, ", ");
}

} // namespace vibroimpact::parameters
