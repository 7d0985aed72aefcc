// Quantities that a parameter file asks to be derived from the results of its analyses.
#pragma once

#include "analyses/analysis.h"
#include "derived/labelled_array.h"
#include "derived/names.h"
#include "parameters/values.h"

#include <map>
#include <string>
#include <vector>

namespace vibroimpact::derived {

/// Declares the kind "Derived".
void declare_derived(parameters::Section &root);

/// InputError when a Derived names an analysis that the file does not have.
void check_analyses(const parameters::Values &root);

/// The quantities of all analyses.
class DerivedQuantities {
public:
  DerivedQuantities() = default;

  /// Reads those of one analysis from its outer axes. InputError for whatever can be known before
  /// there are fields.
  void add(const parameters::Values &root, const std::string &analysis,
           const std::vector<Axis> &axes, const std::vector<analyses::GridKey> &keys);

  struct Result {
    std::vector<DerivedArray> arrays;
    std::vector<std::string> problems; ///< complete messages; these quantities are left out
  };
  /// In the order of the file. Nothing where the analysis has no field yet.
  Result evaluate(const std::string &analysis, const Source &source) const;

private:
  struct Wanted {
    AxisNames names;
    std::vector<std::string> titles; ///< "Derived TITLE"
    std::vector<parameters::Values> sections;
    analyses::BestOf best{}; ///< of a search from several starts
  };
  std::map<std::string, Wanted> wanted_; ///< by analysis
};

} // namespace vibroimpact::derived
