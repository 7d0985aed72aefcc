#include "motion/collocation/whole_contact.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace vibroimpact::motion {

namespace {

constexpr std::array<int, 5> node_counts = {8, 10, 12, 16, 20};
constexpr int first_nodes = 12;
constexpr int most_sweeps = 12;
// So many contacts in a row with so small a part of the error allowed, and fewer nodes will do.
constexpr int steps_before_fewer = 4;
constexpr double good_error = 1e-5;
constexpr double good_error_between = 0.01;
constexpr int fewest_terms = 8;
// Beyond that the terms of the Taylor series are so large that their sum loses digits.
constexpr double largest_theta = 8;

// Of two free bodies under F = k u^n: T v / u_max = 2 integral of ds / sqrt(1 - s^(n+1)) over [0,
// 1].
double length_of_free_contact(double n) {
  const double part = 1 / (n + 1);
  return 2 * std::sqrt(std::numbers::pi) * std::tgamma(1 + part) / std::tgamma(0.5 + part);
}

// Sum of the first terms of a Taylor series that is left out: 2 theta^(K-1) / (K+1)! of the whole.
int terms_for(double theta, double tolerance) {
  double left = 1.0 / 3;
  for (int k = 2; k < WholeContact::most_terms; ++k) {
    if (left * theta < tolerance && k >= fewest_terms)
      return std::min(k + 1, WholeContact::most_terms);
    left *= theta / (k + 2);
  }
  return WholeContact::most_terms;
}

} // namespace

WholeContact::WholeContact(const ForcedOutput &penetration, const ContactForce &force, double begin,
                           double end, double tolerance)
    : output_(penetration), force_(force), begin_(begin), end_(end), tolerance_(tolerance),
      tolerance_of_newton_(std::clamp(0.1 * tolerance, 1e-13, 1e-8)),
      exponent_(force.elastic().exponent),
      mass_(-1 / (penetration.responses()[1] * penetration.flow().fastest())) {
  choose_nodes(first_nodes);
}

void WholeContact::forget() {
  has_shape_ = has_inverse_ = false;
  fewest_nodes_ = node_counts.front();
  choose_nodes(first_nodes);
  good_steps_ = 0;
}

// The shape goes along to other nodes.
void WholeContact::choose_nodes(int nodes) {
  if (nodes == n_)
    return;
  ForceTools *const before = tools_;
  tools_ = &force_tools({.begin = begin_, .end = end_, .nodes = nodes});
  if (has_shape_) {
    std::vector<double> shape(static_cast<std::size_t>(nodes));
    const GaussRule &rule = tools_->family.rule();
    for (int j = 0; j < nodes; ++j) {
      const LongArray functions = before->family.functions(rule.nodes[j], rule.rest[j]);
      long double sum = 0;
      for (int i = 0; i < n_; ++i)
        sum += functions[i] * shape_[static_cast<std::size_t>(i)];
      shape[static_cast<std::size_t>(j)] = static_cast<double>(sum);
    }
    shape_ = std::move(shape);
  }
  n_ = nodes;
  has_inverse_ = false;
  good_steps_ = 0;
}

Refusal WholeContact::solve(const double *x, double longest) {
  start_ = x;
  known_coefficients_ = 0;
  if (good_steps_ >= steps_before_fewer && n_ > fewest_nodes_)
    choose_nodes(*std::prev(std::lower_bound(node_counts.begin(), node_counts.end(), n_)));
  while (true) {
    const Refusal refusal = solve_with_present_nodes(longest);
    const auto more = std::upper_bound(node_counts.begin(), node_counts.end(), n_);
    if (refusal != Refusal::too_coarse || more == node_counts.end())
      return refusal;
    fewest_nodes_ = *more;
    choose_nodes(*more);
  }
}

// What was learned from a contact of another kind may lead nowhere.
Refusal WholeContact::solve_with_present_nodes(double longest) {
  const bool learned = has_shape_ || has_inverse_;
  if (!begin(longest))
    return Refusal::no_approach;
  guess();
  Refusal refusal = iterate(longest);
  if (refusal != Refusal::none && learned) {
    has_shape_ = has_inverse_ = false;
    guess();
    refusal = iterate(longest);
  }
  return refusal == Refusal::none ? judge() : refusal;
}

