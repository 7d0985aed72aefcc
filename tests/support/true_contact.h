// The first contact of a motion with a stop, from its closed form: by bounds on linear
// interpolation, double precision as far as 1e-9 from touching and multiprecision inside.
//
// A minimum of the gap within `band` of zero is a touch that rounding may take for a contact or
// not, also where the motion begins within the band and falls before it leaves.
#pragma once

#include "support/true_motion.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace vibroimpact::testing {

using Quad = boost::multiprecision::cpp_bin_float_quad;

struct TrueContact {
  std::optional<long double> time{}; ///< of the first fall through zero that leads below -band
  std::vector<double> touches{};     ///< minima within the band before it
  bool in_band = false;              ///< the gap is ever left undecided, also just before it falls
};

class TrueFlight {
public:
  TrueFlight(std::vector<TrueMode> modes, const TrueForce &force,
             const std::vector<double> &displacement, const std::vector<double> &velocity)
      : modes_(std::move(modes)), force_(force), displacement_(displacement), velocity_(velocity),
        coarse_(make<double>()), fine_(make<long double>()) {}

  /// What the terms of the gap add up to, each by its size.
  double size(double clearance, double end) const { return clearance + coarse_.size(end); }

  /// Of the gap clearance - side * displacement, side = 1 or -1.
  long double gap(double clearance, int side, long double time) const {
    return clearance - side * fine_.at(time)[0];
  }

  /// True when a contact could not be judged without it.
  bool used_multiprecision() const { return exact_ != nullptr; }

  /// Contact with that stop until `end`.
  TrueContact contact(double clearance, int side, double end, double band) const {
    Search search{.flight = *this, .clearance = clearance, .side = side, .band = band, .end = end};
    search.near = 1e-9 * size(clearance, end);
    search.second = coarse_.bound(2, end);
    search.third = coarse_.bound(3, end);
    search.fourth = coarse_.bound(4, end);
    search.leaving = search.found.in_band = search.value(0) <= band;
    search.divide(coarse_, 0.0, end, search.jet(coarse_, 0.0), search.jet(coarse_, end));
    return std::move(search.found);
  }

private:
  template <class R> TrueMotion<R> make() const {
    return TrueMotion<R>(modes_, force_, R(force_.phase),
                         {displacement_.begin(), displacement_.end()},
                         {velocity_.begin(), velocity_.end()});
  }

  struct Search {
    const TrueFlight &flight;
    double clearance;
    int side;
    double band;
    double end;
    TrueContact found{};
    double near = 0;
    double second = 0, third = 0, fourth = 0; // bounds of derivatives
    bool leaving = false;                     // still within the band it began in
    std::optional<long double> inside{};      // since when the gap is within the band

    template <class R> TrueJet<R> jet(const TrueMotion<R> &motion, R time) const {
      TrueJet<R> jet = motion.at(time);
      for (R &value : jet)
        value *= -side;
      jet[0] += clearance;
      return jet;
    }

    // Of the gap, by multiprecision where it is near zero.
    double value(long double time) const {
      const long double gap = flight.gap(clearance, side, time);
      if (std::abs(gap) > near)
        return static_cast<double>(gap);
      return static_cast<double>(Quad(clearance - side * flight.exact().at(Quad(time))[0]));
    }

    // True when the first contact is found.
    template <class R>
    bool divide(const TrueMotion<R> &motion, R from, R to, const TrueJet<R> &a,
                const TrueJet<R> &b) {
      const R h = to - from;
      const bool fine = sizeof(R) > sizeof(double);
      const R clear = fine ? R(band) : R(near);
      const R error = R(second) * h * h / 8;
      if (std::min(a[0], b[0]) - error > clear) {
        inside.reset();
        leaving = false;
        return false;
      }
      const R slope_error = R(third) * h * h / 8;
      const bool falls = std::max(a[1], b[1]) + slope_error < 0;
      const bool rises = std::min(a[1], b[1]) - slope_error > 0;
      const bool convex = std::min(a[2], b[2]) - R(fourth) * h * h / 8 > 0;
      const bool flat = std::max({a[0], b[0], -a[0], -b[0]}) + error <= clear;
      const bool small = flat || h < (fine ? R(1e-15L) : R(1e-8)) * R(end);
      if (!falls && !rises && !convex && !small) {
        const R middle = from + h / 2;
        const TrueJet<R> between = jet(motion, middle);
        return divide(motion, from, middle, a, between) || divide(motion, middle, to, between, b);
      }
      if (!fine) {
        const bool plain_fall = falls && a[0] > clear && b[0] < -clear;
        if (!plain_fall) {
          const long double l = from;
          const long double r = to;
          return divide<long double>(flight.fine_, l, r, jet<long double>(flight.fine_, l),
                                     jet<long double>(flight.fine_, r));
        }
      }
      if (convex && !falls && !rises && a[1] < 0 && b[1] > 0) {
        const long double lowest = minimum(from, to);
        return passes(from, lowest) || passes(lowest, to);
      }
      return passes(from, to);
    }

    long double minimum(long double lower, long double upper) const {
      for (int i = 0; i < 100; ++i) {
        const long double middle = lower + (upper - lower) / 2;
        if (middle <= lower || middle >= upper)
          break;
        const TrueJet<long double> at = jet<long double>(flight.fine_, middle);
        const long double newton = middle - at[1] / at[2];
        (at[1] < 0 ? lower : upper) = middle;
        if (newton > lower && newton < upper) {
          const bool below = jet<long double>(flight.fine_, newton)[1] < 0;
          (below ? lower : upper) = newton;
        }
      }
      return lower + (upper - lower) / 2;
    }

    // A monotonic piece, or one too short to be told from that.
    bool passes(long double from, long double to) {
      const double at_end = value(to);
      if (at_end < -band) {
        if (inside && !(leaving && found.touches.empty()))
          found.touches.pop_back();
        found.time = zero(inside.value_or(from), to);
        return true;
      }
      if (at_end <= band) {
        found.in_band = true;
        const bool falls_at_first = leaving && found.touches.empty() && at_end < value(from);
        if ((!inside && !leaving) || falls_at_first)
          found.touches.push_back(static_cast<double>(to));
        inside = inside.value_or(leaving ? 0 : from);
      } else {
        inside.reset();
        leaving = false;
      }
      return false;
    }

    long double zero(long double lower, long double upper) const {
      for (int i = 0; i < 120; ++i) {
        const long double middle = lower + (upper - lower) / 2;
        if (middle <= lower || middle >= upper)
          break;
        (jet<long double>(flight.fine_, middle)[0] > 0 ? lower : upper) = middle;
      }
      return upper;
    }
  };

  const TrueMotion<Quad> &exact() const {
    if (!exact_)
      exact_ = std::make_unique<TrueMotion<Quad>>(make<Quad>());
    return *exact_;
  }

  std::vector<TrueMode> modes_;
  TrueForce force_;
  std::vector<double> displacement_, velocity_;
  TrueMotion<double> coarse_;
  TrueMotion<long double> fine_;
  mutable std::unique_ptr<TrueMotion<Quad>> exact_; // made where it is needed
};

} // namespace vibroimpact::testing
