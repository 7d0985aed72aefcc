#include "motion/episode/contact_episode.h"

#include "common/decompositions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace vibroimpact::motion {

namespace {

constexpr std::array<int, 7> node_counts = {8, 10, 12, 16, 20, 24, 32};
constexpr int most_nodes = 20;
constexpr int most_nodes_of_rough_force = 32;
// The fourth root of time would take out the singularities of t^(1/4) and t^(9/4), but as a
// parameter it makes all else steep. In the square root the quotient f / w begins with smooth terms
// and xi^(5/2): twenty nodes leave 1e-6 of it, against 1e-4.
constexpr int highest_root = 2;
constexpr int most_sweeps = 12;
// So many contacts in a row with so small a part of the error allowed, and fewer nodes will do.
constexpr int steps_before_fewer = 4;
constexpr double good_error = 1e-5;
constexpr double good_error_between = 0.01;
constexpr int fewest_terms = 8;
// Beyond that the terms of the Taylor series are so large that their sum loses digits.
constexpr double largest_theta = 8;

// Sum of the first terms of a Taylor series that is left out: 2 theta^(K-1) / (K+1)! of the whole.
int terms_for(double theta, double tolerance) {
  double left = 1.0 / 3;
  for (int k = 2; k < ContactEpisode::most_terms; ++k) {
    if (left * theta < tolerance && k >= fewest_terms)
      return std::min(k + 1, ContactEpisode::most_terms);
    left *= theta / (k + 2);
  }
  return ContactEpisode::most_terms;
}

} // namespace

// F = k u^n: T v / u_max = 2 integral of ds / sqrt(1 - s^(n+1)) over [0, 1].
double free_contact_duration(const contact::ElasticForce &elastic, double mass, double speed) {
  const double n = elastic.exponent;
  const double part = 1 / (n + 1);
  const double deepest = std::pow((n + 1) * mass * speed * speed / (2 * elastic.stiffness), part);
  const double length =
      2 * std::sqrt(std::numbers::pi) * std::tgamma(1 + part) / std::tgamma(0.5 + part);
  return length * deepest / speed;
}

ContactEpisode::ContactEpisode(const ForcedOutput &penetration, const ContactForce &force,
                               const contact::ForceEdge &begin, const contact::ForceEdge &end,
                               double tolerance, std::shared_ptr<Taught> taught)
    : output_(penetration), force_(force), begin_(begin), end_(end), tolerance_(tolerance),
      tolerance_of_newton_(std::clamp(0.1 * tolerance, 1e-13, 1e-8)),
      exponent_(force.elastic().exponent), taught_(std::move(taught)),
      mass_(-1 / (penetration.responses()[1] * penetration.flow().fastest())) {
  use_nodes(taught_->nodes);
}

void ContactEpisode::use_nodes(int nodes) {
  n_ = nodes;
  tools_ = &force_tools({.begin = begin_.power,
                         .end = end_.power,
                         .nodes = nodes,
                         .begin_root = std::min(begin_.root, highest_root),
                         .end_root = std::min(end_.root, highest_root)});
}

// The shape goes along to other nodes.
void ContactEpisode::choose_nodes(int nodes) {
  const ForceTools *const before = tools_;
  const int n_before = n_;
  use_nodes(nodes);
  if (taught_->has_shape) {
    std::vector<double> shape(static_cast<std::size_t>(nodes));
    const GaussRule &rule = tools_->family.rule();
    for (int j = 0; j < nodes; ++j) {
      const LongArray functions = before->family.functions(rule.nodes[j], rule.rest[j]);
      long double sum = 0;
      for (int i = 0; i < n_before; ++i)
        sum += functions[i] * taught_->shape[static_cast<std::size_t>(i)];
      shape[static_cast<std::size_t>(j)] = static_cast<double>(sum);
    }
    taught_->shape = std::move(shape);
  }
  taught_->nodes = nodes;
  taught_->has_inverse = false;
  taught_->good_steps = 0;
}