bool WholeContact::begin(double longest) {
  if (known_coefficients_ == 0) {
    known_coefficients_ = fewest_terms;
    output_.free_motion(start_, known_coefficients_, coefficients_.data());
    coefficients_[0] = 0; // as far as the instant is known
  }
  speed_ = coefficients_[1] * output_.flow().fastest();
  sweeps_ = 0;
  return speed_ > 0 && std::isfinite(speed_) && mass_ > 0 && longest > 0;
}

void WholeContact::guess() {
  const double power = (exponent_ - 1) / (exponent_ + 1);
  if (!has_shape_) {
    guess_anew();
    return;
  }
  duration_ = length_scale_ * std::pow(speed_, -power);
  const double unit = mass_ * speed_ / duration_;
  for (int j = 0; j < n_; ++j)
    forces_[static_cast<std::size_t>(j)] = unit * shape_[static_cast<std::size_t>(j)];
}

// Free bodies, with a penetration like the half of a sine.
void WholeContact::guess_anew() {
  const contact::ElasticForce elastic = force_.elastic();
  const double largest = std::pow(
      (exponent_ + 1) * mass_ * speed_ * speed_ / (2 * elastic.stiffness), 1 / (exponent_ + 1));
  duration_ = length_of_free_contact(exponent_) * largest / speed_;
  for (int j = 0; j < n_; ++j) {
    const double angle = std::numbers::pi * tools_->family.nodes()[j];
    penetrations_[static_cast<std::size_t>(j)] = largest * std::sin(angle);
    rates_[static_cast<std::size_t>(j)] = speed_ * std::cos(angle);
  }
  force_.evaluate(n_, penetrations_.data(), rates_.data(), law_);
  std::copy_n(law_.force.begin(), n_, forces_.begin());
}

// False: the system turns too far within the step.
bool WholeContact::choose_terms(double theta) {
  if (!(theta <= largest_theta))
    return false;
  terms_ = terms_for(theta, 0.003 * tolerance_of_newton_);
  if (terms_ > known_coefficients_) {
    output_.free_motion(start_, terms_, coefficients_.data());
    coefficients_[0] = 0;
    known_coefficients_ = terms_;
  }
  tools_->at_nodes.require(terms_);
  return true;
}

Refusal WholeContact::iterate(double longest) {
  constexpr double margin = 1.3; // so that the corrections of T need no more terms
  double before = 1;
  bool fresh_inverse = false;
  double chosen = 0;
  changed_ = 1;
  higher_share_ = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    const double theta = output_.flow().fastest() * duration_;
    if (theta > chosen) {
      chosen = std::min(std::max(margin * theta, 0.0), std::max(theta, largest_theta));
      if (!choose_terms(chosen))
        return Refusal::too_fast;
      changed_ = 1;
    }
    evaluate();
    find_residual();
    const bool fresh = !has_inverse_;
    if (fresh)
      factorise();
    const double size = correct();
    if (!std::isfinite(size) || !(duration_ < 4 * longest))
      return std::isfinite(size) ? Refusal::too_long : Refusal::no_solution;
    const double ratio = size / before;
    // What the last sweep has found of the law is as far behind as its correction.
    constexpr double last_correction = 100;
    if (sweep > 0 &&
        (size < tolerance_of_newton_ || (ratio < 0.3 && ratio * size < 0.3 * tolerance_of_newton_ &&
                                         size < last_correction * tolerance_of_newton_)))
      return duration_ < longest ? Refusal::none : Refusal::too_long;
    // The inverse is that of another place.
    const bool moved_far = (fresh || fresh_inverse) && size > 0.03;
    if (moved_far || (sweep > 0 && ratio > 0.2))
      has_inverse_ = false;
    fresh_inverse = fresh;
    before = size;
  }
  return Refusal::no_solution;
}

void WholeContact::evaluate() {
  ++sweeps_;
  const double theta = output_.flow().fastest() * duration_;
  double power = 1;
  for (int k = 0; k < terms_; ++k, power *= theta)
    powers_[static_cast<std::size_t>(k)] = output_.responses()[k] * power;
  add_free_motion();
  add_forced_motion();
  force_.evaluate(n_, penetrations_.data(), rates_.data(), law_);
}

// Horner's rule at all nodes and the end.
void WholeContact::add_free_motion() {
  const double theta = output_.flow().fastest() * duration_;
  const double rate = output_.flow().fastest();
  for (int i = 0; i <= n_; ++i) {
    const double s = i < n_ ? theta * tools_->family.nodes()[i] : theta;
    double value = 0;
    double slope = 0;
    double half_bend = 0;
    for (int k = terms_; k-- > 0;) {
      half_bend = slope + s * half_bend;
      slope = value + s * slope;
      value = coefficients_[static_cast<std::size_t>(k)] + s * value;
    }
    const auto at = static_cast<std::size_t>(i);
    penetrations_[at] = value;
    free_rates_[at] = rates_[at] = rate * slope;
    free_accelerations_[at] = 2 * rate * rate * half_bend;
  }
}

