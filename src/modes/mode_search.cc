#include "modes/mode_search.h"

#include "modes/eigenvalue_bounds.h"
#include "modes/impulse_response.h"
#include "modes/normal_modes.h"
#include "modes/spectrum_slicing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::modes {

namespace {

// Refinement goes on while it helps and the bounds of the errors exceed the first figure. A result
// beyond the second one means that round-off hid the modes from the search; a larger subspace then
// catches them.
constexpr double wanted_error = 1e-11;
constexpr double accepted_error = 1e-8;
constexpr int most_refinements = 10;
constexpr int most_enlargements = 3;
// Searches for missing modes before the spectrum is sliced.
constexpr int most_searches = 3;
// The shift that makes K - shift M positive definite must stand out of the round-off of K, yet stay
// near the lowest modes: this fraction of the largest eigenvalue is some 1e3 times the former.
constexpr double search_shift_fraction = 1e-12;

double largest_eigenvalue(const EigenProblem &problem) {
  const Vector stiffness = own_diagonal(problem.stiffness);
  const Vector mass = own_diagonal(problem.mass);
  double largest = 0;
  for (Index i = 0; i < mass.size(); ++i)
    if (mass[i] > 0)
      largest = std::max(largest, stiffness[i] / mass[i]);
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX,
                Layout(problem.stiffness).communicator);
  return largest;
}

/// The bounds that are more than rounding.
Vector beyond(const Vector &bounds, const Vector &rounding) {
  return (bounds.array() > rounding.array()).select(bounds, 0.0);
}

} // namespace

ModeSearch::ModeSearch(const EigenProblem &problem)
    : problem_(problem), largest_(largest_eigenvalue(problem)),
      shift_(-search_shift_fraction * largest_) {}

int ModeSearch::count_below(double eigenvalue) {
  return problem_.factorised_at(eigenvalue).eigenvalues_below();
}

CompletePairs ModeSearch::lowest(int count) {
  int enlargements = 0;
  for (int asked = count;; asked = std::min(2 * asked, problem_.mass_rank)) {
    Refined found = refined(lowest_eigenvectors(problem_.factorised_at(shift_), problem_.mass,
                                                asked, problem_.mass_rank));
    if (beyond(found.error_bounds, found.rounding).head(count).maxCoeff() <= accepted_error)
      return group(complete(std::move(found)), count);
    if (asked == problem_.mass_rank || ++enlargements > most_enlargements)
      throw NumericalError("The lowest modes are lost in the round-off of the stiffness matrix: "
                           "the elements are too short, or too thin for their length");
  }
}

CompletePairs ModeSearch::completed(LowestVectors found) {
  Refined all = complete(refined(std::move(found)));
  return {std::move(all.pairs), std::move(all.error_bounds)};
}

ModeSearch::Refined ModeSearch::refined(LowestVectors found) {
  const Factorisation &shifted = problem_.factorised_at(shift_);
  Eigenpairs pairs = rayleigh_ritz(problem_, std::move(found.vectors));
  const Vector rounding = rounding_of(pairs);
  double previous = std::numeric_limits<double>::infinity();
  for (int step = 1;; ++step) {
    const Correction correction = inverse_iteration(problem_, shifted, pairs);
    const double gap = (pairs.values[pairs.values.size() - 1] + found.next) / 2;
    Vector bounds = quadratic_bounds(pairs.values, shift_, gap, correction.residual_products);
    Eigenpairs better = rayleigh_ritz(problem_, pairs.vectors - correction.step);
    // No Ritz value lies below its eigenvalue: one that has fallen is still within the bound.
    bounds.array() += (better.values - pairs.values).array().max(0.0) /
                      (pairs.values.array() - shift_) * (1 + bounds.array());
    const double largest = beyond(bounds, rounding).maxCoeff();
    if (largest <= wanted_error || largest > previous / 2 || step == most_refinements)
      return {std::move(better), std::move(bounds), gap, rounding};
    previous = largest;
    pairs = std::move(better);
  }
}

/// Of eigenvalues from the shift, relative.
Vector ModeSearch::rounding_of(const Eigenpairs &pairs) const {
  return rounding_deviations * rounding_of_quotients(problem_, pairs.vectors).array() /
         (pairs.values.array() - shift_);
}

/// What a count shows to be missing is found.
ModeSearch::Refined ModeSearch::complete(Refined found) {
  for (int search = 0; search <= most_searches; ++search) {
    const auto size = static_cast<int>(found.pairs.values.size());
    const int expected = size == problem_.mass_rank ? size : count_below(found.gap);
    if (expected == size)
      return found;
    if (expected < size || search == most_searches)
      return sliced(found.gap, expected);
    found = refined(lowest_eigenvectors(problem_.factorised_at(shift_), problem_.mass, expected,
                                        problem_.mass_rank, found.pairs.vectors));
  }
  return found;
}

/// All below `gap`, which are `expected`.
ModeSearch::Refined ModeSearch::sliced(double gap, int expected) {
  problem_.factorised->release(); // SLEPc makes its own
  Block vectors = eigenvectors_between(problem_.stiffness, problem_.mass, shift_, gap);
  if (vectors.cols() != expected)
    throw NumericalError("The eigen-solution found " + std::to_string(vectors.cols()) + " of " +
                         std::to_string(expected) + " modes");
  return refined({std::move(vectors), gap});
}

/// The first `count` pairs with those equal to the last of them.
CompletePairs ModeSearch::group(Refined all, int count) const {
  const Vector distance = all.pairs.values.array() - shift_;
  Index end = count;
  while (end < distance.size() &&
         distance[end] - distance[end - 1] <= least_relative_gap * distance[end])
    ++end;
  return {{all.pairs.values.head(end), all.pairs.vectors.leftCols(end)},
          all.error_bounds.head(end)};
}

} // namespace vibroimpact::modes
