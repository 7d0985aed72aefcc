#include "motion/kernel/interpolation.h"

#include "motion/kernel/kernel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

using Matrix8 = Eigen::Matrix<long double, 8, 8>;

long double extended_binomial(int n, int k) {
  long double value = 1;
  for (int i = 1; i <= k; ++i)
    value = value * (n - k + i) / i;
  return value;
}

InterpolationMatrix make() {
  Matrix8 powers = Matrix8::Zero();
  powers.topLeftCorner<3, 3>().setIdentity();
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 8; ++k)
      powers(3 + i, k) = std::pow(static_cast<long double>(interpolation_nodes[i]), k);
  Matrix8 to_bernstein = Matrix8::Zero(); // b_i = sum over k <= i of C(i, k) / C(7, k) a_k
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k <= i; ++k)
      to_bernstein(i, k) = extended_binomial(i, k) / extended_binomial(7, k);
  const Matrix8 both = to_bernstein * powers.inverse();
  InterpolationMatrix result{};
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 8; ++k)
      result[i][k] = static_cast<double>(both(i, k));
  return result;
}

// Its columns, which are contiguous.
InterpolationMatrix transposed() {
  InterpolationMatrix result{};
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t k = 0; k < 8; ++k)
      result[k][i] = interpolation_matrix()[i][k];
  return result;
}

// exp(z tau_i) of the five values.
void exponentials(std::complex<double> z, std::complex<double> *values) {
  double x[8] = {};
  double y[8] = {};
  double size[8];
  double sine[8];
  double cosine[8];
  for (std::size_t i = 0; i < 5; ++i) {
    x[i] = z.real() * interpolation_nodes[i];
    y[i] = z.imag() * interpolation_nodes[i];
  }
  kernel().exponential(x, size);
  if (std::abs(z.imag()) <= largest_angle)
    kernel().sine_cosine(y, sine, cosine);
  for (std::size_t i = 0; i < 5; ++i)
    values[i] = std::abs(z.imag()) <= largest_angle
                    ? std::complex<double>(size[i] * cosine[i], size[i] * sine[i])
                    : std::polar(size[i], y[i]);
}

void add_column(const std::array<double, 8> &column, double factor, double *sum) {
  for (std::size_t i = 0; i < 8; ++i)
    sum[i] += column[i] * factor;
}

} // namespace

const InterpolationMatrix &interpolation_matrix() {
  static const InterpolationMatrix matrix = make();
  return matrix;
}

TabulatedExponential::TabulatedExponential(std::complex<double> z) {
  static const InterpolationMatrix columns = transposed();
  std::array<std::complex<double>, 8> data = {1.0, z, 0.5 * z * z};
  exponentials(z, &data[3]);
  for (std::size_t k = 0; k < 8; ++k) {
    add_column(columns[k], data[k].real(), real);
    add_column(columns[k], data[k].imag(), imaginary);
  }
  double squared = 0;
  for (std::size_t i = 0; i < 8; ++i)
    squared = std::max(squared, real[i] * real[i] + imaginary[i] * imaginary[i]);
  largest = std::sqrt(squared);
  end = data[7];
  growth = std::max(1.0, std::exp(std::min(z.real(), 600.0)));
  const double size = std::norm(z);
  eighth = size * size * size * size;
}

} // namespace vibroimpact::motion
