#include "modes/normal_modes.h"

#include "modes/eigen_solver.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace vibroimpact::modes {

namespace {

constexpr int refinement_steps = 3;
// The shift that makes K - shift M positive definite must stand out of the round-off of K, yet stay
// near the lowest modes: this fraction of the largest eigenvalue is some 1e3 times the former.
constexpr double shift_fraction = 1e-12;
// Rayleigh quotients of rigid-body modes, by deformations, stay below this fraction.
constexpr double rigid_fraction = 1e-25;
// Extra modes show where the last group of equal eigenvalues ends.
constexpr int guard_modes = 4;

/// Estimate of the largest eigenvalue: max K_ii / M_ii.
double largest_eigenvalue(const EigenProblem &problem) {
  petsc::Vector stiffness;
  petsc::Vector mass;
  petsc::check(MatCreateVecs(problem.stiffness, stiffness.address(), mass.address()), "Scaling");
  petsc::check(MatGetDiagonal(problem.stiffness, stiffness.get()), "Scaling");
  petsc::check(MatGetDiagonal(problem.mass, mass.get()), "Scaling");
  const Layout layout(problem.stiffness);
  const double *k = nullptr;
  const double *m = nullptr;
  petsc::check(VecGetArrayRead(stiffness.get(), &k), "Scaling");
  petsc::check(VecGetArrayRead(mass.get(), &m), "Scaling");
  double largest = 0;
  for (int i = 0; i < layout.own; ++i)
    if (m[i] > 0)
      largest = std::max(largest, k[i] / m[i]);
  petsc::check(VecRestoreArrayRead(stiffness.get(), &k), "Scaling");
  petsc::check(VecRestoreArrayRead(mass.get(), &m), "Scaling");
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, layout.communicator);
  return largest;
}

class Search {
public:
  explicit Search(const EigenProblem &problem)
      : problem_(problem), largest_(largest_eigenvalue(problem)),
        shift_(-shift_fraction * largest_), shifted_(problem.stiffness, problem.mass, shift_) {}

  int count_below(double eigenvalue) const {
    return Factorisation(problem_.stiffness, problem_.mass, eigenvalue).eigenvalues_below();
  }

  /// The lowest modes up to a gap in the spectrum at or after number `count`.
  Eigenpairs lowest(int count) const {
    for (int asked = std::min(count + guard_modes, problem_.mass_rank);;
         asked = std::min(2 * asked, problem_.mass_rank)) {
      Eigenpairs pairs =
          refined(lowest_eigenvectors(problem_.stiffness, problem_.mass, shift_, asked));
      if (const Index end = group_end(pairs.values, count); end > 0)
        return complete(std::move(pairs), end);
    }
  }

  NormalModes result(const Eigenpairs &pairs) const {
    NormalModes modes;
    modes.eigenvalues = pairs.values;
    for (double &value : modes.eigenvalues)
      if (std::abs(value) <= rigid_fraction * largest_)
        value = 0;
    modes.shapes = gather(Layout(problem_.mass), pairs.vectors);
    modes.error_bounds = error_bounds(problem_, shifted_, shift_, pairs);
    modes.orthogonality_residual = orthogonality_residual(problem_, pairs.vectors);
    return modes;
  }

private:
  Eigenpairs refined(Block vectors) const {
    Eigenpairs pairs = rayleigh_ritz(problem_, std::move(vectors));
    for (int step = 0; step < refinement_steps; ++step)
      pairs = refine(problem_, shifted_, pairs);
    return pairs;
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
  Eigenpairs complete(Eigenpairs pairs, Index end) const {
    if (end < pairs.values.size()) {
      const double gap = (pairs.values[end - 1] + pairs.values[end]) / 2;
      const int expected = count_below(gap);
      if (expected != end) {
        pairs = refined(eigenvectors_between(problem_.stiffness, problem_.mass, shift_, gap));
        end = pairs.values.size();
      }
      if (expected != end)
        throw NumericalError("The eigen-solution found " + std::to_string(end) + " of " +
                             std::to_string(expected) + " modes");
    }
    return {pairs.values.head(end), pairs.vectors.leftCols(end)};
  }

  EigenProblem problem_;
  double largest_;
  double shift_;
  Factorisation shifted_;
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
  const Search search(problem);
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
