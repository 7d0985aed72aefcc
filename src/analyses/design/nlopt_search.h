// The methods of NLopt that need no derivatives. NLopt is kept in Debian and has all of them behind
// one interface.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// A search in coordinates of about unit size.
struct SearchProblem {
  Vector lower, upper; ///< infinite without a bound
  Vector start, step;
  /// What is made small; may throw.
  std::function<double(const Vector &)> objective;
  /// Each is to be at most 0; may throw.
  std::vector<std::function<double(const Vector &)>> constraints;
  double constraint_tolerance = 0;
  double tolerance = 0;           ///< of the coordinates
  double objective_tolerance = 0; ///< relative; 0 for none
  int most_calls = 0;             ///< of the objective
  unsigned population = 0;        ///< of methods that have one; 0: NLopt's choice
  unsigned long seed = 0;         ///< of methods that draw numbers
};

struct SearchMethod {
  std::string name;
  int algorithm;          ///< of NLopt
  bool needs_bounds;      ///< of every key
  bool takes_constraints; ///< on other quantities
  bool only_compares;     ///< may see infinite values of the objective
};

const std::vector<SearchMethod> &search_methods();
/// nullptr where NLopt has no such method.
const SearchMethod *search_method(const std::string &name);

/// Why a search ended; the numbers are those in results.
enum class SearchEnd {
  other = 0,
  tolerance = 1,
  objective_tolerance = 2,
  evaluations = 3,
  rounding = 4
};

/// Runs until it ends, or until a function throws, which this does then.
SearchEnd search(const SearchMethod &method, const SearchProblem &problem);

} // namespace vibroimpact::analyses
