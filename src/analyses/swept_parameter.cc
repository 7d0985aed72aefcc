#include "analyses/swept_parameter.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <charconv>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

std::vector<double> spaced(double first, double last, long points, bool logarithmic) {
  std::vector<double> values;
  for (long i = 0; i < points; ++i) {
    const double share = points > 1 ? static_cast<double>(i) / static_cast<double>(points - 1) : 0;
    values.push_back(logarithmic ? first * std::pow(last / first, share)
                                 : first + (last - first) * share);
  }
  if (points > 1)
    values.back() = last;
  return values;
}

bool logarithmic(const parameters::Values &section) {
  return section.choice("Spacing") == "logarithmic";
}

SweptParameter read_frequency(const parameters::Values &section) {
  for (const char *key : {"First", "Last"})
    if (section.has(key))
      section.reject(key, "nothing without the key Parameter; the ends of a frequency sweep are "
                          "First frequency and Last frequency.");
  return {.path = {}, .unit = "Hz", .values = read_frequencies(section)};
}

// For messages about values of the swept key that `key` gives.
std::string origin_of(const parameters::Values &section, const char *key) {
  return section.place(key) + ":";
}

// The number behind `path` when the file says `text` there.
parameters::SiNumber read_end(const parameters::Values &section, const std::string &path,
                              const char *key) {
  section.require(key);
  const auto set = section.parameters().with(
      {{.path = path, .value = section.text(key), .origin = origin_of(section, key)}});
  const auto number = set->number_at(path);
  if (!number)
    section.reject("Parameter", "a key that holds one number.");
  return *number;
}

} // namespace

double SweptParameter::magnitude() const {
  return std::max(std::abs(values.front()), std::abs(values.back()));
}

parameters::Override SweptParameter::at(double value) const {
  char number[32]; // the longest shortest form of a double has 24 characters
  const std::to_chars_result written = std::to_chars(number, number + sizeof number, value);
  std::string text(number, written.ptr);
  if (unit.starts_with("1/"))
    text += unit.substr(1);
  else if (unit != "1")
    text += " " + unit;
  return {.path = path, .value = text, .origin = origin};
}

Axis SweptParameter::axis() const {
  if (is_frequency())
    return {.name = "frequency",
            .values = values,
            .labels = {},
            .unit = unit,
            .description = "excitation frequency"};
  return {.name = boost::replace_all_copy(path, "/", "."),
          .values = values,
          .labels = {},
          .unit = unit,
          .description = "swept key " + path};
}

std::vector<double> read_frequencies(const parameters::Values &section) {
  section.require("First frequency");
  section.require("Last frequency");
  const double first = section.quantity("First frequency") / (2 * std::numbers::pi);
  const double last = section.quantity("Last frequency") / (2 * std::numbers::pi);
  const long points = section.integer("Points");
  if (last < first || (last == first && points > 1))
    section.reject("Last frequency", "a frequency above First frequency.");
  return spaced(first, last, points, logarithmic(section));
}

void declare_swept_parameter(parameters::Section &section) {
  using namespace parameters;
  section
      .text("Parameter", "",
            "Key that is swept, as for --set: Contact/stop/Clearance, or Variables/lambda; empty "
            "means the frequency of the excitation.")
      .quantity("First frequency", "", dimension::frequency, range::positive, "f_1",
                "Lowest frequency of a frequency sweep.")
      .quantity("Last frequency", "", dimension::frequency, range::positive, "f_2",
                "Highest frequency of a frequency sweep.")
      .text("First", "", "Lowest value of Parameter, with its unit.")
      .text("Last", "", "Highest value of Parameter, with its unit.")
      .integer("Points", "50", Range{.lower = 1, .upper = 1e6}, "",
               "Number of frequencies or values.")
      .choice("Spacing", "linear", {"linear", "logarithmic"}, "How they are spaced.");
}

SweptParameter read_swept_parameter(const parameters::Values &section) {
  const std::string path = section.text("Parameter");
  if (path.empty())
    return read_frequency(section);
  if (const std::string target = section.key_path("Parameter");
      target.starts_with("Analysis ") || target.starts_with("Derived "))
    section.reject("Parameter", "a key outside the analyses.");
  for (const char *key : {"First frequency", "Last frequency"})
    if (section.has(key))
      section.reject(key, "nothing beside the key Parameter, whose ends are First and Last.");
  const parameters::SiNumber first = read_end(section, path, "First");
  const parameters::SiNumber last = read_end(section, path, "Last");
  const long points = section.integer("Points");
  if (first.unit != last.unit)
    section.reject("Last", "a value in a unit like that of First.");
  if (last.value < first.value || (last.value == first.value && points > 1))
    section.reject("Last", "a value above First.");
  if (logarithmic(section) && !(first.value > 0))
    section.reject("First", "a value above zero for logarithmic spacing.");
  return {.path = path,
          .unit = first.unit,
          .values = spaced(first.value, last.value, points, logarithmic(section)),
          .origin = origin_of(section, "First")};
}

} // namespace vibroimpact::analyses
