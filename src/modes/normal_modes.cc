#include "modes/normal_modes.h"

#include "modes/eigen_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::modes {

namespace {

// Refinement goes on while it helps and the bounds of the relative errors exceed the first figure.
// A result beyond the second one means that round-off hid the modes from the eigen-solver; a larger
// subspace then catches them.
constexpr double wanted_error = 1e-11;
constexpr double accepted_error = 1e-8;
constexpr int most_refinements = 10;
constexpr int most_enlargements = 3;
// The shift that makes K - shift M positive definite must stand out of the round-off of K, yet stay
// near the lowest modes: this fraction of the largest eigenvalue is some 1e3 times the former.
constexpr double shift_fraction = 1e-12;
// Rayleigh quotients of rigid-body modes, by deformations, stay below this fraction.
constexpr double rigid_fraction = 1e-25;
// Extra modes show where the last group of equal eigenvalues ends.
constexpr int guard_modes = 4;

/// Estimate of the largest eigenvalue: max K_ii / M_ii.
double largest_eigenvalue(const EigenProblem &problem) {
  structure::petsc::Vector stiffness;
  structure::petsc::Vector mass;
  structure::petsc::check(MatCreateVecs(problem.stiffness, stiffness.address(), mass.address()),
                          "Scaling");
  structure::petsc::check(MatGetDiagonal(problem.stiffness, stiffness.get()), "Scaling");
  structure::petsc::check(MatGetDiagonal(problem.mass, mass.get()), "Scaling");
  const Layout layout(problem.stiffness);
  const double *k = nullptr;
  const double *m = nullptr;
  structure::petsc::check(VecGetArrayRead(stiffness.get(), &k), "Scaling");
  structure::petsc::check(VecGetArrayRead(mass.get(), &m), "Scaling");
  double largest = 0;
  for (int i = 0; i < layout.own; ++i)
    if (m[i] > 0)
      largest = std::max(largest, k[i] / m[i]);
  structure::petsc::check(VecRestoreArrayRead(stiffness.get(), &k), "Scaling");
  structure::petsc::check(VecRestoreArrayRead(mass.get(), &m), "Scaling");
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, layout.communicator);
  return largest;
}

struct Solution {
  Eigenpairs pairs;
  Vector error_bounds;
};

class Search {
public:
  explicit Search(const EigenProblem &problem)
      : problem_(problem), largest_(largest_eigenvalue(problem)),
        shift_(-shift_fraction * largest_) {}

  int count_below(double eigenvalue) const {
    return Factorisation(problem_.stiffness, problem_.mass, eigenvalue).eigenvalues_below();
  }

  /// The lowest modes up to a gap in the spectrum at or after number `count`.
  Solution lowest(int count) {
    int enlargements = 0;
    for (int asked = std::min(count + guard_modes, problem_.mass_rank);;
         asked = std::min(2 * asked, problem_.mass_rank)) {
      shifted_.reset(); // one at a time: they are what takes the memory
      FoundVectors approximate =
          lowest_eigenvectors(problem_.stiffness, problem_.mass, shift_, asked);
      shifted_ = std::move(approximate.shifted);
      Solution found = refined(std::move(approximate.vectors), count);
      const Index end = group_end(found.pairs.values, count);
      if (end == 0)
        continue;
      if (found.error_bounds.head(end).maxCoeff() <= accepted_error)
        return complete(std::move(found), end);
      if (asked == problem_.mass_rank || ++enlargements > most_enlargements)
        throw NumericalError("The lowest modes are lost in the round-off of the stiffness matrix: "
                             "the elements are too short, or too thin for their length");
    }
  }

