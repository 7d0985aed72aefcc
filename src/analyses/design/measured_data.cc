#include "analyses/design/measured_data.h"

#include "analyses/design/design_keys.h"
#include "common/error.h"
#include "model/record_file.h"
#include "parameters/text.h"
#include "reduction/named_file.h"

#include <math.h> // before Boost 1.74, which calls isnan without its namespace

#include <boost/math/interpolators/pchip.hpp>
#include <boost/math/special_functions/fpclassify.hpp> // isnan

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using parameters::Number;
using parameters::Values;

namespace {

double root_mean_square(const std::vector<double> &values) {
  double sum = 0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double on_lines(const std::vector<double> &x, const std::vector<double> &y, double at) {
  const auto after =
      std::clamp<std::ptrdiff_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin(), 1,
                                 static_cast<std::ptrdiff_t>(x.size()) - 1);
  const auto i = static_cast<std::size_t>(after);
  const double share = (at - x[i - 1]) / (x[i] - x[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

} // namespace

void DataSet::declare(parameters::Section &section) {
  using namespace parameters;
  section.named_subsection("Data", "Measurements that the model is to meet.")
      .text("Repeat", "", "Name of the analysis that shows the same.")
      .required()
      .text("Quantity", "",
            "The path of a field of that analysis or the name of a Derived of it; along one axis "
            "where the data are a curve.")
      .required()
      .text("File", "",
            "Text file, or HDF5 file by its suffix .h5 or .hdf5, relative to the folder of the "
            "parameter file. In a text empty lines and lines from # or % on do not count; its "
            "first line may hold the names of the columns.")
      .required("Value is not given")
      .text("Abscissa column", "1",
            "Number or name of a column of the text, path of an HDF5 dataset: values of the axis, "
            "increasing.")
      .text("Value column", "2", "The same for the measured quantity.")
      .choice("Separator", "comma", {"comma", "semicolon", "space"},
              "What stands between the columns; space is any number of blanks and tabs.")
      .text("Abscissa unit", "", "Unit of the abscissa in the file; empty means that of the axis.")
      .text("Value unit", "", "Unit of the values in the file; empty means that of the quantity.")
      .quantity("Value", "", dimension::any, range::any, "",
                "A single measured value instead of a file, such as a natural frequency.")
      .quantity("Standard deviation", "", dimension::any, range::positive, "",
                "Of the measured values; empty means that it is not known, and that differences "
                "are counted in the root mean square of the values.")
      .quantity("Relative deviation", "", dimension::none, range::positive, "",
                "Their standard deviation as a part of each measured value, such as 0.02, where "
                "it is not the same for all.")
      .quantity("Weight", "1", dimension::none, range::positive, "",
                "Multiplies the squares of the differences.");
}

DataSet::DataSet(const Values &section, std::string name)
    : name_(std::move(name)), analysis_(read_evaluated(section)),
      quantity_(section.text("Quantity")), single_(section.has("Value")),
      weight_(section.quantity("Weight")), section_(section) {
  section.require("Quantity");
  if (section.has("Relative deviation") && section.has("Standard deviation"))
    section.reject("Relative deviation", "must not be set when Standard deviation is set");
  if (single_)
    read_single();
  else
    read_curve();
}

void DataSet::read_single() {
  for (const char *key :
       {"File", "Abscissa column", "Value column", "Separator", "Abscissa unit", "Value unit"})
    if (section_.given(key))
      section_.reject(key, "must not be set when Value is set");
  value_ = {0}; // its unit is that of the quantity, which is not known yet
}

void DataSet::read_curve() {
  section_.require("File");
  const Values root = section_.parameters().root();
  model::Samples samples =
      model::read_record(section_, root.text("File folder"), root.names("File checksums"),
                         {.time_column = section_.text("Abscissa column"),
                          .value_column = section_.text("Value column"),
                          .separator = section_.choice("Separator"),
                          .time_key = "Abscissa column"});
  abscissa_ = std::move(samples.time);
  value_ = std::move(samples.value);
}

// What the file's unit is in units of the outcome.
double DataSet::unit_factor(const char *key, const Number &one) const {
  return section_.has(key)
             ? section_.part(key, "1 " + section_.text(key), one.dimension) / one.value
             : 1;
}

std::vector<double> DataSet::deviations(const std::vector<double> &measured,
                                        const Number &one) const {
  if (section_.has("Relative deviation")) {
    std::vector<double> parts;
    for (const double value : measured) {
      if (value == 0)
        section_.reject("Relative deviation", "must not be set when a measured value is 0");
      parts.push_back(section_.quantity("Relative deviation") * std::abs(value));
    }
    return parts;
  }
  const auto same = [&](double value) { return std::vector(measured.size(), value); };
  if (section_.has("Standard deviation"))
    return same(section_.quantity_of("Standard deviation", one.dimension) / one.value);
  const double size = root_mean_square(measured);
  if (!(size > 0))
    section_.reject_section("Standard deviation must be given when all measured values are 0");
  return same(size);
}

void DataSet::check_reach(const Outcome &outcome, const std::vector<double> &abscissa) const {
  const Axis &axis = outcome.axes.at(0);
  const auto [first, last] = std::minmax_element(axis.values.begin(), axis.values.end());
  const double reach = 1e-9 * std::max(std::abs(*first), std::abs(*last));
  for (const double at : {abscissa.front(), abscissa.back()})
    if (axis.size() < 2 || at < *first - reach || at > *last + reach)
      section_.reject("Abscissa column",
                      "must have values along the axis " + axis.name + ", which goes from " +
                          parameters::number_text(*first) + " to " +
                          parameters::number_text(*last) + " " + axis.unit + "; the data have " +
                          parameters::number_text(at) + " there");
}

std::vector<double> DataSet::interpolated(const Outcome &outcome,
                                          const std::vector<double> &abscissa) const {
  std::vector<double> x = outcome.axes.at(0).values, y = outcome.values;
  if (x.size() > 1 && x.back() < x.front()) {
    std::reverse(x.begin(), x.end());
    std::reverse(y.begin(), y.end());
  }
  for (const double value : y)
    if (!std::isfinite(value))
      throw NumericalError(quantity_ + " is not finite everywhere along " + outcome.axes[0].name);
  const auto inside = [&](double at) { return std::clamp(at, x.front(), x.back()); };
  std::vector<double> values;
  if (x.size() < 4) {
    for (const double at : abscissa)
      values.push_back(on_lines(x, y, inside(at)));
    return values;
  }
  const std::vector<double> ends{x.front(), x.back()};
  const boost::math::interpolators::pchip<std::vector<double>> curve(std::move(x), std::move(y));
  for (const double at : abscissa)
    values.push_back(curve(std::clamp(at, ends[0], ends[1])));
  return values;
}

DataSet::Measured DataSet::measured_curve(const Outcome &outcome) const {
  if (outcome.axes.size() != 1 || !outcome.axes[0].labels.empty())
    section_.reject("Quantity",
                    "must be a quantity along one axis with numbers; this one goes over " +
                        std::to_string(outcome.axes.size()) +
                        ". A section Derived with Operation = select makes one of it.");
  const double factor = unit_factor("Abscissa unit", outcome.axis_ones[0]);
  const double scale = unit_factor("Value unit", outcome.one);
  Measured data;
  for (std::size_t i = 0; i < value_.size(); ++i) {
    data.abscissa.push_back(factor * abscissa_[i]);
    data.values.push_back(scale * value_[i]);
  }
  check_reach(outcome, data.abscissa);
  return data;
}

DataSet::Measured DataSet::measured(const Outcome &outcome) const {
  if (single_ && outcome.values.size() != 1)
    section_.reject("Quantity", "must be a single number when Value is set");
  Measured data = single_
                      ? Measured{.abscissa = {0},
                                 .values = {section_.quantity_of("Value", outcome.one.dimension) /
                                            outcome.one.value},
                                 .deviations = {}}
                      : measured_curve(outcome);
  data.deviations = deviations(data.values, outcome.one);
  return data;
}

FittedSet DataSet::compare(const Outcome &outcome) const {
  Measured data = measured(outcome);
  FittedSet set{.unit = outcome.unit,
                .abscissa_unit = single_ ? "1" : outcome.axes[0].unit,
                .abscissa = std::move(data.abscissa),
                .measured = std::move(data.values),
                .model = outcome.values,
                .residual = {}};
  if (!single_)
    set.model = interpolated(outcome, set.abscissa);
  else if (!std::isfinite(set.model[0]))
    throw NumericalError(quantity_ + " is no finite number");
  for (std::size_t i = 0; i < set.model.size(); ++i)
    set.residual.push_back(std::sqrt(weight_) / data.deviations[i] *
                           (set.model[i] - set.measured[i]));
  return set;
}

std::vector<DataSet> read_data_sets(const Values &section) {
  std::vector<DataSet> sets;
  for (const std::string &name : section.instances("Data"))
    sets.emplace_back(section.instance("Data", name), name);
  if (sets.empty())
    section.reject_section("at least one subsection Data NAME must be given");
  return sets;
}

std::vector<std::string> data_checksums(const Values &root, const std::string &file_folder) {
  std::vector<std::string> checksums;
  const auto add = [&](const Values &section) {
    const std::string checksum = reduction::file_checksum(section, file_folder);
    if (!checksum.empty())
      checksums.push_back(checksum);
  };
  for (const std::string &analysis : root.instances("Analysis")) {
    const Values section = root.instance("Analysis", analysis);
    const Values estimate = section.subsection("Estimate");
    add(section.subsection("Identify"));
    for (const std::string &name : estimate.instances("Data"))
      add(estimate.instance("Data", name));
  }
  return checksums;
}

} // namespace vibroimpact::analyses
