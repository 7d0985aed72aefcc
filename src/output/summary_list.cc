#include "output/summary_list.h"

#include "common/json_text.h"
#include "derived/dimensionless.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace vibroimpact::output {

namespace {

std::string twelve_digits(double value) {
  std::array<char, 40> number{};
  // The sign of a NaN depends on how it came about.
  std::snprintf(number.data(), number.size(), "%.12g", std::isnan(value) ? std::abs(value) : value);
  return number.data();
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void add_member(std::string &members, const std::string &name, const std::string &value) {
  members += (members.empty() ? "\n    " : ",\n    ") + json_string(name) + ": " + value;
}

} // namespace

void SummaryList::add(const std::string &name, double value, const std::string &unit,
                      const std::string &remark) {
  entries_.push_back({.name = name, .value = value, .unit = unit, .words = on_one_line(remark)});
}

void SummaryList::add_note(const std::string &name, const std::string &text) {
  entries_.push_back({.name = name, .unit = "", .words = text});
}

void SummaryList::append(const SummaryList &other) {
  entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
}

void SummaryList::remove_units() {
  for (Entry &entry : entries_)
    if (!entry.unit.empty()) {
      entry.value *= derived::plain_factor(entry.unit);
      entry.unit = "1";
    }
}

std::string SummaryList::text() const {
  std::string text;
  for (const Entry &entry : entries_)
    if (entry.unit.empty())
      text += "# " + entry.name + ": " + entry.words + "\n";
    else
      text += entry.name + " = " + twelve_digits(entry.value) + " [" + entry.unit + "]" +
              (entry.words.empty() ? "" : "  " + entry.words) + "\n";
  return text;
}

std::string SummaryList::json() const {
  std::string values;
  std::string notes;
  for (const Entry &entry : entries_)
    if (entry.unit.empty())
      add_member(notes, entry.name, json_string(entry.words));
    else
      add_member(
          values, entry.name,
          "{\"value\": " + json_number(entry.value) + ", \"unit\": " + json_string(entry.unit) +
              (entry.words.empty() ? "" : ", \"remark\": " + json_string(entry.words)) + "}");
  return "{\n  \"values\": {" + values + "\n  },\n  \"notes\": {" + notes + "\n  }\n}\n";
}

} // namespace vibroimpact::output