  NormalModes result(const Solution &solution) const {
    NormalModes modes;
    modes.eigenvalues = solution.pairs.values;
    for (double &value : modes.eigenvalues)
      if (std::abs(value) <= rigid_fraction * largest_)
        value = 0;
    modes.shapes = gather(Layout(problem_.mass), solution.pairs.vectors);
    modes.error_bounds = solution.error_bounds;
    for (Index j = 0; j < modes.eigenvalues.size(); ++j)
      if (const double value = modes.eigenvalues[j]; value > 0)
        modes.error_bounds[j] *= (value - shift_) / value;
    modes.orthogonality_residual = orthogonality_residual(problem_, solution.pairs.vectors);
    return modes;
  }

private:
  /// Only the first `count` pairs, with those equal to the last of them, need be accurate.
  Solution refined(Block vectors, int count) const {
    Eigenpairs pairs = rayleigh_ritz(problem_, std::move(vectors));
    double previous = std::numeric_limits<double>::infinity();
    for (int step = 0;; ++step) {
      Correction correction = inverse_iteration(problem_, *shifted_, shift_, pairs);
      const Index end = std::max<Index>(group_end(pairs.values, count), count);
      const double error = correction.error_bounds.head(end).maxCoeff();
      if (error <= wanted_error || error > previous / 2 || step == most_refinements)
        return {std::move(pairs), std::move(correction.error_bounds)};
      previous = error;
      pairs = rayleigh_ritz(problem_, pairs.vectors - correction.step);
    }
  }

  bool separate(double lower, double upper) const {
    return upper - lower > 1e3 * multiplicity_tolerance * (std::abs(upper) - shift_);
  }

  /// Number of modes below the first gap at or after `count`; 0 when more modes are needed to see.
  Index group_end(const Vector &values, int count) const {
    for (Index end = count; end < values.size(); ++end)
      if (separate(values[end - 1], values[end]))
        return end;
    return values.size() >= problem_.mass_rank ? values.size() : 0;
  }

  /// Cuts the modes off at the gap after `end`, having made sure that they are all there.
  Solution complete(Solution found, Index end) {
    shifted_.reset();
    if (end < found.pairs.values.size()) {
      const double gap = (found.pairs.values[end - 1] + found.pairs.values[end]) / 2;
      const int expected = count_below(gap);
      if (expected != end) {
        Block vectors = all_below(gap, expected);
        shifted_.emplace(problem_.stiffness, problem_.mass, shift_);
        found = refined(std::move(vectors), expected);
      }
      end = expected;
    }
    return {{found.pairs.values.head(end), found.pairs.vectors.leftCols(end)},
            found.error_bounds.head(end)};
  }

  Block all_below(double eigenvalue, int expected) const {
    Block vectors = eigenvectors_between(problem_.stiffness, problem_.mass, shift_, eigenvalue);
    if (vectors.cols() != expected)
      throw NumericalError("The eigen-solution found " + std::to_string(vectors.cols()) + " of " +
                           std::to_string(expected) + " modes");
    return vectors;
  }

  EigenProblem problem_;
  double largest_;
  double shift_;
  std::optional<Factorisation> shifted_; ///< K - shift M, while vectors are made better with it
};

// A mode on the edge of the band belongs to it, whatever the last digit of its frequency.
constexpr double band_tolerance = 1e-9;

void select_band(NormalModes &modes, const std::array<double, 2> &band) {
  const Vector omega = modes.eigenvalues.array().max(0.0).sqrt();
  const double lower = band[0] * (1 - band_tolerance);
  const double upper = band[1] * (1 + band_tolerance);
  modes.first = (omega.array() < lower).count();
  modes.number = (omega.array() <= upper).count() - modes.first;
}

} // namespace

TooManyModes::TooManyModes(int available_modes)
    : std::runtime_error("there are only " + std::to_string(available_modes) + " modes"),
      available(available_modes) {}

NormalModes normal_modes(const EigenProblem &problem, const Selection &selection) {
  if (!selection.band && selection.number > problem.mass_rank)
    throw TooManyModes(problem.mass_rank);
  Search search(problem);
  int count = selection.number;
  if (selection.band) {
    const double upper = (*selection.band)[1] * (1 + 10 * band_tolerance);
    count = std::max(1, search.count_below(upper * upper));
  }
  NormalModes modes = search.result(search.lowest(count));
  modes.number = std::min<Index>(count, modes.eigenvalues.size());
  if (selection.band)
    select_band(modes, *selection.band);
  return modes;
}

} // namespace vibroimpact::modes
