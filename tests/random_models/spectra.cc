#include "random_models/spectra.h"
#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::testing {

namespace {

using Values = Eigen::VectorXcd;

constexpr double agreement = 1e-7;

// Largest distance of pairs, the nearest ones first.
double apart(const Values &a, const Values &b) {
  std::vector<std::complex<double>> left(b.begin(), b.end());
  std::vector<std::complex<double>> open(a.begin(), a.end());
  double largest = 0;
  while (!open.empty()) {
    std::size_t i = 0, j = 0;
    for (std::size_t k = 0; k < open.size(); ++k)
      for (std::size_t l = 0; l < left.size(); ++l)
        if (std::abs(open[k] - left[l]) < std::abs(open[i] - left[j])) {
          i = k;
          j = l;
        }
    largest = std::max(largest, std::abs(open[i] - left[j]));
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(j));
  }
  return largest;
}

double apart_as_polynomials(const Values &a, const Values &b, double radius) {
  double largest = 0;
  const Index points = 4 * a.size();
  for (Index i = 0; i < points; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const std::complex<double> z = std::polar(2 * radius, angle);
    std::complex<double> ratio = 1;
    for (Index k = 0; k < a.size(); ++k)
      ratio *= (z - a[k]) / (z - b[k]);
    largest = std::max(largest, std::abs(ratio - 1.0));
  }
  return largest;
}

double bauer_fike(const Matrix &a, const Matrix &b) {
  // The real form of the vectors has their singular values twice.
  const ComplexMatrix vectors = general_eigen(b).vectors;
  const Index n = b.rows();
  Matrix both(2 * n, 2 * n);
  both << vectors.real(), -vectors.imag(), vectors.imag(), vectors.real();
  const Vector singular = singular_values(both).values;
  const double condition = singular[0] / singular[2 * n - 1];
  const double rounding = 10 * std::numeric_limits<double>::epsilon() * b.norm();
  return condition * ((a - b).norm() + rounding);
}

} // namespace

SpectraVerdict compare_spectra(const Values &own, const Matrix &a, const Matrix &b) {
  const Values other = eigenvalues(b);
  const double radius = other.cwiseAbs().maxCoeff();
  if (own.size() != other.size())
    return {.word = "different"};
  if (radius == 0)
    return {.word = own.isZero(0) ? "equal" : "different"};
  SpectraVerdict verdict{.word = "equal",
                         .apart = apart(own, other) / radius,
                         .polynomial = apart_as_polynomials(own, other, radius),
                         .bound = bauer_fike(a, b) / radius};
  if (!(verdict.apart <= agreement))
    verdict.word = verdict.polynomial <= agreement  ? "equal as a polynomial"
                   : verdict.apart <= verdict.bound ? "equal but for rounding"
                                                    : "different";
  return verdict;
}

} // namespace vibroimpact::testing
