#include "analyses/design/nlopt_search.h"

#include "common/error.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <nlopt.h>
#include <stdexcept>

namespace vibroimpact::analyses {

namespace {

using Function = std::function<double(const Vector &)>;

/// C++ exceptions must not pass through NLopt, which is C.
struct Guarded {
  nlopt_opt optimiser;
  const Function *function;
  std::exception_ptr *error;
};

double call(unsigned n, const double *x, double * /*gradient*/, void *data) {
  const Guarded &guarded = *static_cast<const Guarded *>(data);
  if (*guarded.error)
    return HUGE_VAL;
  try {
    return (*guarded.function)(Eigen::Map<const Vector>(x, n));
  } catch (...) {
    *guarded.error = std::current_exception();
    nlopt_force_stop(guarded.optimiser);
    return HUGE_VAL;
  }
}

void require(nlopt_result result) {
  if (result < 0)
    throw std::logic_error("NLopt rejected its arguments: " +
                           std::string(nlopt_result_to_string(result)));
}

SearchEnd end_of(nlopt_result result) {
  switch (result) {
  case NLOPT_XTOL_REACHED:
    return SearchEnd::tolerance;
  case NLOPT_FTOL_REACHED:
    return SearchEnd::objective_tolerance;
  case NLOPT_MAXEVAL_REACHED:
    return SearchEnd::evaluations;
  case NLOPT_ROUNDOFF_LIMITED:
    return SearchEnd::rounding;
  default:
    return SearchEnd::other;
  }
}

} // namespace

const std::vector<SearchMethod> &search_methods() {
  static const std::vector<SearchMethod> methods{
      {"Nelder-Mead", NLOPT_LN_NELDERMEAD, false, false, true},
      {"subplex", NLOPT_LN_SBPLX, false, false, true},
      {"BOBYQA", NLOPT_LN_BOBYQA, false, false, false},
      {"COBYLA", NLOPT_LN_COBYLA, false, true, false},
      {"DIRECT", NLOPT_GN_DIRECT_L, true, false, false},
      {"ISRES", NLOPT_GN_ISRES, true, true, true}};
  return methods;
}

const SearchMethod *search_method(const std::string &name) {
  const auto &methods = search_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const SearchMethod &method) { return method.name == name; });
  return found == methods.end() ? nullptr : &*found;
}

SearchEnd search(const SearchMethod &method, const SearchProblem &problem) {
  const auto n = static_cast<unsigned>(problem.start.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> owner(
      nlopt_create(static_cast<nlopt_algorithm>(method.algorithm), n), nlopt_destroy);
  nlopt_opt optimiser = owner.get();
  std::exception_ptr error;
  Guarded objective{optimiser, &problem.objective, &error};
  std::vector<Guarded> constraints;
  for (const Function &constraint : problem.constraints)
    constraints.push_back({optimiser, &constraint, &error});

  require(nlopt_set_lower_bounds(optimiser, problem.lower.data()));
  require(nlopt_set_upper_bounds(optimiser, problem.upper.data()));
  require(nlopt_set_initial_step(optimiser, problem.step.data()));
  require(nlopt_set_min_objective(optimiser, call, &objective));
  for (Guarded &constraint : constraints)
    require(nlopt_add_inequality_constraint(optimiser, call, &constraint,
                                            problem.constraint_tolerance));
  require(nlopt_set_xtol_abs1(optimiser, problem.tolerance));
  require(nlopt_set_ftol_rel(optimiser, problem.objective_tolerance));
  require(nlopt_set_maxeval(optimiser, problem.most_calls));
  require(nlopt_set_population(optimiser, problem.population));
  nlopt_srand(problem.seed);
  Vector x = problem.start;
  double smallest = 0;
  const nlopt_result result = nlopt_optimize(optimiser, x.data(), &smallest);
  if (error)
    std::rethrow_exception(error);
  if (result == NLOPT_INVALID_ARGS || result == NLOPT_OUT_OF_MEMORY)
    require(result);
  return end_of(result);
}

} // namespace vibroimpact::analyses
