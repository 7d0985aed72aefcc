// Friction that falls with the slip speed, after Stribeck (Bo & Pavelescu 1982), with true stick:
//
//   slip   F = -sigma (mu_k + (mu_s - mu_k) exp(-(|v| / v_s)^n)) N - c v, until v = 0
//   stick  v = 0, held by a force F, until |F| = mu_s N
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

struct StribeckConstants {
  double coefficient = 0;        ///< mu_k > 0
  double static_coefficient = 0; ///< mu_s >= mu_k
  double speed = 0;              ///< v_s > 0 [m/s]
  double exponent = 1;           ///< n >= 1
  double damping_constant = 0;   ///< c >= 0 [N s/m]

  /// mu at a slip speed >= 0, and its derivative by it.
  struct Value {
    double coefficient = 0, slope = 0;
  };
  Value at(double slip_speed) const;
};

/// The keys of the coefficient alone, shared by the laws that have such a one.
void declare_stribeck_coefficient(parameters::Section &law, const std::string &exponent);
/// Checked; without damping constant.
StribeckConstants read_stribeck_coefficient(const parameters::Values &law);

class Stribeck : public TangentialLaw {
public:
  explicit Stribeck(const StribeckConstants &constants) : constants_(constants) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "stribeck"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                TangentialValues &values) const override;

private:
  StribeckConstants constants_;
};

} // namespace vibroimpact::contact
