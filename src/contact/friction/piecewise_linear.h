// Friction whose coefficient is a polygon of the slip speed |v|, with true stick:
//
//   slip   F = -sigma mu(|v|) N, mu(|v|) = mu_i + (mu_(i+1) - mu_i) (|v| - v_i) / (v_(i+1) - v_i)
//          between the speeds v_i and v_(i+1), the last coefficient above the last speed
//   stick  v = 0, held by a force F, until |F| = mu_s N
//
// Each piece is a mode. Where N is constant, or the piece is level, its force is an affine form.
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>
#include <vector>

namespace vibroimpact::contact {

class PiecewiseLinear : public TangentialLaw {
public:
  /// speeds: rising from 0 [m/s]; coefficients: > 0, as many; static_coefficient: no less than the
  /// first.
  PiecewiseLinear(std::vector<double> speeds, std::vector<double> coefficients,
                  double static_coefficient)
      : speeds_(std::move(speeds)), coefficients_(std::move(coefficients)),
        static_coefficient_(static_coefficient) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "piecewise-linear"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                TangentialValues &values) const override;

private:
  /// mu = level + slope |v|
  struct Piece {
    double level = 0, slope = 0;
  };
  Piece piece(std::size_t i) const;
  int mode_of(double sigma, std::size_t piece) const;
  TangentialMode slip(double sigma, std::size_t piece, const AffineForm &normal_force) const;

  std::vector<double> speeds_, coefficients_;
  double static_coefficient_;
};

} // namespace vibroimpact::contact
