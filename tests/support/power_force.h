// A nonlinear contact force in closed form.
#pragma once

#include "motion/episode/contact_force.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

/// F = k u^n (1 + d u'), zero where the sides do not overlap; Hunt and Crossley 1975.
class PowerForce : public ContactForce {
public:
  PowerForce(double stiffness, double exponent, double dissipation)
      : k_(stiffness), n_(exponent), d_(dissipation) {}

  void evaluate(int count, const Motions &motions, ForceValues &values) const override {
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double u = std::max(0.0, motions.places[0][at]);
      const double rate = motions.rates[0][at];
      const double elastic = k_ * std::pow(u, n_);
      const double factor = 1 + d_ * rate;
      values.force[0][at] = elastic * factor;
      values.by_place[0][0][at] = u > 0 ? n_ * elastic / u * factor : 0;
      values.by_rate[0][0][at] = elastic * d_;
      values.dissipated[at] = elastic * d_ * rate * rate;
    }
  }
  contact::ElasticForce elastic() const override { return {.stiffness = k_, .exponent = n_}; }

private:
  double k_, n_, d_;
};

} // namespace vibroimpact::motion
