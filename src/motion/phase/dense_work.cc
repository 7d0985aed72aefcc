#include "motion/phase/dense_work.h"

#include "common/decompositions.h"
#include "common/memory.h"
#include "common/signals.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr unsigned points = 7;
// 6.5e-20 x^14 is below 1e-13 there: (7!)^4 / (15 (14!)^3), relative to the integral of the bound.
constexpr double longest_by_exponent = 2.7;
// (e + B)^-1 loses no more than three digits.
constexpr double next_to_singular = 1e-3;

double radius(const PhaseGroup &group) {
  return group.kind == BlockKind::dense ? eigenvalues(group.generator).cwiseAbs().maxCoeff()
                                        : std::abs(group.exponent);
}

Complex exponential(Complex z) { return std::polar(std::exp(z.real()), z.imag()); }

} // namespace

DenseWork::DenseWork(const PowerForms &powers, const ExactPhase &phase)
    : powers_(powers), phase_(phase) {
  renew();
}

void DenseWork::renew() {
  seen_.clear();
  mixed_.clear();
  quadrature_.clear();
  followed_.clear();
  fastest_ = 0;
  if (!phase_.has_dense())
    return;
  for (const PhaseGroup &group : phase_.groups())
    seen_.push_back(seen(group));
  moved_.resize(seen_.size());
  list_products();
}

std::size_t DenseWork::bytes() const {
  std::size_t sum = 0;
  for (const Seen &seen : seen_)
    sum += bytes_of(seen.first, seen.second);
  for (const Mixed &mixed : mixed_)
    sum += bytes_of(mixed.coefficients);
  return sum;
}

// The constants of the forms are seen of the input that is the number 1.
DenseWork::Seen DenseWork::seen(const PhaseGroup &group) const {
  const auto n_powers = static_cast<Index>(powers_.size());
  const auto size = static_cast<Index>(group.coordinates.size());
  Seen seen{Matrix(n_powers, size), Matrix(n_powers, size)};
  for (Index c = 0; c < size; ++c) {
    const Index coordinate = group.coordinates[static_cast<std::size_t>(c)];
    const bool is_one = coordinate == phase_.n_modes();
    Vector all = powers_.rows() * phase_.columns().col(coordinate);
    if (is_one)
      all += powers_.constants();
    for (Index p = 0; p < n_powers; ++p) {
      seen.first(p, c) = all[2 * p];
      seen.second(p, c) = all[2 * p + 1];
    }
  }
  return seen;
}