// The terms beyond the first are those of the system; they change little from sweep to sweep.
void WholeContact::add_forced_motion() {
  const Index targets = n_ + 1;
  const ConstVectorView forces(forces_.data(), n_);
  const Matrix &terms = tools_->at_nodes.terms();
  VectorView(first_.data(), targets).noalias() =
      duration_ * powers_[1] * (terms.middleCols(n_, n_) * forces);
  VectorView(first_rates_.data(), targets).noalias() = powers_[1] * (terms.leftCols(n_) * forces);
  if (changed_ * higher_share_ > 0.3 * tolerance_of_newton_)
    renew_higher_terms();
  for (std::size_t i = 0; i < static_cast<std::size_t>(targets); ++i) {
    penetrations_[i] += first_[i] + higher_[i];
    rates_[i] += first_rates_[i] + higher_rates_[i];
  }
}

void WholeContact::renew_higher_terms() {
  const Index targets = n_ + 1;
  const Index columns = static_cast<Index>(terms_ - 2) * n_;
  weighted_.resize(columns);
  for (int k = 2; k < terms_; ++k)
    for (int j = 0; j < n_; ++j)
      weighted_[(k - 2) * n_ + j] =
          powers_[static_cast<std::size_t>(k)] * forces_[static_cast<std::size_t>(j)];
  const Matrix &terms = tools_->at_nodes.terms();
  VectorView higher(higher_.data(), targets);
  higher.noalias() = duration_ * (terms.middleCols(2 * n_, columns) * weighted_);
  VectorView(higher_rates_.data(), targets).noalias() = terms.middleCols(n_, columns) * weighted_;
  const double largest = ConstVectorView(first_.data(), targets).cwiseAbs().maxCoeff();
  higher_share_ = largest > 0 ? std::min(1.0, 4 * higher.cwiseAbs().maxCoeff() / largest) : 1;
  changed_ = 0;
}

void WholeContact::find_residual() {
  const double unit = mass_ * speed_ / duration_;
  residual_.resize(n_ + 1);
  for (int i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    residual_[i] = (law_.force[at] - forces_[at]) / unit;
  }
  residual_[n_] = -penetrations_[static_cast<std::size_t>(n_)] / (speed_ * duration_);
}

// d u / d f, d u' / d f at the nodes and the end, and their derivatives by ln T.
void WholeContact::differentiate() {
  const Matrix &terms = tools_->at_nodes.terms();
  const ConstVectorView forces(forces_.data(), n_);
  by_force_.setZero(n_ + 1, n_);
  rate_by_force_.setZero(n_ + 1, n_);
  by_length_.resize(n_ + 1);
  rate_by_length_.resize(n_ + 1);
  for (int i = 0; i <= n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double t = duration_ * (i < n_ ? tools_->family.nodes()[i] : 1);
    by_length_[i] = t * free_rates_[at];
    rate_by_length_[i] = t * free_accelerations_[at];
  }
  for (int k = 1; k < terms_; ++k) {
    const double power = powers_[static_cast<std::size_t>(k)];
    const auto integral = terms.middleCols(static_cast<Index>(k) * n_, n_);
    const auto before = terms.middleCols(static_cast<Index>(k - 1) * n_, n_);
    by_force_ += duration_ * power * integral;
    rate_by_force_ += power * before;
    by_length_.noalias() += (k + 1) * duration_ * power * (integral * forces);
    rate_by_length_.noalias() += k * power * (before * forces);
  }
}

void WholeContact::factorise() {
  differentiate();
  const double unit = mass_ * speed_ / duration_;
  const double length = speed_ * duration_;
  Matrix matrix = Matrix::Identity(n_ + 1, n_ + 1);
  for (int i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double stiffness = law_.by_penetration[at];
    const double damping = law_.by_rate[at];
    matrix.row(i).head(n_) -= stiffness * by_force_.row(i) + damping * rate_by_force_.row(i);
    matrix(i, n_) = -(stiffness * by_length_[i] + damping * rate_by_length_[i]) / unit;
  }
  matrix.row(n_).head(n_) = unit / length * by_force_.row(n_);
  matrix(n_, n_) = by_length_[n_] / length;
  inverse_ = matrix.partialPivLu().inverse();
  has_inverse_ = true;
}

