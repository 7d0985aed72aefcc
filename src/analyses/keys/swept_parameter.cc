#include "analyses/keys/swept_parameter.h"

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

std::vector<double> frequency_ends(const parameters::Values &section) {
  section.require("First frequency");
  section.require("Last frequency");
  return {section.quantity("First frequency") / (2 * std::numbers::pi),
          section.quantity("Last frequency") / (2 * std::numbers::pi)};
}

// A single point may stand at both ends.
bool in_order(const std::vector<double> &ends, long points) {
  return ends[1] > ends[0] || (ends[1] == ends[0] && points == 1);
}

SweptParameter read_frequency(const parameters::Values &section) {
  for (const char *key : {"First", "Last"})
    if (section.has(key))
      section.reject(key, "must not be set when Parameter is not set; the ends of a frequency "
                          "sweep are First frequency and Last frequency");
  return {.path = {}, .unit = "Hz", .values = frequency_ends(section)};
}

// For messages about values of the swept key that `key` gives.
std::string origin_of(const parameters::Values &section, const char *key) {
  return section.place(key) + ":";
}

// The number behind `path` when the file says `text` there.
parameters::SiNumber read_end(const parameters::Values &section, const char *key) {
  section.require(key);
  return read_number_for(section, "Parameter", key);
}

} // namespace

parameters::SiNumber read_number_for(const parameters::Values &section, const char *path_key,
                                     const char *key) {
  const std::string path = section.text(path_key);
  const auto set = section.parameters().with(
      {{.path = path, .value = section.text(key), .origin = origin_of(section, key)}});
  const auto number = set->number_at(path);
  if (!number)
    section.reject(path_key, "must be a key with one number as its value");
  return *number;
}

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

std::string SweptParameter::axis_name() const {
  return is_frequency() ? "frequency" : boost::replace_all_copy(path, "/", ".");
}

Axis SweptParameter::axis() const {
  if (is_frequency())
    return {.name = axis_name(),
            .values = values,
            .labels = {},
            .unit = unit,
            .description = "excitation frequency"};
  return {.name = axis_name(),
          .values = values,
          .labels = {},
          .unit = unit,
          .description = "swept key " + path};
}

std::vector<double> read_frequencies(const parameters::Values &section) {
  const std::vector<double> ends = frequency_ends(section);
  const long points = section.integer("Points");
  if (!in_order(ends, points))
    section.reject("Last frequency", "must be greater than First frequency");
  return spaced(ends[0], ends[1], points, logarithmic(section));
}

void declare_key_range(parameters::Section &section, bool key_required) {
  using namespace parameters;
  section.text(
      "Parameter", "",
      "Key that is swept, as for --set: Contact/stop/Clearance, or Variables/lambda; empty "
      "means the frequency of the excitation.");
  if (key_required)
    section.required();
  section
      .quantity("First frequency", "", dimension::frequency, range::positive, "f_1",
                "Lowest frequency of a frequency sweep.")
      .required("Parameter is not given")
      .quantity("Last frequency", "", dimension::frequency, range::positive, "f_2",
                "Highest frequency of a frequency sweep.")
      .required("Parameter is not given")
      .text("First", "", "Lowest value of Parameter, with its unit.")
      .required("Parameter is given")
      .text("Last", "", "Highest value of Parameter, with its unit.")
      .required("Parameter is given");
}

void declare_swept_parameter(parameters::Section &section) {
  using namespace parameters;
  declare_key_range(section);
  section
      .integer("Points", "50", Range{.lower = 1, .upper = 1e6}, "",
               "Number of frequencies or values.")
      .choice("Spacing", "linear", {"linear", "logarithmic"}, "How they are spaced.");
}

SweptParameter read_key_range(const parameters::Values &section, long points) {
  const std::string path = section.text("Parameter");
  if (path.empty()) {
    SweptParameter frequency = read_frequency(section);
    if (!in_order(frequency.values, points))
      section.reject("Last frequency", "must be greater than First frequency");
    return frequency;
  }
  if (const std::string target = section.key_path("Parameter");
      target.starts_with("Analysis ") || target.starts_with("Derived "))
    section.reject("Parameter", "must be a key outside the analyses");
  for (const char *key : {"First frequency", "Last frequency"})
    if (section.has(key))
      section.reject(key, "must not be set when Parameter is set, whose ends are First and Last");
  const parameters::SiNumber first = read_end(section, "First");
  const parameters::SiNumber last = read_end(section, "Last");
  if (first.unit != last.unit)
    section.reject("Last", "must be a value in a unit like that of First");
  if (!in_order({first.value, last.value}, points))
    section.reject("Last", "must be greater than First");
  return {.path = path,
          .unit = first.unit,
          .values = {first.value, last.value},
          .origin = origin_of(section, "First")};
}

SweptParameter read_swept_parameter(const parameters::Values &section) {
  const long points = section.integer("Points");
  SweptParameter parameter = read_key_range(section, points);
  const double first = parameter.values[0], last = parameter.values[1];
  if (!parameter.is_frequency() && logarithmic(section) && !(first > 0))
    section.reject("First", "must be greater than 0 when Spacing = logarithmic");
  parameter.values = spaced(first, last, points, logarithmic(section));
  return parameter;
}

} // namespace vibroimpact::analyses
