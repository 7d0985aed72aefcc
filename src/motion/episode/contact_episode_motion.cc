// The motion over a contact under a force that is given at its nodes.
#include "motion/episode/contact_episode.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

// The two sides alone under the acceleration that they meet with, by the classical Runge-Kutta
// method, as far as the end of the force. Of each motion only the first instant counts.
void ContactEpisode::guess_anew() {
  constexpr std::size_t steps_of_elastic_contact = 48;
  constexpr std::size_t most_steps = 10 * steps_of_elastic_contact;
  const double fastest = motion_.fastest();
  const auto directions = static_cast<std::size_t>(d_);
  const auto moved = [&](const Motions &from, const Motions &slope, double time) {
    Motions at = from;
    for (std::size_t d = 0; d < directions; ++d) {
      at.places[d][0] += time * slope.places[d][0];
      at.rates[d][0] += time * slope.rates[d][0];
    }
    return at;
  };
  const auto slope = [&](const Motions &at) {
    force_.evaluate(1, at, law_);
    Motions made;
    for (std::size_t d = 0; d < directions; ++d) {
      made.places[d][0] = at.rates[d][0];
      made.rates[d][0] = 2 * coefficients_[d][2] * fastest * fastest;
      for (std::size_t by = 0; by < directions; ++by)
        made.rates[d][0] += fastest *
                            motion_.response(static_cast<int>(d), static_cast<int>(by), 1) *
                            law_.force[by][0];
    }
    return made;
  };
  const double h =
      free_contact_duration(force_.elastic(), mass_, speed_) / steps_of_elastic_contact;
  std::vector<Motions> path(1);
  for (std::size_t d = 0; d < directions; ++d)
    path[0].rates[d][0] = coefficients_[d][1] * fastest;
  const auto ended = [&](const Motions &at) {
    const Overlap seen = force_.overlap(at, 0);
    return !(condition_(seen.penetration, seen.rate) > 0);
  };
  while (path.size() <= most_steps && (path.size() < 3 || !ended(path.back()))) {
    const Motions &from = path.back();
    const Motions k1 = slope(from);
    const Motions k2 = slope(moved(from, k1, 0.5 * h));
    const Motions k3 = slope(moved(from, k2, 0.5 * h));
    const Motions k4 = slope(moved(from, k3, h));
    Motions next = moved(from, k1, h / 6);
    next = moved(moved(next, k2, h / 3), k3, h / 3);
    path.push_back(moved(next, k4, h / 6));
  }
  guess_by_path(path, h);
}

// The end lies between the last two of its places.
void ContactEpisode::guess_by_path(const std::vector<Motions> &path, double step) {
  const std::size_t last = path.size() - 2;
  const auto left = [&](const Motions &at) {
    const Overlap seen = force_.overlap(at, 0);
    return condition_(seen.penetration, seen.rate);
  };
  const double before = left(path[last]);
  const double behind = left(path[last + 1]);
  duration_ = step * (static_cast<double>(last) + (behind < 0 ? before / (before - behind) : 1));
  for (int j = 0; j < n_; ++j) {
    const double place = tools_->family.nodes()[j] * duration_ / step;
    const auto i = std::min(static_cast<std::size_t>(place), last);
    const double part = place - static_cast<double>(i);
    const auto to = static_cast<std::size_t>(j);
    for (std::size_t d = 0; d < static_cast<std::size_t>(d_); ++d) {
      motions_.places[d][to] = (1 - part) * path[i].places[d][0] + part * path[i + 1].places[d][0];
      motions_.rates[d][to] = (1 - part) * path[i].rates[d][0] + part * path[i + 1].rates[d][0];
    }
  }
  force_.evaluate(n_, motions_, law_);
  forces_ = law_.force;
}

void ContactEpisode::evaluate() {
  ++sweeps_;
  const double theta = motion_.fastest() * duration_;
  for (int of = 0; of < d_; ++of)
    for (int by = 0; by < d_; ++by) {
      double power = 1;
      ForcedMotion::Coefficients &powers =
          powers_[static_cast<std::size_t>(of)][static_cast<std::size_t>(by)];
      for (int k = 0; k < terms_; ++k, power *= theta)
        powers[static_cast<std::size_t>(k)] = motion_.response(of, by, k) * power;
    }
  add_free_motion();
  add_forced_motion();
  see_overlaps();
  force_.evaluate(n_, motions_, law_);
}

// Horner's rule at all nodes and the end.
void ContactEpisode::add_free_motion() {
  const double theta = motion_.fastest() * duration_;
  const double rate = motion_.fastest();
  for (std::size_t d = 0; d < static_cast<std::size_t>(d_); ++d)
    for (int i = 0; i <= n_; ++i) {
      const double s = i < n_ ? theta * tools_->family.nodes()[i] : theta;
      double value = 0;
      double slope = 0;
      double half_bend = 0;
      for (int k = terms_; k-- > 0;) {
        half_bend = slope + s * half_bend;
        slope = value + s * slope;
        value = coefficients_[d][static_cast<std::size_t>(k)] + s * value;
      }
      const auto at = static_cast<std::size_t>(i);
      motions_.places[d][at] = value;
      free_rates_[d][at] = motions_.rates[d][at] = rate * slope;
      free_accelerations_[d][at] = 2 * rate * rate * half_bend;
    }
}

