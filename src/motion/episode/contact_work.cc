#include "motion/episode/contact_work.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

ContactWork::ContactWork(const PowerForms &powers, const PhaseEpisode &contact,
                         const Equations &equations, double tolerance)
    : powers_(powers), contact_(contact), equations_(equations), tolerance_(tolerance) {
  const StateLayout &layout = equations.layout();
  const auto own = static_cast<Index>(contact.contact());
  const Index sliding = contact.pair().sliding_place;
  const auto is_own = [&](Index entry) {
    return entry == layout.impulse(own) || entry == layout.contact_work(own) ||
           (sliding >= 0 &&
            (entry == layout.friction_work(sliding) || entry == layout.wear_work(sliding) ||
             entry == layout.sliding_way(sliding)));
  };
  for (std::size_t k = 0; k < powers.size(); ++k)
    if (!is_own(powers.entry(k)))
      products_.push_back(static_cast<Index>(k));
}

void ContactWork::renew() {
  if (version_ == contact_.version())
    return;
  version_ = contact_.version();
  const auto count = static_cast<Index>(products_.size());
  Matrix factors(2 * count, contact_.flow().size());
  constants_.resize(2 * count);
  for (Index i = 0; i < 2 * count; ++i) {
    const Index of = 2 * products_[static_cast<std::size_t>(i / 2)] + i % 2;
    factors.row(i) = contact_.in_amplitudes(powers_.rows().row(of)).transpose();
    constants_[i] = powers_.constants()[of];
  }
  factors_ = factors.sparseView(1, 0);
}

// A rule of 10 points at the tolerance 1e-8, and more where the system turns within the contact.
int ContactWork::points() const {
  constexpr double of_ten = 1e-8;
  const double theta = contact_.flow().fastest() * contact_.duration();
  const int by_tolerance =
      static_cast<int>(std::lround(10 * std::pow(of_ten / tolerance_, 1. / 7)));
  return std::max(std::clamp(by_tolerance, 8, 20), 7 + static_cast<int>(std::ceil(theta)));
}

void ContactWork::add_powers(Vector &state) {
  const ContactEpisode &solved = contact_.solution();
  QuadraturePoints &quadrature = solved.tools().quadrature(points());
  const std::vector<double> moments = solved.moments(quadrature.at_nodes);
  amplitudes_.resize(contact_.before().size());
  sliding_way_ = 0;
  for (int i = 0; i < quadrature.at_nodes.n_targets(); ++i) {
    const double t = static_cast<double>(quadrature.rule.nodes[i]) * contact_.duration();
    kernel().turn(contact_.linear().phase().view(), contact_.before().data(), t,
                  amplitudes_.data());
    contact_.add_force(moments, quadrature.at_nodes.n_targets(), i, amplitudes_.data());
    values_ = constants_;
    values_.noalias() += factors_ * ConstVectorView(amplitudes_.data(), factors_.cols());
    const double weight = static_cast<double>(quadrature.rule.weights[i]) * contact_.duration();
    for (std::size_t k = 0; k < products_.size(); ++k) {
      const auto at = static_cast<Index>(2 * k);
      state[powers_.entry(static_cast<std::size_t>(products_[k]))] +=
          weight * values_[at] * values_[at + 1];
    }
    if (contact_.pair().sliding_place >= 0)
      sliding_way_ += weight * sliding_speed(amplitudes_.data());
  }
}

// Of a contact in a circular gap, by u and u' within it.
double ContactWork::sliding_speed(const double *amplitudes) {
  const contact::ContactPair &pair = contact_.pair();
  contact::RelativeMotion at;
  for (int d = 0; d < 2; ++d) {
    double derivatives[2];
    contact_.output(d).free_motion(amplitudes, 2, derivatives);
    at.position[static_cast<std::size_t>(d)] = derivatives[0];
    at.rate[static_cast<std::size_t>(d)] = derivatives[1] * contact_.flow().fastest();
  }
  contact::LocalState local{.internal = contact_.force().internal()};
  pair.circle->see(pair.circle->frame(at), local);
  pair.law->evaluate(contact_.mode_within(), local, response_);
  return response_.sliding_speed;
}

// - integral of f times the rate of the base, and of the surface, by the force's own integrals.
double ContactWork::work_of_bases(double time) const {
  const contact::ContactPair &pair = contact_.pair();
  const ContactEpisode &solved = contact_.solution();
  Instants power{};
  for (int d = 0; d < contact_.n_directions(); ++d) {
    const std::vector<double> &bases = pair.along(d).projection->base_coefficients;
    for (std::size_t k = 0; k < bases.size(); ++k) {
      if (bases[k] == 0)
        continue;
      const model::TimeFunction &source = *equations_.model().sources()[k].function;
      for (int j = 0; j < solved.nodes(); ++j) {
        const double t = time + contact_.duration() * solved.tools().family.nodes()[j];
        power[static_cast<std::size_t>(j)] -=
            contact_.force_along(d, j) * bases[k] * source.rate(equations_.source_time(t));
      }
    }
  }
  if (pair.circle)
    for (std::size_t j = 0; j < static_cast<std::size_t>(solved.nodes()); ++j)
      power[j] -= solved.law().tangential[j] * pair.circle->surface_speed();
  return solved.integral(power);
}

void ContactWork::add_friction(Vector &state) const {
  const StateLayout &layout = equations_.layout();
  const Index sliding = contact_.pair().sliding_place;
  if (sliding < 0)
    return;
  state[layout.friction_work(sliding)] +=
      contact_.solution().integral(contact_.solution().law().friction_power);
  state[layout.wear_work(sliding)] +=
      contact_.solution().integral(contact_.solution().law().wear_power);
  state[layout.sliding_way(sliding)] += sliding_way_;
}

void ContactWork::add(double time, Vector &state) {
  renew();
  const StateLayout &layout = equations_.layout();
  const auto own = static_cast<Index>(contact_.contact());
  const double before = state[layout.input_work()];
  add_powers(state);
  state[layout.input_work()] += work_of_bases(time);
  state[layout.absolute_input_work()] += std::abs(state[layout.input_work()] - before);
  state[layout.impulse(own)] += contact_.solution().impulse();
  state[layout.contact_work(own)] += contact_.solution().dissipated();
  add_friction(state);
}

} // namespace vibroimpact::motion
