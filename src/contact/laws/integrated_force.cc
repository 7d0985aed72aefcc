#include "contact/laws/integrated_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace vibroimpact::contact {

namespace {

constexpr int order = 16;           // of the polynomials
constexpr int octaves = 60;         // pieces that halve towards zero
constexpr int deepest = 40;         // halvings of one of them
constexpr double converged = 1e-14; // last coefficients over the largest value
constexpr std::size_t most_pieces = 4000;

using Nodes = std::array<double, order + 1>;

Nodes chebyshev_coefficients(const Nodes &values) {
  Nodes coefficients{};
  for (int k = 0; k <= order; ++k) {
    double sum = 0;
    for (int j = 0; j <= order; ++j) {
      const double share = j == 0 || j == order ? 0.5 : 1;
      sum +=
          share * values[static_cast<std::size_t>(j)] * std::cos(std::numbers::pi * j * k / order);
    }
    coefficients[static_cast<std::size_t>(k)] = sum * 2 / order;
  }
  coefficients[0] *= 0.5;
  coefficients[order] *= 0.5;
  return coefficients;
}

// Integral of sum c_k T_k from -1 on.
std::vector<double> integral_of(const Nodes &c) {
  std::vector<double> integral(order + 2, 0.0);
  const auto at = [&](int k) { return k <= order ? c[static_cast<std::size_t>(k)] : 0.0; };
  double start = 0;
  for (int k = 1; k <= order + 1; ++k) {
    const double below = k == 1 ? 2 * at(0) : at(k - 1);
    integral[static_cast<std::size_t>(k)] = (below - at(k + 1)) / (2 * k);
    start += (k % 2 == 0 ? 1 : -1) * integral[static_cast<std::size_t>(k)];
  }
  integral[0] = -start;
  return integral;
}

} // namespace

IntegratedForce::IntegratedForce(std::function<double(double)> force, double range)
    : force_(std::move(force)), range_(range) {
  for (int k = 0; k <= order; ++k)
    largest_ = std::max(largest_, std::abs(force_(range * k / order)));
  double end = std::ldexp(range, -octaves);
  add(0, end, deepest);
  for (int k = 0; k < octaves; ++k, end *= 2)
    add(end, 2 * end, 0);
}

void IntegratedForce::add(double begin, double end, int depth) {
  Nodes values{};
  for (int j = 0; j <= order; ++j)
    values[static_cast<std::size_t>(j)] =
        force_(0.5 * (begin + end) + 0.5 * (end - begin) * std::cos(std::numbers::pi * j / order));
  double size = 0;
  for (const double value : values)
    size = std::max(size, std::abs(value));
  largest_ = std::max(largest_, size);
  const Nodes coefficients = chebyshev_coefficients(values);
  const double tail = std::abs(coefficients[order]) + std::abs(coefficients[order - 1]);
  if (depth < deepest && pieces_.size() < most_pieces && tail > converged * size) {
    add(begin, 0.5 * (begin + end), depth + 1);
    add(0.5 * (begin + end), end, depth + 1);
    return;
  }
  const double before =
      pieces_.empty() ? 0 : pieces_.back().before + within(pieces_.back(), pieces_.back().end);
  pieces_.push_back({begin, end, before, integral_of(coefficients)});
}

double IntegratedForce::within(const Piece &piece, double penetration) {
  const double half = 0.5 * (piece.end - piece.begin);
  const double x = (penetration - piece.begin) / half - 1;
  double next = 0, second = 0;
  for (std::size_t k = piece.coefficients.size() - 1; k > 0; --k)
    second = std::exchange(next, 2 * x * next - second + piece.coefficients[k]);
  return half * (x * next - second + piece.coefficients[0]);
}

double IntegratedForce::operator()(double penetration) const {
  const auto above = std::upper_bound(pieces_.begin() + 1, pieces_.end(), penetration,
                                      [](double u, const Piece &piece) { return u < piece.begin; });
  const Piece &piece = *(above - 1);
  if (penetration <= range_)
    return piece.before + within(piece, penetration);
  // Only trial states of a step are there: Simpson's rule.
  const double whole = piece.before + within(piece, range_);
  return whole +
         (penetration - range_) / 6 *
             (force_(range_) + 4 * force_(0.5 * (range_ + penetration)) + force_(penetration));
}

} // namespace vibroimpact::contact
