// A solution with its tangent and the values of the test functions, each of which changes its sign
// where the branch has a special point.
//
// | special point  | test |
// |---|---|
// | fold           | t_p |
// | branch point   | det [F_x F_p; t]: zero where F_u loses rank, regular at folds |
// | flip           | det (J + I) |
// | Neimark-Sacker | product of (mu_i mu_j - 1) over i < j: zero where |mu| = 1 for a complex pair
// |
//
// The last one has factors that are complex pairs themselves, whose product is positive, and real
// ones, of a conjugate pair or of two real multipliers. Its sign is that of the real factors; the
// smallest of them stands for its size. It is continuous where a pair becomes real, and its zero at
// two real multipliers of product 1 (a neutral saddle) is no bifurcation.
#pragma once

#include "continuation/branch.h"
#include "continuation/scaled_problem.h"

namespace vibroimpact::continuation {

struct Tests {
  double fold = 1, branch = 1, flip = 1, pair = 1;
  bool complex_pair = false; ///< the smallest factor of `pair` is that of a conjugate pair
};

struct Node {
  Vector u;
  double chart = 0;
  Vector tangent; ///< of length 1
  Linearisation at;
  Tests tests;
  std::vector<std::complex<double>> multipliers; ///< by falling modulus; empty without a map
  int unstable = 0;
  double arclength = 0;
  int iterations = 0;
};

/// Eigenvalues by falling modulus.
std::vector<std::complex<double>> multipliers_of(const Matrix &jacobian);

/// Unit null vector of `slope` (m x (m + 1)) in the half space of `ahead`.
Vector tangent_of(const Matrix &slope, const Vector &ahead);

/// Everything that follows from a solution and its linearisation.
Node make_node(const ScaledProblem &problem, const Vector &u, double chart, Linearisation at,
               const Vector &ahead);

/// A node for the interface. The residual is that of its linearisation.
BranchPoint branch_point(const ScaledProblem &problem, const Node &node);

/// Eigenvalue of `jacobian` nearest to `value` with its right and left eigenvectors, lengths 1.
struct Mode {
  std::complex<double> value;
  Eigen::VectorXcd right, left;
};
Mode nearest_mode(const Matrix &jacobian, std::complex<double> value);

/// dP/dx of a map, from its linearisation.
Matrix map_jacobian(const Linearisation &at);

} // namespace vibroimpact::continuation