// Returns the size of the correction; where the inverse is spoilt, the residual shows it.
double WholeContact::correct() {
  const double unit = mass_ * speed_ / duration_;
  correction_.noalias() = inverse_ * residual_;
  const double size = correction_.cwiseAbs().maxCoeff();
  for (int j = 0; j < n_; ++j)
    forces_[static_cast<std::size_t>(j)] += unit * correction_[j];
  duration_ *= 1 + std::clamp(correction_[n_], -0.5, 1.0);
  changed_ += size;
  return std::max(size, 0.1 * residual_.cwiseAbs().maxCoeff());
}

Refusal WholeContact::judge() {
  if (!series_ends())
    return Refusal::too_fast;
  find_error();
  const bool most = n_ == node_counts.back();
  // Between the nodes the most of them need not do better.
  constexpr double tolerated_between = 10;
  if (!(error_ <= 1) || !(error_between_ <= (most ? tolerated_between : 1)))
    return Refusal::too_coarse;
  if (!tools_->family.is_positive(forces_.data()))
    return most ? Refusal::several_humps : Refusal::too_coarse;
  if (!(rates_[static_cast<std::size_t>(n_)] < 0))
    return Refusal::no_release;
  learn();
  return Refusal::none;
}

// Of systems that are far from normal the terms need not fall as those of their exponents.
bool WholeContact::series_ends() const {
  const double theta = output_.flow().fastest() * duration_;
  const double largest = *std::max_element(penetrations_.begin(), penetrations_.begin() + n_);
  const double allowed = tolerance_of_newton_;
  for (int k = terms_ - 2; k < terms_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (std::abs(coefficients_[at]) * std::pow(theta, k) > allowed * largest ||
        std::abs(powers_[at] / powers_[1]) / std::tgamma(k + 1.0) > allowed)
      return false;
  }
  return true;
}

void WholeContact::find_error() {
  double stiffness = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n_); ++i)
    if (penetrations_[i] > 0)
      stiffness = std::max(stiffness, law_.force[i] / penetrations_[i]);
  const double fastest = output_.flow().fastest();
  const double turn = 0.5 * duration_ * std::sqrt(fastest * fastest + 2 * stiffness / mass_);
  double smooth = 1;
  for (int k = 1; k <= n_; ++k)
    smooth *= turn / (2 * k - 1);
  const double tail = tools_->family.tail(forces_.data());
  error_ = tail * std::max(0.1 * tail, std::min(1.0, smooth)) / tolerance_;
  error_between_ = tail / (n_ * n_) / tolerance_;
}

void WholeContact::learn() {
  const double unit = mass_ * speed_ / duration_;
  shape_.resize(static_cast<std::size_t>(n_));
  for (int j = 0; j < n_; ++j)
    shape_[static_cast<std::size_t>(j)] = forces_[static_cast<std::size_t>(j)] / unit;
  length_scale_ = duration_ * std::pow(speed_, (exponent_ - 1) / (exponent_ + 1));
  has_shape_ = true;
  good_steps_ = error_ < good_error && error_between_ < good_error_between ? good_steps_ + 1 : 0;
}

double WholeContact::impulse() const {
  return duration_ * tools_->at_nodes.term(0).row(n_).dot(ConstVectorView(forces_.data(), n_));
}

double WholeContact::dissipated() const {
  return duration_ *
         tools_->at_nodes.term(0).row(n_).dot(ConstVectorView(law_.dissipated.data(), n_));
}

std::vector<double> WholeContact::moments(ForceOperators &operators) const {
  operators.require(terms_);
  const auto count = static_cast<std::size_t>(terms_);
  std::vector<double> list(count * static_cast<std::size_t>(operators.n_targets()));
  const ConstVectorView forces(forces_.data(), n_);
  Eigen::Map<Matrix> of(list.data(), terms_, operators.n_targets());
  for (int k = 0; k < terms_; ++k)
    of.row(k).noalias() = (operators.term(k) * forces).transpose();
  return list;
}

std::vector<double> WholeContact::end_moments() const {
  std::vector<double> list(static_cast<std::size_t>(terms_));
  const ConstVectorView forces(forces_.data(), n_);
  for (int k = 0; k < terms_; ++k)
    list[static_cast<std::size_t>(k)] = tools_->at_nodes.term(k).row(n_).dot(forces);
  return list;
}

} // namespace vibroimpact::motion
