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

ContactEpisode::ContactEpisode(const ForcedMotion &motion, const ContactForce &force,
                               const contact::ForceEdge &begin, const contact::ForceEdge &end,
                               double tolerance, std::shared_ptr<Taught> taught)
    : motion_(motion), d_(motion.n_directions()), force_(force), begin_(begin), end_(end),
      tolerance_(tolerance), tolerance_of_newton_(std::clamp(0.1 * tolerance, 1e-13, 1e-8)),
      exponent_(force.elastic().exponent), taught_(std::move(taught)) {
  if (d_ == 1)
    mass_ = -1 / (motion_.response(0, 0, 1) * motion_.fastest());
  use_nodes(taught_->nodes);
}

void ContactEpisode::turn_to(const TouchFrame &frame) {
  motion_.turn_to(frame);
  mass_ = -1 / (motion_.response(0, 0, 1) * motion_.fastest());
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
    std::vector<double> shape(static_cast<std::size_t>(d_ * nodes));
    const GaussRule &rule = tools_->family.rule();
    for (int j = 0; j < nodes; ++j) {
      const LongArray functions = before->family.functions(rule.nodes[j], rule.rest[j]);
      for (int d = 0; d < d_; ++d) {
        long double sum = 0;
        for (int i = 0; i < n_before; ++i)
          sum += functions[i] * taught_->shape[static_cast<std::size_t>(d * n_before + i)];
        shape[static_cast<std::size_t>(d * nodes + j)] = static_cast<double>(sum);
      }
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

// Both components are zero at the touch, as far as the instant is known.
void ContactEpisode::read_free_motion(int terms) {
  known_coefficients_ = terms;
  motion_.free_motion(start_, terms, coefficients_);
  for (ForcedMotion::Coefficients &coefficients : coefficients_)
    coefficients[0] = 0;
}

bool ContactEpisode::begin(double longest) {
  if (known_coefficients_ == 0)
    read_free_motion(fewest_terms);
  speed_ = coefficients_[0][1] * motion_.fastest();
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
  for (int d = 0; d < d_; ++d)
    for (int j = 0; j < n_; ++j)
      forces_[static_cast<std::size_t>(d)][static_cast<std::size_t>(j)] =
          unit * taught_->shape[static_cast<std::size_t>(d * n_ + j)];
}

// False: the system turns too far within the step.
bool ContactEpisode::choose_terms(double theta) {
  if (!(theta <= largest_theta))
    return false;
  terms_ = terms_for(theta, 0.003 * tolerance_of_newton_);
  if (terms_ > known_coefficients_)
    read_free_motion(terms_);
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
    const double theta = motion_.fastest() * duration_;
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

void ContactEpisode::find_residual() {
  const double unit = mass_ * speed_ / duration_;
  residual_.resize(d_ * n_ + 1);
  for (int d = 0; d < d_; ++d)
    for (int i = 0; i < n_; ++i) {
      const auto of = static_cast<std::size_t>(d);
      const auto at = static_cast<std::size_t>(i);
      residual_[d * n_ + i] = (law_.force[of][at] - forces_[of][at]) / unit;
    }
  const auto end = static_cast<std::size_t>(n_);
  residual_[d_ * n_] = -condition_(penetrations_[end], rates_[end]) / end_scale();
}

// Of the form that ends the contact.
double ContactEpisode::end_scale() const {
  return speed_ * (duration_ * std::abs(condition_.by_penetration) + std::abs(condition_.by_rate));
}

void ContactEpisode::factorise() {
  differentiate();
  Matrix matrix = Matrix::Identity(d_ * n_ + 1, d_ * n_ + 1);
  add_law(matrix);
  add_end(matrix);
  taught_->inverse = inverse(matrix);
  taught_->has_inverse = true;
}

// The rows of the nodes.
void ContactEpisode::add_law(Matrix &matrix) const {
  const double unit = mass_ * speed_ / duration_;
  const Index last = d_ * n_;
  for (std::size_t of = 0; of < static_cast<std::size_t>(d_); ++of)
    for (std::size_t by = 0; by < static_cast<std::size_t>(d_); ++by)
      for (int i = 0; i < n_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double stiffness = law_.by_place[of][by][at];
        const double damping = law_.by_rate[of][by][at];
        const Index row = static_cast<Index>(of) * n_ + i;
        for (std::size_t force = 0; force < static_cast<std::size_t>(d_); ++force)
          matrix.row(row).segment(static_cast<Index>(force) * n_, n_) -=
              stiffness * by_force_[by][force].row(i) + damping * rate_by_force_[by][force].row(i);
        matrix(row, last) -=
            (stiffness * by_length_[by][i] + damping * rate_by_length_[by][i]) / unit;
      }
}

// The last row: by the penetration and its rate, and these by the motion.
void ContactEpisode::add_end(Matrix &matrix) const {
  const double unit = mass_ * speed_ / duration_;
  const double of_value = condition_.by_penetration / end_scale();
  const double of_rate = condition_.by_rate / end_scale();
  const Index last = d_ * n_;
  matrix(last, last) = 0;
  for (std::size_t by = 0; by < static_cast<std::size_t>(d_); ++by) {
    const double place =
        of_value * end_overlap_.by_place[by] + of_rate * end_overlap_.rate_by_place[by];
    const double rate = of_rate * end_overlap_.rate_by_rate[by];
    for (std::size_t force = 0; force < static_cast<std::size_t>(d_); ++force)
      matrix.row(last).segment(static_cast<Index>(force) * n_, n_) +=
          unit * (place * by_force_[by][force].row(n_) + rate * rate_by_force_[by][force].row(n_));
    matrix(last, last) += place * by_length_[by][n_] + rate * rate_by_length_[by][n_];
  }
}

// Returns the size of the correction; where the inverse is spoilt, the residual shows it.
double ContactEpisode::correct() {
  const double unit = mass_ * speed_ / duration_;
  correction_.noalias() = taught_->inverse * residual_;
  const double size = correction_.cwiseAbs().maxCoeff();
  for (int d = 0; d < d_; ++d)
    for (int j = 0; j < n_; ++j)
      forces_[static_cast<std::size_t>(d)][static_cast<std::size_t>(j)] +=
          unit * correction_[d * n_ + j];
  duration_ *= 1 + std::clamp(correction_[d_ * n_], -0.5, 1.0);
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
  taught_->shape.resize(static_cast<std::size_t>(d_ * n_));
  for (int d = 0; d < d_; ++d)
    for (int j = 0; j < n_; ++j)
      taught_->shape[static_cast<std::size_t>(d * n_ + j)] =
          forces_[static_cast<std::size_t>(d)][static_cast<std::size_t>(j)] / unit;
  taught_->length_scale = duration_ * std::pow(speed_, (exponent_ - 1) / (exponent_ + 1));
  taught_->has_shape = true;
  taught_->good_steps =
      error_ < good_error && error_between_ < good_error_between ? taught_->good_steps + 1 : 0;
}

} // namespace vibroimpact::motion
