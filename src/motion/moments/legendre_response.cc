#include "motion/moments/legendre_response.h"

#include "common/decompositions.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

using Monomials = std::array<double, n_responses>;

// P_k(2 s - 1) in powers of s.
constexpr std::array<Monomials, n_responses> shifted = {{{1, 0, 0, 0, 0},
                                                         {-1, 2, 0, 0, 0},
                                                         {1, -6, 6, 0, 0},
                                                         {-1, 12, -30, 20, 0},
                                                         {1, -20, 90, -140, 70}}};
constexpr std::array<double, n_responses + 1> factorial = {1, 1, 2, 6, 24, 120};
constexpr double by_recursion = 4;

// phi_1 ... phi_5; |w| <= 4, where 30 terms of the series leave 4^30 / 35! < 1e-21.
std::array<Complex, n_responses> phi_functions(Complex w) {
  Complex last = 0;
  for (int r = 30; r > 0; --r)
    last = (last + 1.0) * w / static_cast<double>(n_responses + r);
  std::array<Complex, n_responses> phi;
  phi.back() = (last + 1.0) / factorial.back();
  for (std::size_t p = n_responses - 1; p > 0; --p)
    phi[p - 1] = 1 / factorial[p] + w * phi[p];
  return phi;
}

} // namespace

std::array<double, n_responses> shifted_legendre(double x) {
  const double y = 2 * x - 1;
  std::array<double, n_responses> p = {1, y};
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const auto degree = static_cast<double>(k);
    p[k + 1] = ((2 * degree + 1) * y * p[k] - degree * p[k - 1]) / (degree + 1);
  }
  return p;
}

LegendreResponses legendre_responses(Complex z, double x) {
  LegendreResponses j{};
  if (std::abs(z) < by_recursion) {
    const std::array<Complex, n_responses> phi = phi_functions(z * x);
    double power = 1;
    for (std::size_t p = 0; p < phi.size(); ++p) {
      power *= x;
      const Complex monomial = power * factorial[p] * phi[p];
      for (std::size_t k = p; k < j.size(); ++k)
        j[k] += shifted[k][p] * monomial;
    }
    return j;
  }
  const std::array<double, n_responses> p = shifted_legendre(x);
  j[0] = (std::exp(z * x) - 1.0) / z;
  j[1] = (2.0 * j[0] - (p[1] + 1) - (std::exp(z * x) - 1.0)) / z;
  for (std::size_t k = 1; k + 1 < j.size(); ++k)
    j[k + 1] = j[k - 1] + (2 * (2 * static_cast<double>(k) + 1) * j[k] - p[k + 1] + p[k - 1]) / z;
  return j;
}

// phi_1 ... of Z x stand in the first row of the exponential of [Z x, I; 0, 0, I; ...].
std::array<Matrix, n_responses> legendre_responses(const Matrix &z, double x) {
  const Index n = z.rows();
  Matrix augmented = Matrix::Zero((n_responses + 1) * n, (n_responses + 1) * n);
  augmented.topLeftCorner(n, n) = z * x;
  for (Index p = 0; p < n_responses; ++p)
    augmented.block(p * n, (p + 1) * n, n, n).setIdentity();
  const Matrix all = exponential(augmented);
  std::array<Matrix, n_responses> j;
  j.fill(Matrix::Zero(n, n));
  double power = 1;
  for (std::size_t p = 0; p < j.size(); ++p) {
    power *= x;
    const Matrix monomial =
        power * factorial[p] * all.block(0, (static_cast<Index>(p) + 1) * n, n, n);
    for (std::size_t k = p; k < j.size(); ++k)
      j[k] += shifted[k][p] * monomial;
  }
  return j;
}

} // namespace vibroimpact::motion
