// The period of motions that no excitation times: limit cycles, such as those of a belt or a whirl.
//
// Such a motion may begin anywhere on its orbit. A plane across it decides, through a point c of
// the orbit and normal to it there in scaled entries, S the scales of the state:
//
//   n . (x - c) = 0,   n = S^2 f(c) / |S f(c)|,   f = dx/dt
//
// The map goes from the plane back to it, and the time that takes is the period:
//
//   P(x) = phi_tau(x),   n . (phi_tau(x) - c) = 0
//   dP = (I - f n^T / (n . f)) dphi_tau,   d tau = - n . dphi_tau / (n . f)
//
// Its eigenvalues are the multipliers of the motion, with a 0 in the place of the 1 that belongs to
// a shift in time, so that a limit cycle is an isolated fixed point.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <map>
#include <vector>

namespace vibroimpact::periodic {

struct Plane {
  Vector point;  ///< c, n physical states
  Vector normal; ///< n

  double distance(const Vector &state) const { return normal.dot(state - point); }
};

/// Normal to `rates` at the state. NumericalError where the motion is at rest.
Plane plane_across(const Vector &state, const Vector &rates, const Vector &scale);

/// Where a motion passes a plane the way the normal points.
struct Passage {
  double time = 0;     ///< since its start, between two looks by a chord [s]
  double away = 0;     ///< from the plane's point, scaled
  double farthest = 0; ///< that it has been until then
};

/// Of a motion that is looked at so many times between two instants since its start, one after the
/// other; two passages between two looks are not seen. Ends with one that is `enough`.
std::vector<Passage> passages(const Plane &plane, const Vector &scale, double from, double to,
                              int looks, const std::function<Vector(double time)> &state_at,
                              const std::function<bool(const Passage &)> &enough = {});

/// Shared by all maps of one search or branch. Where keys change, the return that is looked for is
/// the one nearest to that at the nearest keys of the last motions, so that steps of a continuation
/// that were too long leave no trace in those after them.
class FreePeriod {
public:
  explicit FreePeriod(double period) : period_(period) {}

  /// Of the motion that was mapped last [s].
  double period() const { return period_; }
  void set_period(double period) { period_ = period; }

  /// That of a section; `make` is asked for one that is not there.
  const Plane &plane(double phase, const std::function<Plane()> &make);
  void set_plane(double phase, Plane plane);

  /// Keys are measured by these sizes from now on, and nothing is known at any.
  void set_key_sizes(Vector sizes);
  /// The present period is that at these keys.
  void note(const Vector &keys);
  /// Takes the one nearest to these keys; leaves it where none is known.
  void recall(const Vector &keys);

  /// All of it as numbers.
  std::vector<double> numbers() const;
  void restore(const std::vector<double> &numbers);

private:
  struct Noted {
    Vector keys; ///< in their sizes
    double period;
  };
  double period_;
  std::map<double, Plane> planes_; ///< by the phase that names the section
  Vector key_sizes_;
  std::vector<Noted> noted_; ///< the last ones
};

} // namespace vibroimpact::periodic
