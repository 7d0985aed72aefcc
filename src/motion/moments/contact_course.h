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
#include <span>
#include <vector>

namespace vibroimpact::motion {

/// Nodes of the Gauss rule, in (0, 1).
const std::array<double, n_moments> &moment_nodes();

/// Directions of a contact: the normal, then tangential ones.
constexpr std::size_t most_directions = 1 + contact::most_tangential;

/// What a step gives of the position along a direction [m], and of its rate at both ends [m/s].
struct PathValues {
  double start = 0, start_rate = 0;
  std::array<double, n_moments> nodes{};
  double end = 0, end_rate = 0;
};

/// Along a direction: position, rate, and the way of the surfaces on each other, whose rate that
/// is by time.
struct DirectionCurve {
  Bernstein position, rate, way;

  DirectionCurve() = default;
  /// speed: of the surface itself, which the rates of the values do not have [m/s].
  DirectionCurve(const PathValues &values, double h, double speed);
};

/// A stretch of the step in one mode.
struct CourseStretch {
  double from = 0, to = 1; ///< parts of the step
  int mode = 0;
  std::optional<std::size_t> guard{}; ///< that ended it
  std::vector<Bernstein> internal{};  ///< states of the law
};

/// Over a stretch, dx.
struct ForceIntegrals {
  double force = 0;      ///< of F [N]
  double dissipated = 0; ///< of the power that the law dissipates [W]
  double carried =
      0; ///< of forces times the rates by moving bases and surfaces that they act on [W]
  double friction = 0; ///< the part of `dissipated` that friction takes [W]
  double wear = 0;     ///< of F times the sliding speed [W]
  double sliding = 0;  ///< of the sliding speed [m/s]
};

class ContactCourse {
public:
  using Moments = std::array<double, n_moments>; ///< [N]

  /// Internal states follow the motion: in every mode their rates are sums of those along the
  /// directions.
  static bool holds(const contact::ContactLaw &law);

  void take(std::size_t direction, DirectionCurve curve) { curves_[direction] = curve; }
  /// Follows the law from `mode` on; rounding: of position and rate at the start. False: the mode
  /// changes too often for a step.
  bool follow(const contact::ContactLaw &law, int mode, std::span<const double> internal,
              std::array<double, 2> rounding);

  const Bernstein &gap() const { return curves_[0].position; }
  const DirectionCurve &curve(std::size_t direction) const { return curves_[direction]; }
  const std::vector<CourseStretch> &stretches() const { return stretches_; }
  /// The change at the end of a stretch, to the part x of the step.
  void move_change(std::size_t stretch, double x) {
    stretches_[stretch].to = stretches_[stretch + 1].from = x;
  }
  bool changes() const { return stretches_.size() > 1; }
  int last_mode() const { return stretches_.back().mode; }
  /// Valid until the next call.
  contact::LocalState at(const CourseStretch &stretch, double x) const;
  /// An affine form without held forces.
  Bernstein form(const contact::AffineForm &form, const CourseStretch &stretch) const;

  Moments moments(const contact::ContactLaw &law, std::size_t direction,
                  contact::LawResponse &response) const;
  /// What the force has more than its polynomial, up to the part x of the step: the integral of
  /// F - p, and that of (x - s) (F - p). Both are zero at the end, where x = 1. sum_lacks() first,
  /// behind the last change of a stretch.
  void sum_lacks(const contact::ContactLaw &law, std::size_t direction, const double *moments,
                 contact::LawResponse &response);
  std::array<double, 2> lacking(const contact::ContactLaw &law, std::size_t direction,
                                const double *moments, double x,
                                contact::LawResponse &response) const;
  /// base_rate: that of a direction by moving bases and surfaces at the part x of the step [m/s].
  ForceIntegrals integrals(const contact::ContactLaw &law, const CourseStretch &stretch,
                           const std::function<double(std::size_t direction, double x)> &base_rate,
                           contact::LawResponse &response) const;

private:
  using Lack = std::array<double, 2>;
  Lack lack(const contact::ContactLaw &law, std::size_t direction, const double *moments,
            const CourseStretch &stretch, double to, contact::LawResponse &response) const;
  std::vector<Bernstein> internal_of(const contact::Mode &mode, double x,
                                     std::span<const double> values) const;
  double negligible(const contact::AffineForm &form, const CourseStretch &stretch,
                    const contact::Mode &mode, std::array<double, 2> rounding) const;
  std::vector<double> behind(const contact::Guard &guard, const CourseStretch &stretch) const;

  std::array<DirectionCurve, most_directions> curves_;
  std::vector<CourseStretch> stretches_;
  std::array<std::vector<Lack>, most_directions> lacks_; ///< up to the start of each stretch
  mutable std::vector<double> internal_;
};

/// Force along a direction.
inline double component_force(const contact::LawResponse &response, std::size_t direction) {
  return direction == 0 ? response.force : response.tangential[direction - 1].force;
}

} // namespace vibroimpact::motion
