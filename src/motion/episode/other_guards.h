// The proof that nothing else happens in a linear phase while a contact lasts within it.
//
// With J the impulse of a force that pushes, h the value a linear form would have without the
// force, and g what one unit of impulse makes of it,
//
//   h(t) + forced part >= h(0) + min(0, h'(0) T) - T^2/2 max|h''|
//                         - J (max(0, -g(0)) + T max(0, -g'(0)) + T^2/2 max|g''|)
//
// with the signs of g turned for what of it pulls, and of both for the other bound. A guard that is
// a sum of squares of such forms is bounded by their bounds.
#pragma once

#include "motion/phase/exact_phases.h"

#include <span>
#include <vector>

namespace vibroimpact::motion {

/// A force along one direction, over a contact.
struct Push {
  const double *load = nullptr;    ///< what one unit of impulse adds to the amplitudes
  double pushing = 0, pulling = 0; ///< impulses of what has its sign, and the other [N s]
};

class OtherGuards {
public:
  /// Keeps a reference.
  explicit OtherGuards(LinearPhase &linear) : linear_(linear) {}

  /// Do all guards but those of `contact` stay positive for `duration` [s] from the amplitudes on?
  bool stay_positive(std::size_t contact, const double *amplitudes, double duration,
                     std::span<const Push> pushes);
  std::size_t bytes() const;

private:
  void set_reach(const double *x, double duration);
  double second_derivative(std::size_t form) const;
  void bound_free_motion(const double *amplitudes, double duration);
  void add(const Push &push, double duration);
  double least_of_guard(std::size_t guard) const;

  LinearPhase &linear_;
  std::vector<double> reach_;        ///< of magnitudes within the contact, by places
  std::vector<double> least_, most_; ///< of each form
};

} // namespace vibroimpact::motion
