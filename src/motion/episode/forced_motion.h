// What a contact sees of a linear system under its force: the motion along one direction, or along
// two at a right angle in the frame of the touch.
//
// Of a circular gap the outputs are u_1 and u_2 and the loads act along the same axes. With n, t
// normal and tangent at the touch, s and c of the gap (circular_gap.h), the contact sees
//
//   w_0 = -n . u - s c,  w_1 = t . u
//
// w_0 being the penetration there but for the turning of the normal, and its force is f_0 n + f_1
// t.
#pragma once

#include "motion/episode/contact_force.h"
#include "motion/episode/forced_flow.h"

#include <array>

namespace vibroimpact::motion {

/// Along the axes of a circular gap.
struct TouchFrame {
  std::array<double, 2> normal{1, 0};
  double touching = 0; ///< s c [m]

  std::array<double, 2> tangent() const { return {-normal[1], normal[0]}; }
};

class ForcedMotion {
public:
  /// Coefficients of Taylor series that are made use of at most.
  static constexpr int most_terms = 44;
  using Coefficients = std::array<double, most_terms>;

  /// Along the direction of the output. Keeps a reference, as does the next one.
  ForcedMotion(const ForcedOutput &only);
  /// Along two directions, most_terms coefficients of each; a frame is to be given.
  ForcedMotion(const ForcedOutput &first, const ForcedOutput &second);

  int n_directions() const { return n_; }
  double fastest() const { return outputs_[0]->flow().fastest(); }
  void turn_to(const TouchFrame &frame);
  /// Of each direction: coefficients of the free motion from x0, as ForcedOutput has them.
  void free_motion(const double *x, int terms,
                   std::array<Coefficients, most_axes> &coefficients) const;
  /// g_k of one direction to a force along another.
  double response(int of, int by, int k) const {
    return n_ == 1 ? outputs_[0]->responses()[k]
                   : turned_[static_cast<std::size_t>(2 * of + by)][static_cast<std::size_t>(k)];
  }

private:
  int n_;
  std::array<const ForcedOutput *, most_axes> outputs_;
  TouchFrame frame_;
  std::array<Coefficients, 4> turned_{}; ///< responses in the frame
};

} // namespace vibroimpact::motion
