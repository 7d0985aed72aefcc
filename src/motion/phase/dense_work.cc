#include "motion/phase/dense_work.h"

#include "common/decompositions.h"
#include "common/memory.h"
#include "common/signals.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
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

Complex amplitude_of(const std::vector<std::size_t> &places, const double *amplitudes) {
  return {amplitudes[places[0]], places.size() > 1 ? amplitudes[places[1]] : 0};
}

} // namespace

DenseWork::DenseWork(const PowerForms &powers, const ExactPhase &phase)
    : powers_(powers), phase_(phase) {
  renew();
}

void DenseWork::renew() {
  seen_.clear();
  if (!phase_.has_dense())
    return;
  const std::vector<PhaseGroup> &groups = phase_.groups();
  double fastest_dense = 0;
  for (const PhaseGroup &group : groups) {
    seen_.push_back(seen(group));
    if (group.kind == BlockKind::dense)
      fastest_dense = std::max(fastest_dense, radius(group));
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Seen &group = seen_[g];
    group.fastest = radius(groups[g]) + fastest_dense;
    group.closed = !group.dense;
    for (std::size_t block = 0; block < groups.size() && group.closed; ++block)
      if (seen_[block].dense)
        group.closed = integrate_mixed(group, groups[g].exponent, block);
    if (!group.closed)
      group.mixed.clear();
  }
  const auto n_powers = static_cast<Index>(powers_.size());
  for (Forms *forms : {&of_dense_, &of_others_}) {
    forms->first.resize(n_powers);
    forms->second.resize(n_powers);
  }
}

std::size_t DenseWork::bytes() const {
  std::size_t sum = 0;
  for (const Seen &seen : seen_) {
    sum += bytes_of(seen.first, seen.second);
    for (const Mixed &mixed : seen.mixed)
      sum += bytes_of(mixed.coefficients);
  }
  return sum;
}

// The constants of the forms are seen of the input that is the number 1.
DenseWork::Seen DenseWork::seen(const PhaseGroup &group) const {
  const auto n_powers = static_cast<Index>(powers_.size());
  const auto size = static_cast<Index>(group.coordinates.size());
  Seen seen{.first = Matrix(n_powers, size),
            .second = Matrix(n_powers, size),
            .places = {},
            .dense = group.kind == BlockKind::dense,
            .mixed = {}};
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
    seen.places.push_back(
        static_cast<std::size_t>(phase_.places()[static_cast<std::size_t>(coordinate)]));
  }
  return seen;
}

// Re(c z) (d x) + (b x) Re(a z) = Re((c d + a b) z x) for the rows c, a of the group and d, b of
// the block. False: next to singular.
bool DenseWork::integrate_mixed(Seen &group, Complex exponent, std::size_t block) const {
  const Matrix &b = phase_.groups()[block].generator;
  // By its norm: rounding makes of the double zero of a free body a pair next to zero.
  const double size = std::abs(exponent) + b.norm();
  const ComplexVector sums = (eigenvalues(b).array() + exponent).matrix();
  if (!(sums.cwiseAbs().minCoeff() > next_to_singular * size))
    return false;
  const Eigen::MatrixXcd shifted =
      exponent * Eigen::MatrixXcd::Identity(b.rows(), b.cols()) + b.cast<Complex>();
  const auto complex_column = [&](const Matrix &rows) -> ComplexVector {
    ComplexVector column = rows.col(0).cast<Complex>();
    if (rows.cols() > 1)
      column -= Complex(0, 1) * rows.col(1).cast<Complex>();
    return column;
  };
  const ComplexVector first = complex_column(group.first);
  const ComplexVector second = complex_column(group.second);
  const Eigen::MatrixXcd products =
      first.asDiagonal() * seen_[block].second.cast<Complex>() +
      (second.asDiagonal() * seen_[block].first.cast<Complex>()).eval();
  group.mixed.push_back(
      {.block = block, .coefficients = products * LuFactors<ComplexMatrix>(shifted).inverse()});
  return true;
}

Vector DenseWork::coordinates(const Seen &of, const double *amplitudes) const {
  Vector x(static_cast<Index>(of.places.size()));
  for (std::size_t c = 0; c < of.places.size(); ++c)
    x[static_cast<Index>(c)] = amplitudes[of.places[c]];
  return x;
}

void DenseWork::add_mixed(std::size_t group, const double *start, const double *end,
                          std::vector<double> &integrals) const {
  const std::vector<std::size_t> &places = seen_[group].places;
  for (const Mixed &product : seen_[group].mixed) {
    const Seen &block = seen_[product.block];
    const ComplexVector change =
        amplitude_of(places, end) * coordinates(block, end).cast<Complex>() -
        amplitude_of(places, start) * coordinates(block, start).cast<Complex>();
    const ComplexVector all = product.coefficients * change;
    for (std::size_t p = 0; p < integrals.size(); ++p)
      integrals[p] += all[static_cast<Index>(p)].real();
  }
}

void DenseWork::see(const Seen &group, Forms &forms) const {
  const Index n = forms.first.size();
  const double *first = group.first.data();
  const double *second = group.second.data();
  for (const std::size_t place : group.places) {
    const double x = turned_[place];
    for (Index p = 0; p < n; ++p) {
      forms.first[p] += *first++ * x;
      forms.second[p] += *second++ * x;
    }
  }
}

void DenseWork::add_node(double weight, bool all, std::vector<double> &integrals) {
  for (Forms *forms : {&of_dense_, &of_others_}) {
    forms->first.setZero();
    forms->second.setZero();
  }
  for (const Seen *group : followed_)
    see(*group, group->dense ? of_dense_ : of_others_);
  for (std::size_t k = 0; k < integrals.size(); ++k) {
    const auto p = static_cast<Index>(k);
    const double first = of_dense_.first[p] + of_others_.first[p];
    const double second = of_dense_.second[p] + of_others_.second[p];
    integrals[k] +=
        weight * (all ? first * second
                      : of_dense_.first[p] * second + of_others_.first[p] * of_dense_.second[p]);
  }
}

void DenseWork::add_quadrature(const double *start, double h, bool all,
                               std::vector<double> &integrals) {
  using Rule = boost::math::quadrature::gauss<double, points>;
  const double count = std::max(1.0, std::ceil(h * fastest_ / longest_by_exponent));
  const double part = h / count;
  turned_.resize(phase_.n_amplitudes());
  const auto at = [&](double time, double weight) {
    kernel().turn(phase_.view(), start, time, turned_.data());
    add_node(weight, all, integrals);
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

// Up to four panels.
bool DenseWork::takes_all(double h) const {
  return std::all_of(seen_.begin(), seen_.end(), [&](const Seen &group) {
    return h * group.fastest <= 4 * longest_by_exponent;
  });
}

bool DenseWork::is_followed(const Seen &group, double h) const {
  return !group.closed || h * group.fastest <= longest_by_exponent;
}

void DenseWork::add(const double *start, const double *end, double h,
                    std::vector<double> &integrals) {
  const bool all = takes_all(h);
  followed_.clear();
  fastest_ = 0;
  for (std::size_t g = 0; g < seen_.size(); ++g) {
    if (!all && !is_followed(seen_[g], h)) {
      add_mixed(g, start, end, integrals);
      continue;
    }
    followed_.push_back(&seen_[g]);
    fastest_ = std::max(fastest_, seen_[g].fastest);
  }
  add_quadrature(start, h, all, integrals);
}

} // namespace vibroimpact::motion