void DenseWork::list_products() {
  const std::vector<PhaseGroup> &groups = phase_.groups();
  std::vector<char> is_followed(groups.size(), 0);
  for (std::size_t block = 0; block < groups.size(); ++block) {
    if (groups[block].kind != BlockKind::dense)
      continue;
    for (std::size_t other = 0; other <= block; ++other) {
      if (groups[other].kind != BlockKind::dense && integrate_mixed(other, block))
        continue;
      quadrature_.push_back({other, block});
      is_followed[other] = is_followed[block] = 1;
      fastest_ = std::max(fastest_, radius(groups[other]) + radius(groups[block]));
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (is_followed[g] != 0)
      followed_.push_back(g);
}

// Re(c z) (d x) + (b x) Re(a z) = Re((c d + a b) z x) for the rows c, a of the group and d, b of
// the block. False: next to singular.
bool DenseWork::integrate_mixed(std::size_t group, std::size_t block) {
  const PhaseGroup &of = phase_.groups()[group];
  const Matrix &b = phase_.groups()[block].generator;
  // By its norm: rounding makes of the double zero of a free body a pair next to zero.
  const double size = std::abs(of.exponent) + b.norm();
  const ComplexVector sums = (eigenvalues(b).array() + of.exponent).matrix();
  if (!(sums.cwiseAbs().minCoeff() > next_to_singular * size))
    return false;
  const Eigen::MatrixXcd shifted =
      of.exponent * Eigen::MatrixXcd::Identity(b.rows(), b.cols()) + b.cast<Complex>();
  const auto complex_column = [&](const Matrix &rows) -> ComplexVector {
    ComplexVector column = rows.col(0).cast<Complex>();
    if (of.kind == BlockKind::pair)
      column -= Complex(0, 1) * rows.col(1).cast<Complex>();
    return column;
  };
  const ComplexVector first = complex_column(seen_[group].first);
  const ComplexVector second = complex_column(seen_[group].second);
  const Eigen::MatrixXcd products =
      first.asDiagonal() * seen_[block].second.cast<Complex>() +
      (second.asDiagonal() * seen_[block].first.cast<Complex>()).eval();
  mixed_.push_back({.group = group,
                    .block = block,
                    .coefficients = products * LuFactors<ComplexMatrix>(shifted).inverse()});
  return true;
}

Complex DenseWork::amplitude(std::size_t group, const double *amplitudes) const {
  const PhaseGroup &of = phase_.groups()[group];
  const double imaginary =
      of.kind == BlockKind::pair ? amplitudes[phase_.view().n_padded + of.first] : 0;
  return {amplitudes[of.first], imaginary};
}

Vector DenseWork::coordinates(std::size_t group, const double *amplitudes) const {
  const std::vector<Index> &list = phase_.groups()[group].coordinates;
  Vector x(static_cast<Index>(list.size()));
  for (std::size_t c = 0; c < list.size(); ++c)
    x[static_cast<Index>(c)] = amplitudes[phase_.places()[static_cast<std::size_t>(list[c])]];
  return x;
}

void DenseWork::add_mixed(const double *start, const double *end,
                          std::vector<double> &integrals) const {
  for (const Mixed &product : mixed_) {
    const ComplexVector change =
        amplitude(product.group, end) * coordinates(product.block, end).cast<Complex>() -
        amplitude(product.group, start) * coordinates(product.block, start).cast<Complex>();
    const ComplexVector all = product.coefficients * change;
    for (std::size_t p = 0; p < integrals.size(); ++p)
      integrals[p] += all[static_cast<Index>(p)].real();
  }
}

void DenseWork::add_node(double weight, std::vector<double> &integrals) const {
  for (const auto &[group, block] : quadrature_)
    for (std::size_t p = 0; p < integrals.size(); ++p) {
      const auto row = static_cast<Index>(p);
      const auto factor = [&](std::size_t of, const Matrix Seen::*which) {
        return (seen_[of].*which).row(row).dot(moved_[of]);
      };
      double product = factor(group, &Seen::first) * factor(block, &Seen::second);
      if (group != block)
        product += factor(block, &Seen::first) * factor(group, &Seen::second);
      integrals[p] += weight * product;
    }
}

void DenseWork::add_quadrature(const double *start, double h, std::vector<double> &integrals) {
  using Rule = boost::math::quadrature::gauss<double, points>;
  const double count = std::max(1.0, std::ceil(h * fastest_ / longest_by_exponent));
  const double part = h / count;
  const auto at = [&](double time, double weight) {
    for (const std::size_t g : followed_) {
      const PhaseGroup &group = phase_.groups()[g];
      if (group.kind == BlockKind::dense) {
        moved_[g] = vibroimpact::exponential(time * group.generator) * coordinates(g, start);
      } else {
        const Complex z = amplitude(g, start) * exponential(group.exponent * time);
        moved_[g] = coordinates(g, start);
        moved_[g][0] = z.real();
        if (group.kind == BlockKind::pair)
          moved_[g][1] = z.imag();
      }
    }
    add_node(weight, integrals);
  };
  for (double k = 0; k < count; ++k) {
    leave_if_stopped();
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double offset = 0.5 * Rule::abscissa()[i];
      const double weight = 0.5 * part * Rule::weights()[i];
      at((k + 0.5 + offset) * part, weight);
      if (offset != 0)
        at((k + 0.5 - offset) * part, weight);
    }
  }
}

void DenseWork::add(const double *start, const double *end, double h,
                    std::vector<double> &integrals) {
  add_mixed(start, end, integrals);
  if (!quadrature_.empty())
    add_quadrature(start, h, integrals);
}

} // namespace vibroimpact::motion
