// What the vector units work on: the flights of several kernels, entry by entry, lane by lane.
//
// Every array is [entry][lane], aligned to a vector of all lanes. What a kernel does not have (its
// groups or guards are fewer than the others') is filled up so that it changes nothing: amplitudes
// and coefficients zero, guards constantly one.
#pragma once

#include <cstddef>

namespace vibroimpact::integration {

constexpr std::size_t n_lanes = 8;

struct LaneArrays {
  /// Stages of a lane.
  static constexpr double idle = 0, trying = 1, locating = 2;
  /// Ends of a flight, as those of a kernel.
  static constexpr double none = 0, at_limit = 1, at_guard = 2, unclear = 3;

  std::size_t n_groups = 0, n_guards = 0; ///< capacity

  // groups
  double *rate, *frequency;
  double *start_real, *start_imaginary, *start_size; ///< amplitudes
  double *end_real, *end_imaginary, *end_size;
  // guards
  double *constant, *bound, *margin;
  double *zero; ///< 1: zero at the start
  double *start_value, *start_slope, *end_value, *end_slope;
  // guards x groups
  double *real, *imaginary, *fourth, *size;
  // one entry
  double *fastest, *limit, *shortest;
  double *least; ///< of the next piece, as by Trial::shortest()
  double *stage, *end;
  double *flown, *h; ///< time of the accepted pieces; length to be tried, or instant
  double *tries;     ///< halvings of a piece, or corrections of an instant
  double *low, *high, *falling, *time_to_guard, *residual;
  double *pieces, *accepted;
  double *watched; ///< 1: the lanes stop after each accepted piece, its start in place of its end
  double *passed;  ///< length of the piece that the lane stopped after; 0: none
};

/// Lets all lanes fly until one of them has come to its end, or a watched one has passed a piece,
/// or for some thousand pieces.
/// One function per instruction set.
using FlyLanes = void (*)(const LaneArrays &);

void fly_lanes_plain(const LaneArrays &arrays);
#ifdef __x86_64__
void fly_lanes_sse2(const LaneArrays &arrays);
void fly_lanes_avx2(const LaneArrays &arrays);
void fly_lanes_avx512(const LaneArrays &arrays);
#endif

} // namespace vibroimpact::integration
