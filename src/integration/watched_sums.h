// Extreme values of sums of exponentials, piece by piece.
//
// Over a piece of length h a sum f lies within h^4 M / 384 of the cubic with its values and slopes
// at both ends, its slope within sqrt(3) h^3 M / 216 and its curvature within h^2 M / 12 of that
// cubic's, M being a bound of the fourth derivative. A piece that by this cannot leave the extent
// known so far is passed over; one in which f is monotone adds its ends; one in which f bends one
// way only adds the zero of its slope, found by Newton's method; all others are halved.
#pragma once

#include "integration/exponential_basis.h"
#include "integration/flight_watcher.h"
#include "integration/guard_sums.h"

#include <vector>

namespace vibroimpact::integration {

class WatchedSums {
public:
  /// The forms in a phase made of these exponentials; keeps references to both.
  WatchedSums(const WatchedForms &forms, const ExponentialBasis &basis);

  /// The frequencies of the inputs are others.
  void renew() { set_groups(basis_.n_modes()); }

  /// The next piece does not go on from the end of the last one.
  void begin() { goes_on_ = false; }
  /// The extents grow by a piece of the motion, `h` [s] long, from its amplitudes at both ends.
  void include(const Amplitudes &start, const Amplitudes &end, double h);

private:
  struct Point {
    double value = 0, slope = 0, curvature = 0;
    double fourth = 0; ///< bound of the fourth derivative from here on, if nothing grows
  };
  struct Piece {
    double from = 0, to = 0; ///< after the start of the piece asked for
    Point first, last;
  };

  void set_groups(std::size_t first);
  void set_coefficient(std::size_t form, std::size_t group, Complex seen);
  void move(double t);
  Point sum(std::size_t form, const std::vector<double> &real,
            const std::vector<double> &imaginary) const;
  Point at(std::size_t form, double t);
  double rounding(std::size_t form) const;
  void include(std::size_t form, const Piece &piece, int halvings);
  void include_turn(std::size_t form, const Piece &piece);

  const WatchedForms &forms_;
  const ExponentialBasis &basis_;
  std::vector<Extent *> extents_;
  std::vector<double> constants_;
  std::vector<double> rate_, frequency_;
  std::vector<double> real_, imaginary_, size_, fourth_; // forms x groups
  const Amplitudes *start_ = nullptr;                    // of the present piece
  double growth_ = 1;                                    // of any exponential in the piece
  double rounding_ = 0;                                  // of the values of the present form
  double moved_ = -1;                                    // the time of now_...
  std::vector<double> now_real_, now_imaginary_;         // amplitudes
  std::vector<Point> ends_;                              // of the last piece, by forms
  bool goes_on_ = false;                                 // the next piece begins there
};

} // namespace vibroimpact::integration
