// One contact over a step: where it changes its mode, and its force as a polynomial.
//
// The gap over the step is the polynomial of degree 7 with the values at both ends and at the nodes
// of a Gauss rule, and the rates at both ends, so that guards go on without a jump from step to
// step. From the mode at the start on, the first guard that falls through zero ends each mode; the
// convex hull of Bernstein coefficients proves where none does. The force is the sum of
// a_k P_k(2 x - 1) that leaves the moments of the true one,
//
//   a_k = (2 k + 1) integral of F P_k dx,
//
// by Gauss rules between the changes: kinks and jumps cost no order, and a_0 is the mean force.
#pragma once

#include "contact/contact_law.h"
#include "motion/interval/bernstein.h"
#include "motion/moments/legendre_response.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

/// Nodes of the Gauss rule, in (0, 1).
const std::array<double, n_moments> &moment_nodes();

/// What a step gives of a gap [m], and of its rate at both ends [m/s].
struct GapValues {
  double start = 0, start_rate = 0;
  std::array<double, n_moments> nodes{};
  double end = 0, end_rate = 0;
  double rounding = 0, rate_rounding = 0; ///< of those at the start
};

class GapCurve {
public:
  GapCurve() = default;
  GapCurve(const GapValues &values, double h);

  const Bernstein &gap() const { return gap_; }
  /// What rounding may make of a form at the start of the step.
  double start_rounding(const contact::AffineForm &form) const;
  /// Of an affine form without internal states and held forces.
  Bernstein form(const contact::AffineForm &form) const;
  /// Gap and rate at the part x of the step.
  contact::LocalState at(double x) const { return {.gap = gap_(x), .gap_rate = rate_(x)}; }

private:
  Bernstein gap_, rate_;
  double rounding_ = 0, rate_rounding_ = 0;
};

/// A stretch of the step in one mode.
struct CourseStretch {
  double from = 0, to = 1; ///< parts of the step
  int mode = 0;
  std::optional<std::size_t> guard{}; ///< that ended it
};

/// Over a stretch, dx.
struct ForceIntegrals {
  double force = 0;      ///< of F [N]
  double dissipated = 0; ///< of the power that the law dissipates [W]
  double carried = 0;    ///< of F times the rate at which a moving base opens the gap [W]
};

class ContactCourse {
public:
  using Moments = std::array<double, n_moments>; ///< [N]

  /// Follows the law from `mode` on. False: the mode changes too often for a step.
  bool follow(const contact::ContactLaw &law, const GapCurve &curve, int mode);

  const GapCurve &curve() const { return curve_; }
  const std::vector<CourseStretch> &stretches() const { return stretches_; }
  /// The change at the end of a stretch, to the part x of the step.
  void move_change(std::size_t stretch, double x) {
    stretches_[stretch].to = stretches_[stretch + 1].from = x;
  }
  bool changes() const { return stretches_.size() > 1; }
  int last_mode() const { return stretches_.back().mode; }

  Moments moments(const contact::ContactLaw &law, contact::LawResponse &response) const;
  /// base_rate: rate at which a moving base opens the gap at the part x of the step [m/s]; none: it
  /// does not.
  /// What the force has more than its polynomial, up to the part x of the step: the integral of
  /// F - p, and that of (x - s) (F - p). Both are zero at the end, where x = 1. sum_lacks() first,
  /// behind the last change of a stretch.
  void sum_lacks(const contact::ContactLaw &law, const double *moments,
                 contact::LawResponse &response);
  std::array<double, 2> lacking(const contact::ContactLaw &law, const double *moments, double x,
                                contact::LawResponse &response) const;
  ForceIntegrals integrals(const contact::ContactLaw &law, const CourseStretch &stretch,
                           const std::function<double(double x)> &base_rate,
                           contact::LawResponse &response) const;

private:
  using Lack = std::array<double, 2>;
  Lack lack(const contact::ContactLaw &law, const double *moments, const CourseStretch &stretch,
            double to, contact::LawResponse &response) const;

  GapCurve curve_;
  std::vector<CourseStretch> stretches_;
  std::vector<Lack> lacks_; ///< up to the start of each stretch
};

} // namespace vibroimpact::motion