// The terms beyond the first are those of the system; they change little from sweep to sweep.
void ContactEpisode::add_forced_motion() {
  const Index targets = n_ + 1;
  const Matrix &terms = tools_->at_nodes.terms();
  if (changed_ * higher_share_ > 0.3 * tolerance_of_newton_)
    renew_higher_terms();
  for (std::size_t of = 0; of < static_cast<std::size_t>(d_); ++of) {
    VectorView places(motions_.places[of].data(), targets);
    VectorView rates(motions_.rates[of].data(), targets);
    for (std::size_t by = 0; by < static_cast<std::size_t>(d_); ++by) {
      const ConstVectorView forces(forces_[by].data(), n_);
      const double first = powers_[of][by][1];
      places.noalias() += duration_ * first * (terms.middleCols(n_, n_) * forces);
      rates.noalias() += first * (terms.leftCols(n_) * forces);
    }
    places += ConstVectorView(higher_[of].data(), targets);
    rates += ConstVectorView(higher_rates_[of].data(), targets);
  }
}

void ContactEpisode::renew_higher_terms() {
  const Index targets = n_ + 1;
  const Index columns = static_cast<Index>(terms_ - 2) * n_;
  const Matrix &terms = tools_->at_nodes.terms();
  higher_share_ = 0;
  for (std::size_t of = 0; of < static_cast<std::size_t>(d_); ++of) {
    weighted_.setZero(columns);
    double largest = 0;
    for (std::size_t by = 0; by < static_cast<std::size_t>(d_); ++by) {
      const ConstVectorView forces(forces_[by].data(), n_);
      for (int k = 2; k < terms_; ++k)
        weighted_.segment(static_cast<Index>(k - 2) * n_, n_) +=
            powers_[of][by][static_cast<std::size_t>(k)] * forces;
      largest += (duration_ * powers_[of][by][1] * (terms.middleCols(n_, n_) * forces))
                     .cwiseAbs()
                     .maxCoeff();
    }
    VectorView higher(higher_[of].data(), targets);
    higher.noalias() = duration_ * (terms.middleCols(2 * n_, columns) * weighted_);
    VectorView(higher_rates_[of].data(), targets).noalias() =
        terms.middleCols(n_, columns) * weighted_;
    const double share =
        largest > 0 ? std::min(1.0, 4 * higher.cwiseAbs().maxCoeff() / largest) : 1;
    higher_share_ = std::max(higher_share_, share);
  }
  changed_ = 0;
}

void ContactEpisode::see_overlaps() {
  for (int i = 0; i <= n_; ++i) {
    end_overlap_ = force_.overlap(motions_, i);
    penetrations_[static_cast<std::size_t>(i)] = end_overlap_.penetration;
    rates_[static_cast<std::size_t>(i)] = end_overlap_.rate;
  }
}

// d u / d f, d u' / d f at the nodes and the end, and their derivatives by ln T.
void ContactEpisode::differentiate() {
  const Matrix &terms = tools_->at_nodes.terms();
  for (std::size_t of = 0; of < static_cast<std::size_t>(d_); ++of) {
    by_length_[of].resize(n_ + 1);
    rate_by_length_[of].resize(n_ + 1);
    for (int i = 0; i <= n_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double t = duration_ * (i < n_ ? tools_->family.nodes()[i] : 1);
      by_length_[of][i] = t * free_rates_[of][at];
      rate_by_length_[of][i] = t * free_accelerations_[of][at];
    }
    for (std::size_t by = 0; by < static_cast<std::size_t>(d_); ++by) {
      const ConstVectorView forces(forces_[by].data(), n_);
      Matrix &by_force = by_force_[of][by];
      Matrix &rate_by_force = rate_by_force_[of][by];
      by_force.setZero(n_ + 1, n_);
      rate_by_force.setZero(n_ + 1, n_);
      for (int k = 1; k < terms_; ++k) {
        const double power = powers_[of][by][static_cast<std::size_t>(k)];
        const auto integral = terms.middleCols(static_cast<Index>(k) * n_, n_);
        const auto before = terms.middleCols(static_cast<Index>(k - 1) * n_, n_);
        by_force += duration_ * power * integral;
        rate_by_force += power * before;
        by_length_[of].noalias() += (k + 1) * duration_ * power * (integral * forces);
        rate_by_length_[of].noalias() += k * power * (before * forces);
      }
    }
  }
}

} // namespace vibroimpact::motion
