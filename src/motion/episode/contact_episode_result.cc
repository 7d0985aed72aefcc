// What is asked of a contact that was solved: whether it is one, its error, what its force does.
#include "motion/episode/contact_episode.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

// A force that pushes has not ended before. One that pulls as long as there is penetration neither.
bool ContactEpisode::ends_first() const {
  return tools_->family.is_positive(normal_force(), !condition_.at_release()) ||
         (d_ == 1 && condition_.at_release() && overlaps());
}

// Between points so close that the cubic polynomials of the penetration show where it is: they lie
// within the hull of their Bernstein coefficients.
bool ContactEpisode::overlaps() const {
  constexpr int points = 17;
  ShownPoints &shown = tools_->shown(points);
  shown.between.require(terms_);
  const ConstVectorView forces(forces_[0].data(), n_);
  const double theta = motion_.fastest() * duration_;
  Vector u = Vector::Zero(shown.between.n_targets() + 2);
  Vector slope = Vector::Zero(u.size()); // du/dx
  slope[0] = speed_ * duration_;
  slope[u.size() - 1] = rates_[static_cast<std::size_t>(n_)] * duration_;
  for (int k = 1; k < terms_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    u.segment(1, u.size() - 2) += duration_ * powers_[0][0][at] * (shown.between.term(k) * forces);
    slope.segment(1, u.size() - 2) +=
        duration_ * powers_[0][0][at] * (shown.between.term(k - 1) * forces);
    const double free = coefficients_[0][at] * std::pow(theta, k);
    for (Index i = 1; i + 1 < u.size(); ++i) {
      const double before = std::pow(static_cast<double>(shown.rule.nodes[i]), k - 1);
      u[i] += free * before * static_cast<double>(shown.rule.nodes[i]);
      slope[i] += free * k * before;
    }
  }
  for (Index i = 0; i + 1 < u.size(); ++i) {
    const auto third = static_cast<double>(shown.rule.nodes[i + 1] - shown.rule.nodes[i]) / 3;
    if (!(u[i] + third * slope[i] > 0 && u[i + 1] - third * slope[i + 1] > 0) ||
        (i > 0 && !(u[i] > 0)))
      return false;
  }
  return true;
}

// Of systems that are far from normal the terms need not fall as those of their exponents.
bool ContactEpisode::series_ends() const {
  const double theta = motion_.fastest() * duration_;
  const double allowed = tolerance_of_newton_;
  for (std::size_t d = 0; d < static_cast<std::size_t>(d_); ++d) {
    const double largest = ConstVectorView(motions_.places[d].data(), n_ + 1).cwiseAbs().maxCoeff();
    for (int k = terms_ - 2; k < terms_; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (std::abs(coefficients_[d][at]) * std::pow(theta, k) > allowed * largest ||
          std::abs(powers_[d][d][at] / powers_[d][d][1]) / std::tgamma(k + 1.0) > allowed)
        return false;
    }
  }
  return true;
}

// Damping with a root of the penetration, and a force that is cut off where there is little of it
// left, have slopes that are no smooth functions of time, even beside the weight: what Gauss nodes
// gain for smooth ones is lost.
bool ContactEpisode::is_rough() const {
  const ForceShape &shape = tools_->family.shape();
  return shape.begin_root > 1 || shape.end_root > 1 || (!condition_.at_release());
}

void ContactEpisode::find_error() {
  // Damping at a first touch is no stiffness.
  constexpr double shallow = 0.1;
  const double deepest = *std::max_element(penetrations_.begin(), penetrations_.begin() + n_);
  double stiffness = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n_); ++i)
    stiffness = std::max(stiffness, std::abs(law_.force[0][i]) /
                                        std::max(penetrations_[i], shallow * deepest));
  const double fastest = motion_.fastest();
  const double turn = 0.5 * duration_ * tools_->family.stretch().steepest() *
                      std::sqrt(fastest * fastest + 2 * stiffness / mass_);
  double smooth = 1;
  for (int k = 1; k <= n_; ++k)
    smooth *= turn / (2 * k - 1);
  constexpr double of_rough_force = 0.1;
  double tail = 0;
  for (int d = 0; d < d_; ++d)
    tail = std::max(tail, tools_->family.tail(forces(d), forces()));
  const double kept = std::max(std::min(1.0, smooth), is_rough() ? of_rough_force : 0);
  error_ = tail * std::max(0.1 * tail, kept) / tolerance_;
  error_between_ = tail / (n_ * n_) / tolerance_;
}

double ContactEpisode::integral(const Instants &values) const {
  return duration_ * tools_->at_nodes.term(0).row(n_).dot(ConstVectorView(values.data(), n_));
}

double ContactEpisode::impulse() const { return integral(d_ == 1 ? forces_[0] : law_.normal); }

// By the rule whose nodes these are: its weights are positive.
double ContactEpisode::pulling_impulse() const {
  const ConstVectorView forces(forces_[0].data(), n_);
  return -duration_ * tools_->at_nodes.term(0).row(n_).dot(forces.cwiseMin(0));
}

std::vector<double> ContactEpisode::moments(ForceOperators &operators) const {
  operators.require(terms_);
  const std::size_t count =
      static_cast<std::size_t>(terms_) * static_cast<std::size_t>(operators.n_targets());
  std::vector<double> list(static_cast<std::size_t>(d_) * count);
  for (int d = 0; d < d_; ++d) {
    const ConstVectorView along(forces(d), n_);
    Eigen::Map<Matrix> of(list.data() + static_cast<std::size_t>(d) * count, terms_,
                          operators.n_targets());
    for (int k = 0; k < terms_; ++k)
      of.row(k).noalias() = (operators.term(k) * along).transpose();
  }
  return list;
}

std::vector<double> ContactEpisode::end_moments() const {
  std::vector<double> list;
  for (int d = 0; d < d_; ++d) {
    const ConstVectorView along(forces(d), n_);
    for (int k = 0; k < terms_; ++k)
      list.push_back(tools_->at_nodes.term(k).row(n_).dot(along));
  }
  return list;
}

} // namespace vibroimpact::motion
