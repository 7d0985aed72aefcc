// What a derived quantity may do with the arrays of an analysis. An operation is one function and
// one line in operations.cc.
#pragma once

#include "derived/labelled_array.h"
#include "derived/names.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::derived {

/// One `Derived` section together with the arrays it is evaluated on. What the section asks for and
/// is not there is an InputError.
class Request {
public:
  Request(const parameters::Values &section, std::string name, const AxisNames &names,
          const Source &source, const std::vector<DerivedArray> &earlier)
      : section_(section), name_(std::move(name)), names_(names), source_(source),
        earlier_(earlier) {}

  /// Of the quantity.
  const std::string &name() const { return name_; }
  const parameters::Values &section() const { return section_; }
  const AxisNames &names() const { return names_; }

  /// The array that a key names: an earlier quantity, a field, or the coordinate of a dimension.
  LabelledArray array(const std::string &key) const { return array(key, section_.text(key)); }
  LabelledArray array(const std::string &key, const std::string &name) const;

  /// The dimensions that key `Along` names, all of them dimensions of `array`.
  std::vector<Axis> along(const LabelledArray &array) const;
  /// The only one of them. With `numbers` its coordinate must not be labels.
  Axis along_one(const LabelledArray &array, bool numbers) const;
  /// A dimension by a name it goes by, which stands in the value of `key`.
  Axis axis(const std::string &key, const std::string &name, const LabelledArray &array) const;

  /// The quantity behind `key` in `unit`, which is that of a field or axis.
  double number(const std::string &key, const std::string &unit) const;
  std::vector<double> numbers(const std::string &key, const std::string &unit) const;

  /// An empty result; its description is the user's, if there is one.
  DerivedArray result(const std::string &unit, const std::string &description,
                      const std::vector<std::string> &dimensions, const Shape &shape) const;

private:
  const parameters::Values &section_;
  std::string name_;
  const AxisNames &names_;
  const Source &source_;
  const std::vector<DerivedArray> &earlier_;
};

struct Operation {
  std::string name;
  std::vector<std::string> required; ///< keys
  std::vector<std::string> optional; ///< further keys that mean something
  DerivedArray (*evaluate)(const Request &request);
  /// What can be refused before there are fields, beyond missing keys and unknown axes.
  void (*check)(const parameters::Values &section, const AxisNames &names) = nullptr;
};

const std::vector<Operation> &operations();
const Operation &operation(const std::string &name);

/// Checks of what can be refused before there are fields. InputError.
using Check = void(const parameters::Values &section, const AxisNames &names);
/// InputError when an axis that key `Along` names is known to have labels.
void check_numbered_axes(const parameters::Values &section, const AxisNames &names);

// extreme_values.cc
Check check_extreme;
Check check_position;
DerivedArray maximum(const Request &request);
DerivedArray minimum(const Request &request);
DerivedArray position_of_maximum(const Request &request);
DerivedArray position_of_minimum(const Request &request);
DerivedArray value_at_maximum(const Request &request);
DerivedArray value_at_minimum(const Request &request);
// mean.cc
DerivedArray mean(const Request &request);
// spread.cc
DerivedArray standard_deviation(const Request &request);
DerivedArray standard_error(const Request &request);
DerivedArray quantile(const Request &request);
// selection.cc
Check check_places;
DerivedArray select(const Request &request);
// formula.cc
Check check_formula;
DerivedArray evaluate_formula(const Request &request);
// difference.cc
Check check_comparison;
// crossing.cc
DerivedArray crossing(const Request &request);
// band.cc
DerivedArray band(const Request &request);
// hysteresis_width.cc
DerivedArray hysteresis_width(const Request &request);
// jump_locus.cc
DerivedArray locus_of_jump(const Request &request);
// contour.cc
DerivedArray contour(const Request &request);

} // namespace vibroimpact::derived