Refusal ContactEpisode::solve(const double *x, double longest) {
  start_ = x;
  known_coefficients_ = 0;
  if (taught_->nodes != n_)
    use_nodes(taught_->nodes);
  if (taught_->good_steps >= steps_before_fewer && n_ > taught_->fewest_nodes)
    choose_nodes(*std::prev(std::lower_bound(node_counts.begin(), node_counts.end(), n_)));
  while (true) {
    const Refusal refusal = solve_with_present_nodes(longest);
    const auto more = std::upper_bound(node_counts.begin(), node_counts.end(), n_);
    if (refusal != Refusal::too_coarse || n_ >= highest_count())
      return refusal;
    taught_->fewest_nodes = *more;
    choose_nodes(*more);
  }
}

// What was learned from a contact of another kind may lead nowhere.
Refusal ContactEpisode::solve_with_present_nodes(double longest) {
  const bool learned = taught_->has_shape || taught_->has_inverse;
  if (!begin(longest))
    return Refusal::no_approach;
  guess();
  Refusal refusal = iterate(longest);
  if (refusal != Refusal::none && learned) {
    taught_->has_shape = taught_->has_inverse = false;
    guess();
    refusal = iterate(longest);
  }
  return refusal == Refusal::none ? judge() : refusal;
}

bool ContactEpisode::begin(double longest) {
  if (known_coefficients_ == 0) {
    known_coefficients_ = fewest_terms;
    output_.free_motion(start_, known_coefficients_, coefficients_.data());
    coefficients_[0] = 0; // as far as the instant is known
  }
  speed_ = coefficients_[1] * output_.flow().fastest();
  sweeps_ = 0;
  return speed_ > 0 && std::isfinite(speed_) && mass_ > 0 && longest > 0;
}

void ContactEpisode::guess() {
  const double power = (exponent_ - 1) / (exponent_ + 1);
  if (!taught_->has_shape) {
    guess_anew();
    return;
  }
  duration_ = taught_->length_scale * std::pow(speed_, -power);
  const double unit = mass_ * speed_ / duration_;
  for (int j = 0; j < n_; ++j)
    forces_[static_cast<std::size_t>(j)] = unit * taught_->shape[static_cast<std::size_t>(j)];
}

