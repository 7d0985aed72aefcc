// Contacts in a circular clearance: a point in a ring, or two round bodies beside each other.
//
// The contact sees u = (u_1, u_2), the place of side b relative to side a across an axis, along two
// directions a_1, a_2 with a_1 x a_2 = axis [m]; u = 0 where their centres meet. With r = |u|,
//
//   gap                   g = s (c - r)       s = 1: one inside the other, c the radial clearance
//                                             s = -1: beside each other, c the sum of the radii
//   normal, from a to b   n = -s u / r        g' = n . u'
//   tangent               t = axis x n        slip rate v = t . u' + surface speed
//   force on b            f = N n + F t       N, F of a contact law, which sees g, g' and v
//
// and where u turns, so do n and t: dn = -s t (t . du) / r, dt = s n (t . du) / r. The law stays a
// law of a plane contact; its modes with a force are not affine in the motion.
#pragma once

#include "contact/contact_law.h"
#include "model/projection.h"

#include <array>

namespace vibroimpact::contact {

/// Of u: numbers along a_1 and a_2.
using AcrossAxis = std::array<double, 2>;

/// What a contact in a circular clearance sees of the motion.
struct RelativeMotion {
  AcrossAxis position{}; ///< u [m]
  AcrossAxis rate{};     ///< u' [m/s]
};

/// Where the contact stands at an instant.
struct CircularFrame {
  AcrossAxis normal{}, tangent{};
  double distance = 0; ///< r [m]
  double gap_rate = 0; ///< n . u' [m/s]
  double turning = 0;  ///< t . u' [m/s]
};

class CircularGap {
public:
  enum class Kind { inside, beside };

  /// `clearance`: c > 0 [m]; `second`: u_2 as a projection of the motion, u_1 being that of the
  /// contact; `centres`: u of the undeformed model [m].
  CircularGap(Kind kind, double clearance, Vector3 axis, model::Projection second,
              AcrossAxis centres, double surface_speed)
      : sense_(kind == Kind::inside ? 1 : -1), clearance_(clearance), axis_(std::move(axis)),
        second_(std::move(second)), centres_(centres), surface_speed_(surface_speed) {}

  double clearance() const { return clearance_; }
  const Vector3 &axis() const { return axis_; }
  const model::Projection &second() const { return second_; }
  const AcrossAxis &centres() const { return centres_; }
  /// s
  double sense() const { return sense_; }
  double surface_speed() const { return surface_speed_; }

  CircularFrame frame(const RelativeMotion &motion) const;
  /// Gap, slip rate and their like; internal states are those of `state`. No law sees the slip, the
  /// way along the ring, which stays zero.
  void see(const CircularFrame &frame, LocalState &state) const;
  /// Second derivative of the gap (direction 0), or the derivative of the slip rate (1), at u''.
  double acceleration(const CircularFrame &frame, const AcrossAxis &acceleration,
                      int direction) const;
  /// f of a law's response.
  AcrossAxis force(const CircularFrame &frame, const LawResponse &response) const;

  // Partial derivatives by u and u', as the coefficients that a form has of two directions: gap and
  // gap rate stand for u_1 and u_1', slip and slip rate for u_2 and u_2'.
  /// Of a form of the local state; its forces are left out.
  AffineForm gradient(const CircularFrame &frame, const AffineForm &form) const;
  /// Of f.
  std::array<AffineForm, 2> force_gradient(const CircularFrame &frame,
                                           const LawResponse &response) const;
  /// Of what acceleration() gives, at constant u''.
  AffineForm acceleration_gradient(const CircularFrame &frame, const AcrossAxis &acceleration,
                                   int direction) const;

private:
  double sense_;
  double clearance_;
  Vector3 axis_;
  model::Projection second_;
  AcrossAxis centres_;
  double surface_speed_;
};

/// The partial derivatives of a law's normal force by the local state, and of the rate of an
/// internal state.
AffineForm normal_force_gradient(const LawResponse &response);
AffineForm internal_rate_gradient(const LawResponse &response, int state, int n_internal);

} // namespace vibroimpact::contact
