// Measured data, and by how much a quantity of an analysis differs from them.
#pragma once

#include "analyses/run/outcomes.h"
#include "common/linear_algebra.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Data beside the model, in the units of the quantity of the analysis.
struct FittedSet {
  std::string unit, abscissa_unit;
  std::vector<double> abscissa, measured, model;
  std::vector<double> residual; ///< (model - measured) / deviation, times the root of the weight
};

/// One section Data: a curve from a file, or a single value.
class DataSet {
public:
  static void declare(parameters::Section &section);
  /// Reads the file. InputError.
  DataSet(const parameters::Values &section, std::string name);

  const std::string &name() const { return name_; }
  const std::string &analysis() const { return analysis_; }
  const std::string &quantity() const { return quantity_; }
  std::size_t size() const { return value_.size(); }
  /// Is the standard deviation of the data known?
  bool has_deviation() const {
    return section_.has("Standard deviation") || section_.has("Relative deviation");
  }

  /// Where the file asks for the quantity, for messages.
  std::string place() const { return section_.place("Quantity"); }
  /// The checks of compare() that do not need the values of the outcome. InputError.
  void check(const Outcome &outcome) const { measured(outcome); }
  /// Beside the model's outcome, which is interpolated at the abscissae of the data: by a cubic
  /// that is monotone between its points, or along straight lines through less than four.
  /// InputError when the outcome does not go over one axis with numbers (is no single number), or
  /// not as far as the data, or when units do not fit; NumericalError when a value is missing.
  FittedSet compare(const Outcome &outcome) const;

private:
  void read_curve();
  void read_single();
  double unit_factor(const char *key, const parameters::Number &one) const;
  /// Of each measured value.
  std::vector<double> deviations(const std::vector<double> &measured,
                                 const parameters::Number &one) const;
  /// The data and their standard deviations, which the outcome gives their units.
  struct Measured {
    std::vector<double> abscissa, values, deviations;
  };
  Measured measured(const Outcome &outcome) const;
  Measured measured_curve(const Outcome &outcome) const;
  void check_reach(const Outcome &outcome, const std::vector<double> &abscissa) const;
  std::vector<double> interpolated(const Outcome &outcome,
                                   const std::vector<double> &abscissa) const;

  std::string name_, analysis_, quantity_;
  std::vector<double> abscissa_, value_; ///< as in the file
  bool single_;
  double weight_;
  parameters::Values section_;
};

/// At least one, in the order of the file.
std::vector<DataSet> read_data_sets(const parameters::Values &section);

/// "NAME HASH" of every file of measured data. Local.
std::vector<std::string> data_checksums(const parameters::Values &root,
                                        const std::string &file_folder);

} // namespace vibroimpact::analyses
