// The motion of uncoupled modes under one harmonic force in closed form, in any precision: the
// truth that integrated motions are compared with. Nothing of it is taken from the code under test.
//
//   q'' + d q' + k q = b A sin(W t + p)
//
// is solved by terms Re((c + c1 t) exp(e t)); c1 appears where the damping is critical, the mass is
// free, or the force meets the natural frequency of an undamped mode.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vibroimpact::testing {

struct TrueMode {
  double stiffness = 0; ///< k [1/s^2], mass 1
  double damping = 0;   ///< d [1/s]
  double load = 0;      ///< b
  double weight = 0;    ///< of the mode in the displacement that is looked at
};

struct TrueForce {
  double amplitude = 0, frequency = 1, phase = 0; ///< A, W, p
};

template <class R> struct TrueComplex {
  R re{}, im{};
  friend TrueComplex operator+(const TrueComplex &a, const TrueComplex &b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend TrueComplex operator*(const TrueComplex &a, const TrueComplex &b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend TrueComplex operator/(const TrueComplex &a, const TrueComplex &b) {
    const R size = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size};
  }
};

/// Displacement and its first derivatives.
template <class R> using TrueJet = std::array<R, 3>;

template <class R> class TrueMotion {
public:
  using Complex = TrueComplex<R>;

  /// From coordinates and velocities at time 0. `phase` is that of the force at time 0.
  TrueMotion(const std::vector<TrueMode> &modes, const TrueForce &force, const R &phase,
             const std::vector<R> &displacement, const std::vector<R> &velocity) {
    for (std::size_t j = 0; j < modes.size(); ++j)
      add_mode(modes[j], force, phase, displacement[j], velocity[j]);
    measure();
  }

  TrueJet<R> at(const R &time) const {
    TrueJet<R> jet{};
    for (const Term &term : terms_) {
      const Complex e = exponential(term.exponent, time);
      for (std::size_t m = 0; m < jet.size(); ++m)
        jet[m] += part(term, m, e, time);
    }
    return jet;
  }

  /// Bound of the m-th derivative, 2 <= m <= 4, from time 0 to `until`.
  R bound(std::size_t m, const R &until) const { return bounds_[m] + until * linear_bounds_[m]; }
  /// Sum of the sizes of all terms.
  R size(const R &until) const { return bounds_[0] + until * linear_bounds_[0]; }

private:
  // (c[m] + c1[m] t) exp(e t) is the m-th derivative of the term.
  struct Term {
    Complex exponent;
    std::array<Complex, 5> c, c1;
  };

  static Complex exponential(const Complex &e, const R &t) {
    using std::cos;
    using std::exp;
    using std::sin;
    const R size = e.re == 0 ? R(1) : R(exp(R(e.re * t)));
    if (e.im == 0)
      return {size, R(0)};
    const R angle = e.im * t;
    return {size * cos(angle), size * sin(angle)};
  }

  static R part(const Term &term, std::size_t m, const Complex &e, const R &time) {
    const R re = term.c[m].re + term.c1[m].re * time;
    const R im = term.c[m].im + term.c1[m].im * time;
    return re * e.re - im * e.im;
  }

  void add(const Complex &exponent, const Complex &c, const Complex &c1, double weight) {
    Term term{.exponent = exponent, .c = {}, .c1 = {}};
    const Complex w{R(weight), R(0)};
    term.c[0] = w * c;
    term.c1[0] = w * c1;
    for (std::size_t m = 1; m < term.c.size(); ++m) {
      term.c[m] = exponent * term.c[m - 1] + term.c1[m - 1];
      term.c1[m] = exponent * term.c1[m - 1];
    }
    terms_.push_back(term);
  }

  void add_mode(const TrueMode &mode, const TrueForce &force, const R &phase, R q, R v) {
    const R d = mode.damping;
    const R k = mode.stiffness;
    if (force.amplitude != 0 && mode.load != 0)
      add_response(mode, force, phase, q, v);
    using std::sqrt;
    const R discriminant = d * d / 4 - k;
    const R rate = v + d / 2 * q; // of q exp(d t / 2)
    if (discriminant < 0) {
      const R frequency = sqrt(R(-discriminant));
      add({-d / 2, frequency}, {q, R(-rate / frequency)}, {}, mode.weight);
    } else if (discriminant > 0) {
      const R root = sqrt(discriminant);
      add({-d / 2 + root, R(0)}, {R((q + rate / root) / 2), R(0)}, {}, mode.weight);
      add({-d / 2 - root, R(0)}, {R((q - rate / root) / 2), R(0)}, {}, mode.weight);
    } else {
      add({-d / 2, R(0)}, {q, R(0)}, {rate, R(0)}, mode.weight);
    }
  }

  // The forced part; q and v are left with what remains for the free one.
  void add_response(const TrueMode &mode, const TrueForce &force, const R &phase, R &q, R &v) {
    using std::cos;
    using std::sin;
    const R w = force.frequency;
    const R size = R(force.amplitude) * R(mode.load);
    // size sin(w t + phase) = Re(-i size exp(i phase) exp(i w t))
    const Complex input{R(size * sin(phase)), R(-size * cos(phase))};
    const R k = mode.stiffness;
    const R d = mode.damping;
    const Complex resistance{R(k - w * w), R(d * w)};
    Complex c{};
    Complex c1{};
    if (resistance.re == 0 && resistance.im == 0)
      c1 = input / Complex{R(0), R(2 * w)};
    else
      c = input / resistance;
    add({R(0), w}, c, c1, mode.weight);
    q -= c.re;
    v -= c1.re - w * c.im;
  }

  void measure() {
    using std::sqrt;
    for (const Term &term : terms_)
      for (std::size_t m = 0; m < bounds_.size(); ++m) {
        bounds_[m] += sqrt(R(term.c[m].re * term.c[m].re + term.c[m].im * term.c[m].im));
        linear_bounds_[m] += sqrt(R(term.c1[m].re * term.c1[m].re + term.c1[m].im * term.c1[m].im));
      }
  }

  std::vector<Term> terms_;
  std::array<R, 5> bounds_{}, linear_bounds_{}; // exponents must not have positive real parts
};

} // namespace vibroimpact::testing