// The two sides alone under the acceleration that they meet with, by the classical Runge-Kutta
// method, as far as the end of the force.
void ContactEpisode::guess_anew() {
  constexpr std::size_t steps_of_elastic_contact = 48;
  constexpr std::size_t most_steps = 10 * steps_of_elastic_contact;
  using Motion = Eigen::Vector2d; // u, u'
  const double fastest = output_.flow().fastest();
  const double free = 2 * coefficients_[2] * fastest * fastest;
  const auto slope = [&](const Motion &at) {
    force_.evaluate(1, &at[0], &at[1], law_);
    return Motion(at[1], free - law_.force[0] / mass_);
  };
  const double h =
      free_contact_duration(force_.elastic(), mass_, speed_) / steps_of_elastic_contact;
  std::vector<Motion> path = {Motion(0, speed_)};
  const auto ended = [&](const Motion &at) { return !(condition_(at[0], at[1]) > 0); };
  while (path.size() <= most_steps && (path.size() < 3 || !ended(path.back()))) {
    const Motion &from = path.back();
    const Motion k1 = slope(from);
    const Motion k2 = slope(from + 0.5 * h * k1);
    const Motion k3 = slope(from + 0.5 * h * k2);
    const Motion k4 = slope(from + h * k3);
    path.emplace_back(from + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
  const std::size_t last = path.size() - 2;
  const double before = condition_(path[last][0], path[last][1]);
  const double behind = condition_(path[last + 1][0], path[last + 1][1]);
  duration_ = h * (static_cast<double>(last) + (behind < 0 ? before / (before - behind) : 1));
  for (int j = 0; j < n_; ++j) {
    const double place = tools_->family.nodes()[j] * duration_ / h;
    const auto i = std::min(static_cast<std::size_t>(place), last);
    const double part = place - static_cast<double>(i);
    const Motion at = (1 - part) * path[i] + part * path[i + 1];
    penetrations_[static_cast<std::size_t>(j)] = at[0];
    rates_[static_cast<std::size_t>(j)] = at[1];
  }
  force_.evaluate(n_, penetrations_.data(), rates_.data(), law_);
  std::copy_n(law_.force.begin(), n_, forces_.begin());
}

// False: the system turns too far within the step.
bool ContactEpisode::choose_terms(double theta) {
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

Refusal ContactEpisode::iterate(double longest) {
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
    const bool fresh = !taught_->has_inverse;
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
      taught_->has_inverse = false;
    fresh_inverse = fresh;
    before = size;
  }
  return Refusal::no_solution;
}

void ContactEpisode::evaluate() {
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
void ContactEpisode::add_free_motion() {
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
void ContactEpisode::add_forced_motion() {
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

void ContactEpisode::renew_higher_terms() {
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

void ContactEpisode::find_residual() {
  const double unit = mass_ * speed_ / duration_;
  residual_.resize(n_ + 1);
  for (int i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    residual_[i] = (law_.force[at] - forces_[at]) / unit;
  }
  const auto end = static_cast<std::size_t>(n_);
  residual_[n_] = -condition_(penetrations_[end], rates_[end]) / end_scale();
}

// Of the form that ends the contact.
double ContactEpisode::end_scale() const {
  return speed_ * (duration_ * std::abs(condition_.by_penetration) + std::abs(condition_.by_rate));
}

// d u / d f, d u' / d f at the nodes and the end, and their derivatives by ln T.
void ContactEpisode::differentiate() {
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

void ContactEpisode::factorise() {
  differentiate();
  const double unit = mass_ * speed_ / duration_;
  const double of_value = condition_.by_penetration / end_scale();
  const double of_rate = condition_.by_rate / end_scale();
  Matrix matrix = Matrix::Identity(n_ + 1, n_ + 1);
  for (int i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double stiffness = law_.by_penetration[at];
    const double damping = law_.by_rate[at];
    matrix.row(i).head(n_) -= stiffness * by_force_.row(i) + damping * rate_by_force_.row(i);
    matrix(i, n_) = -(stiffness * by_length_[i] + damping * rate_by_length_[i]) / unit;
  }
  matrix.row(n_).head(n_) =
      unit * (of_value * by_force_.row(n_) + of_rate * rate_by_force_.row(n_));
  matrix(n_, n_) = of_value * by_length_[n_] + of_rate * rate_by_length_[n_];
  taught_->inverse = inverse(matrix);
  taught_->has_inverse = true;
}

// Returns the size of the correction; where the inverse is spoilt, the residual shows it.
double ContactEpisode::correct() {
  const double unit = mass_ * speed_ / duration_;
  correction_.noalias() = taught_->inverse * residual_;
  const double size = correction_.cwiseAbs().maxCoeff();
  for (int j = 0; j < n_; ++j)
    forces_[static_cast<std::size_t>(j)] += unit * correction_[j];
  duration_ *= 1 + std::clamp(correction_[n_], -0.5, 1.0);
  changed_ += size;
  return std::max(size, 0.1 * residual_.cwiseAbs().maxCoeff());
}

int ContactEpisode::highest_count() const {
  return is_rough() ? most_nodes_of_rough_force : most_nodes;
}

Refusal ContactEpisode::judge() {
  if (!series_ends())
    return Refusal::too_fast;
  find_error();
  const bool most = n_ >= highest_count();
  // Between the nodes the most of them need not do better.
  constexpr double tolerated_between = 10;
  if (!(error_ <= 1) || !(error_between_ <= (most ? tolerated_between : 1)))
    return Refusal::too_coarse;
  if (!ends_first())
    return most ? Refusal::several_humps : Refusal::too_coarse;
  const auto end = static_cast<std::size_t>(n_);
  if (!(rates_[end] < 0) || (!condition_.at_release() && !(penetrations_[end] > 0)))
    return Refusal::no_release;
  learn();
  return Refusal::none;
}

void ContactEpisode::learn() {
  const double unit = mass_ * speed_ / duration_;
  taught_->shape.resize(static_cast<std::size_t>(n_));
  for (int j = 0; j < n_; ++j)
    taught_->shape[static_cast<std::size_t>(j)] = forces_[static_cast<std::size_t>(j)] / unit;
  taught_->length_scale = duration_ * std::pow(speed_, (exponent_ - 1) / (exponent_ + 1));
  taught_->has_shape = true;
  taught_->good_steps =
      error_ < good_error && error_between_ < good_error_between ? taught_->good_steps + 1 : 0;
}

} // namespace vibroimpact::motion
