#include "periodic/harmonic_grid.h"

#include "common/decompositions.h"
#include "continuation/harmonic_series.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <numbers>
#include <vector>

namespace vibroimpact::periodic {

namespace {

struct Rule {
  Vector places, weights;
  Matrix collocation;
};

// The collocation method integrates polynomials of degree nodes - 1 exactly up to each node:
// A V = W with V_jk = c_j^(k-1), W_ik = c_i^k / k.
Rule make_rule() {
  using Gauss = boost::math::quadrature::gauss<double, HarmonicGrid::nodes>;
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
    for (const double side : {-1.0, 1.0})
      points.emplace_back((1 + side * Gauss::abscissa()[i]) / 2, Gauss::weights()[i] / 2);
  std::sort(points.begin(), points.end());
  const auto n = static_cast<Index>(points.size());
  Rule rule{Vector(n), Vector(n), Matrix()};
  for (Index i = 0; i < n; ++i)
    std::tie(rule.places(i), rule.weights(i)) = points[static_cast<std::size_t>(i)];
  Matrix values(n, n), integrals(n, n);
  for (Index k = 0; k < n; ++k) {
    values.col(k) = rule.places.array().pow(static_cast<double>(k));
    integrals.col(k) =
        rule.places.array().pow(static_cast<double>(k + 1)) / static_cast<double>(k + 1);
  }
  rule.collocation =
      LuFactors<Matrix>(values.transpose()).solve(Matrix(integrals.transpose())).transpose();
  return rule;
}

const Rule &rule() {
  static const Rule rule = make_rule();
  return rule;
}

} // namespace

const Vector &HarmonicGrid::places() { return rule().places; }
const Vector &HarmonicGrid::weights() { return rule().weights; }
const Matrix &HarmonicGrid::collocation() { return rule().collocation; }

HarmonicGrid::HarmonicGrid(Index harmonics, Index intervals)
    : harmonics_{harmonics}, intervals_{intervals}, basis_(coefficients(), intervals * nodes),
      ends_(coefficients(), intervals + 1) {
  for (Index i = 0; i <= intervals; ++i)
    ends_.col(i) = continuation::harmonic_basis(begin(i), harmonics);
  for (Index i = 0; i < intervals; ++i)
    basis_.middleCols(i * nodes, nodes) = basis(begin(i), begin(i + 1));
}

double HarmonicGrid::length() const {
  return 2 * std::numbers::pi / static_cast<double>(intervals_);
}

// d cos(h phi) = -h sin(h phi), d sin(h phi) = h cos(h phi)
Matrix HarmonicGrid::rate_of(const Matrix &basis) {
  Matrix rate(basis.rows(), basis.cols());
  rate.row(0).setZero();
  for (Index h = 1; 2 * h < basis.rows(); ++h) {
    rate.row(2 * h - 1) = -static_cast<double>(h) * basis.row(2 * h);
    rate.row(2 * h) = static_cast<double>(h) * basis.row(2 * h - 1);
  }
  return rate;
}

Matrix HarmonicGrid::basis(double begin, double end) const {
  Matrix values(coefficients(), nodes);
  for (Index k = 0; k < nodes; ++k)
    values.col(k) = continuation::harmonic_basis(begin + (end - begin) * places()(k), harmonics_);
  return values;
}

} // namespace vibroimpact::periodic
