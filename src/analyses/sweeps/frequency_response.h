// Steady response of the model, its contacts open or tied, to one harmonic excitation, exact at
// each frequency.
//
// The excitation is s(t) = Im(S exp(i w t)). With diag(mass) M, damping C and stiffness K the
// coordinates follow as q(t) = Im(Q exp(i w t)),
//
//   (K - w^2 M + i w C) Q = (load + i w rate_load - w^2 inertial_load) S
//
// and an observed displacement is row Q, absolute ones with base_coefficients S added. Amplitudes
// are >= 0; a response is amplitude sin(w t + phase). Other excitations do not act. The largest
// amplitude over frequency is refined between the neighbours of the largest listed one by Brent's
// method.
#pragma once

#include "analyses/analysis.h"
#include "analyses/sweeps/linear_response.h"
#include "analyses/sweeps/tied_contacts.h"

namespace vibroimpact::analyses {

class FrequencyResponse : public Analysis {
public:
  struct Settings {
    std::vector<double> frequencies; ///< increasing [Hz]
    std::string excitation;          ///< empty: the only one
    TiedContacts tied = {};          ///< none: all are open
  };
  explicit FrequencyResponse(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "frequency response"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  LinearResponse response(const System &system) const;
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
