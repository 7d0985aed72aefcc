#include "continuation/node.h"

#include "common/decompositions.h"
#include "continuation/newton.h"

#include <algorithm>

namespace vibroimpact::continuation {

std::vector<std::complex<double>> multipliers_of(const Matrix &jacobian) {
  const auto found = try_eigenvalues(jacobian);
  if (!found)
    throw NumericalError("the multipliers do not converge");
  std::vector<std::complex<double>> values(found->begin(), found->end());
  std::stable_sort(values.begin(), values.end(),
                   [](const auto &a, const auto &b) { return std::abs(a) > std::abs(b); });
  return values;
}

namespace {

using Multipliers = std::vector<std::complex<double>>;

// Real factors mu_i mu_j - 1 of the test for Neimark-Sacker points.
void test_pairs(const Multipliers &mu, Tests &tests) {
  double sign = 1, smallest = std::numeric_limits<double>::infinity();
  const auto add = [&](double factor, bool conjugate) {
    sign *= factor < 0 ? -1 : 1;
    if (std::abs(factor) < smallest) {
      smallest = std::abs(factor);
      tests.complex_pair = conjugate;
    }
  };
  for (std::size_t i = 0; i < mu.size(); ++i) {
    if (mu[i].imag() > 0)
      add(std::norm(mu[i]) - 1, true);
    for (std::size_t j = 0; mu[i].imag() == 0 && j < i; ++j)
      if (mu[j].imag() == 0)
        add(mu[i].real() * mu[j].real() - 1, false);
  }
  if (std::isfinite(smallest))
    tests.pair = sign * smallest;
}

} // namespace

Vector tangent_of(const Matrix &slope, const Vector &ahead) {
  const Index m = slope.cols();
  Matrix bordered(m, m);
  bordered << slope, ahead.transpose();
  return solve_dense(bordered, Vector::Unit(m, m - 1)).stableNormalized();
}

Matrix map_jacobian(const Linearisation &at) {
  const Index n = at.slope.rows();
  return at.slope.leftCols(n) + Matrix::Identity(n, n);
}

Node make_node(const ScaledProblem &problem, const Vector &u, double chart, Linearisation at,
               const Vector &ahead) {
  Node node;
  node.u = u;
  node.chart = chart;
  node.tangent = tangent_of(at.slope, ahead);
  node.at = std::move(at);
  const Index n = problem.states();
  Matrix bordered(n + 1, n + 1);
  bordered << node.at.slope, node.tangent.transpose();
  node.tests.fold = node.tangent(n);
  node.tests.branch = determinant(bordered);
  if (problem.problem().is_map()) {
    const Matrix jacobian = map_jacobian(node.at);
    node.tests.flip = determinant(jacobian + Matrix::Identity(n, n));
    node.multipliers = multipliers_of(jacobian);
    const double margin = problem.problem().neutral_margin();
    if (margin == 0)
      test_pairs(node.multipliers, node.tests);
    node.unstable =
        static_cast<int>(std::count_if(node.multipliers.begin(), node.multipliers.end(),
                                       [margin](auto mu) { return std::abs(mu) > 1 + margin; }));
  }
  return node;
}

BranchPoint branch_point(const ScaledProblem &problem, const Node &node) {
  return {problem.point(node.u, node.chart),
          node.tangent,
          node.at.residual.norm(),
          node.at.pattern,
          node.multipliers,
          node.unstable,
          node.arclength};
}

Mode nearest_mode(const Matrix &jacobian, std::complex<double> value) {
  const auto nearest = [&](const Matrix &matrix) {
    const GeneralEigen modes = general_eigen(matrix);
    Index best = 0;
    (modes.values.array() - value).abs().minCoeff(&best);
    return std::pair{modes.values(best), ComplexVector(modes.vectors.col(best).normalized())};
  };
  const auto [eigenvalue, right] = nearest(jacobian);
  // Left eigenvectors: w^T J = mu w^T.
  return {eigenvalue, right, nearest(jacobian.transpose()).second};
}

} // namespace vibroimpact::continuation
