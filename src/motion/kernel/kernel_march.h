// Propagation piece by piece, up to the first crossing; included by the kernel_*.cc only.
#pragma once

#include "motion/kernel/kernel_guards.h"

namespace vibroimpact::motion {
namespace {

enum class Verdict { positive, crossing, unclear };

class March : private GuardBounds {
public:
  March(const PhaseView &phase, MarchState &walk) : GuardBounds(phase, walk) {}

  MarchEnd advance(double limit) {
    for (int i = 0; w_.time < limit; ++i) {
      if (i == pieces_at_once)
        return MarchEnd::paused;
      const Step step = next_piece(limit - w_.time);
      if (step == Step::crossing)
        return MarchEnd::guard;
      if (step == Step::unclear)
        return MarchEnd::unclear;
      if (step == Step::limit)
        w_.time = limit;
    }
    return MarchEnd::limit;
  }

private:
  enum class Step { passed, limit, crossing, unclear };

  double *real() const { return w_.amplitudes; }
  double *imaginary() const { return w_.amplitudes + p_.n_padded; }

  void measure() {
    for (int b = 0; b < p_.n_padded; b += group_block)
      store(w_.magnitudes + b, magnitude(load(real() + b)) + magnitude(load(imaginary() + b)));
  }

  // Bound of the magnitudes within a piece.
  void reach(const LevelView &l) {
    for (int b = 0; b < p_.n_padded; b += group_block)
      store(w_.reach + b, load(w_.magnitudes + b) * load(l.growth + b));
    const double *e = l.dense_growth;
    for (int d = 0; d < p_.n_dense; ++d) {
      turn_dense(e, p_.dense[d], w_.magnitudes, w_.reach);
      e += p_.dense[d].size * p_.dense[d].size;
    }
  }

  // A guard that seems zero where the piece begins, without having been passed there, as where a
  // limit falls on a crossing: it is crossed at once if it falls, and starts from a zero if it
  // rises. Nothing of that kind: unclear.
  Verdict judge_edge(int g, Zero &first, Zero &second) {
    double f[2];
    low_derivatives(p_, g, w_.amplitudes, f);
    const double least = margin(g);
    if (f[0] > least)
      return Verdict::unclear;
    if (f[0] >= -least && f[1] >= 0) {
      w_.order[g] = 1;
      again_ = true;
      return Verdict::unclear;
    }
    add_zero({.guard = g, .tau = 0, .zone = 0, .proven = true}, first, second);
    return Verdict::crossing;
  }

  // Of two in a positive number, rounded down.
  static int exponent(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return static_cast<int>(bits >> 52) - 1023;
  }

  // The level at which the error of all guards is below the part `tolerated` of their sizes: the
  // error goes with the eighth power of the length, which makes a factor of 2^4 of one level.
  int wanted_level() const {
    const double size = weighted(p_.weights, w_.magnitudes) + p_.constant_weight;
    const double error = weighted(p_.weights + p_.n_padded, w_.magnitudes);
    if (!(error > 0) || !(size > 0))
      return 0;
    const int excess = exponent(error) - exponent(w_.tolerated * size);
    const int level = excess > 0 ? (excess + 3) / 4 : 0;
    return level < n_levels ? level : n_levels - 1;
  }

  const LevelView &level(int k) {
    if (!p_.levels[k].turn)
      p_.make_level(p_.owner, k);
    return p_.levels[k];
  }

  // Nothing can happen: no guard, or nothing that changes.
  bool at_rest() {
    if (p_.n_guards == 0)
      return true;
    if (p_.fastest > 0 || p_.n_dense > 0)
      return false;
    bool positive = true;
    for (int g = 0; g < p_.n_guards; ++g) {
      double f[2];
      low_derivatives(p_, g, w_.amplitudes, f);
      positive = positive && f[0] > margin(g);
    }
    return positive;
  }

  Step next_piece(double rest) {
    measure();
    if (at_rest())
      return pass_to_limit(rest);
    const int place = w_.pieces_of_phase % n_hints;
    signed char *hint = w_.pieces_of_phase < n_hints ? p_.hints + place : nullptr;
    const bool known = hint && *hint >= 0;
    int k = known ? *hint : wanted_level();
    for (int trial = 0; k < n_levels; ++trial) {
      const LevelView &l = level(k);
      Zero zero;
      touches_ = 0;
      again_ = false;
      reach(l);
      const Verdict verdict = judge(l, trial, rest, zero);
      ++w_.pieces;
      if (verdict == Verdict::unclear) {
        k += again_ ? 0 : 2;
        continue;
      }
      if (verdict == Verdict::crossing) {
        const Step found = cross(l, zero, rest);
        if (found == Step::unclear) {
          k += 2;
          continue;
        }
        remember(hint, k);
        return found;
      }
      remember(hint, k);
      ++w_.pieces_of_phase;
      w_.undecided += touches_;
      return pass(l, rest);
    }
    return Step::unclear;
  }

  // The next motion through here takes pieces that were short enough now; now and then it finds out
  // whether longer ones will do.
  void remember(signed char *hint, int k) const {
    if (!hint)
      return;
    const int wanted = wanted_level();
    *hint = static_cast<signed char>(k > wanted && w_.pieces % pieces_kept != 0 ? k : wanted);
  }

  Step pass(const LevelView &l, double rest) {
    const bool all_the_way = l.length >= rest;
    if (all_the_way)
      turn(p_, w_.amplitudes, rest, w_.turned);
    else
      turn_by(l, w_.amplitudes, w_.turned);
    const double h = all_the_way ? rest : l.length;
    // The factor of a length is rounded, always the same way: so many pieces in a row, and the
    // amplitudes are taken from those at the start again.
    if (!all_the_way && w_.pieces_of_phase % pieces_in_a_row == 0)
      turn(p_, w_.origin, w_.time + h, w_.turned);
    double *const before = w_.amplitudes;
    w_.amplitudes = w_.turned;
    w_.turned = before;
    for (int g = 0; g < p_.n_guards; ++g)
      w_.order[g] = 0;
    w_.time += h;
    return all_the_way ? Step::limit : Step::passed;
  }

  void turn_by(const LevelView &l, const double *from, double *to) const {
    const int n = p_.n_padded;
    for (int b = 0; b < n; b += group_block) {
      const V8 re = load(from + b);
      const V8 im = load(from + n + b);
      const V8 c = load(l.turn + b);
      const V8 s = load(l.turn + n + b);
      store(to + b, fused_minus(im, s, re * c));
      store(to + n + b, fused(im, c, re * s));
    }
    const double *e = l.dense;
    for (int d = 0; d < p_.n_dense; ++d) {
      turn_dense(e, p_.dense[d], from, to);
      e += p_.dense[d].size * p_.dense[d].size;
    }
  }

  // Two crossings that rounding alone cannot tell apart are taken one after the other.
  Verdict judge(const LevelView &l, int trial, double rest, Zero &first) {
    Zero second;
    for (int g = 0; g < p_.n_guards; ++g)
      if (judge_guard(l, g, trial, rest, first, second) == Verdict::unclear)
        return Verdict::unclear;
    if (first.guard < 0)
      return Verdict::positive;
    if (second.guard < 0 || first.tau + first.zone + 1e-5 < second.tau - second.zone)
      return Verdict::crossing;
    return by_rounding(l, first) && by_rounding(l, second) ? Verdict::crossing : Verdict::unclear;
  }

  Verdict judge_guard(const LevelView &l, int g, int trial, double rest, Zero &first,
                      Zero &second) {
    const int r = w_.order[g];
    if (const SquaresView *squares = squares_of(p_, g))
      return judge_squares(l, g, *squares, trial, rest, first, second);
    const double e = form_error(l, g, r);
    const V8 f = r > 0 ? coefficients(l, g) * load(order_weights[r - 1]) : coefficients(l, g);
    constexpr unsigned coefficients = 0xff;
    const unsigned judged = coefficients & ~((1u << r) - 1);
    const unsigned low = below_or_equal(f, all(e)) & judged;
    const unsigned negative = below(f, all(0) - all(e)) & judged;
    if (low == 0)
      return Verdict::positive;
    if (contiguous(low, coefficients) && contiguous(negative, coefficients) &&
        (low >> r & 1) == 0) {
      double b[8];
      store(b, f);
      add_zero(polynomial_zero(g, Polynomial(b, r), crossing_of(b, r, table_degree, low), e), first,
               second);
      return Verdict::crossing;
    }
    return judge_closer(l, g, (low & 1) != 0, trial, rest, first, second);
  }

  Verdict judge_squares(const LevelView &l, int g, const SquaresView &squares, int trial,
                        double rest, Zero &first, Zero &second) {
    const int r = w_.order[g];
    const SquaresOverPiece piece = over_piece(l, squares);
    const double e = error(l, piece, r);
    double b[16];
    piece.coefficients(b);
    if (r > 0)
      for (int k = 0; k < 16; k += 8)
        store(b + k, load(b + k) * load(of_squares.order_weights[r - 1] + k));
    const unsigned judged = coefficients_of_square & ~((1u << r) - 1);
    const unsigned low =
        (below_or_equal(load(b), all(e)) | below_or_equal(load(b + 8), all(e)) << 8) & judged;
    const unsigned negative = (below(load(b), all(-e)) | below(load(b + 8), all(-e)) << 8) & judged;
    if (low == 0)
      return Verdict::positive;
    if (contiguous(low, coefficients_of_square) && contiguous(negative, coefficients_of_square) &&
        (low >> r & 1) == 0) {
      add_zero(polynomial_zero(g, SquaresPolynomial(piece, r),
                               crossing_of(b, r, 2 * table_degree, low), e),
               first, second);
      return Verdict::crossing;
    }
    return judge_closer(l, g, (low & 1) != 0, trial, rest, first, second);
  }

  // Of a guard whose coefficients prove nothing; `at_start`: the first of them is that low.
  Verdict judge_closer(const LevelView &l, int g, bool at_start, int trial, double rest,
                       Zero &first, Zero &second) {
    const int r = w_.order[g];
    if (r == 0 && at_start)
      if (const Verdict edge = judge_edge(g, first, second); edge != Verdict::unclear || again_)
        return edge;
    if (trial < trials_before_touch || r > 0)
      return Verdict::unclear;
    return judge_touch(l, g, rest, first, second);
  }

  static void add_zero(const Zero &zero, Zero &first, Zero &second) {
    if (first.guard < 0 || zero.tau < first.tau) {
      if (first.guard >= 0 && (second.guard < 0 || first.tau < second.tau))
        second = first;
      first = zero;
    } else if (second.guard < 0 || zero.tau < second.tau) {
      second = zero;
    }
  }

  // A guard that bends upwards all along has at most one minimum: found to rounding, it tells what
  // trials with ever shorter pieces would not.
  Verdict judge_touch(const LevelView &l, int g, double rest, Zero &first, Zero &second) {
    const double h = l.length < rest ? l.length : rest;
    double start[4];
    double end[4];
    derivatives(p_, g, w_.amplitudes, start);
    turn(p_, w_.amplitudes, h, w_.turned);
    derivatives(p_, g, w_.turned, end);
    const double third = third_derivative(g);
    const double least = start[2] < end[2] ? start[2] : end[2];
    const double m = margin(g);
    if (!(least - 0.5 * third * h > 0) || !(start[0] > m))
      return Verdict::unclear;
    if (start[1] >= 0)
      return Verdict::positive;
    if (end[1] < 0) // falls all along, ever more slowly
      return end[0] > m    ? Verdict::positive
             : end[0] < -m ? convex_zero(l, g, h, first, second)
                           : Verdict::unclear;
    double lower = 0;
    double upper = h;
    double t = h * start[1] / (start[1] - end[1]);
    double f[4];
    for (int i = 0; i < 60; ++i) {
      turn(p_, w_.amplitudes, t, w_.turned);
      derivatives(p_, g, w_.turned, f);
      (f[1] < 0 ? lower : upper) = t;
      // The value at the minimum is f - f'^2 / (2 f'') to the third order.
      if (f[1] * f[1] <= 0.01 * m * f[2])
        break;
      double next = t - f[1] / f[2];
      if (!(next > lower && next < upper))
        next = 0.5 * (lower + upper);
      if (next == t)
        break;
      t = next;
    }
    if (f[0] > m)
      return Verdict::positive;
    if (f[0] < -m)
      return convex_zero(l, g, t, first, second);
    ++touches_;
    return Verdict::positive;
  }

  // Newton's method from the left never passes the zero of a function that bends upwards.
  Verdict convex_zero(const LevelView &l, int g, double upper, Zero &first, Zero &second) {
    double t = 0;
    double f[4];
    for (int i = 0; i < 100; ++i) {
      turn(p_, w_.amplitudes, t, w_.turned);
      derivatives(p_, g, w_.turned, f);
      const double step = -f[0] / f[1];
      if (!(f[1] < 0) || !(step > 2 * epsilon * t) || !(t + step < upper))
        break;
      t += step;
    }
    add_zero({.guard = g, .tau = t / l.length, .zone = 0, .proven = true}, first, second);
    return Verdict::crossing;
  }

  // Halley's method by the exponentials, t after the start of the piece, to the zero itself; a step
  // that is short enough is made by the Taylor series instead. False: it does not settle.
  bool settle(int g, double &t, double *f) {
    constexpr double negligible = 0.04; // part of what rounding may hide
    turn(p_, w_.amplitudes, t, w_.turned);
    for (int i = 0; i < most_corrections; ++i) {
      derivatives(p_, g, w_.turned, f);
      if (i > 1 && __builtin_fabs(f[0]) <= negligible * margin(g))
        return true;
      const double bend = f[2] / f[1];
      double step = -f[0] / f[1];
      step -= 0.5 * step * step * bend;
      const double size = __builtin_fabs(step);
      const double reach = size * (p_.fastest + __builtin_fabs(bend));
      t += step;
      if (!(t >= 0)) {
        t = 0;
        turn(p_, w_.amplitudes, 0, w_.turned);
        low_derivatives(p_, g, w_.turned, f);
        return __builtin_fabs(f[0]) <= margin(g);
      }
      if (reach < little_turn) {
        turn_little(p_, step, w_.turned);
        if (reach < final_turn || size <= 2 * epsilon * t) {
          low_derivatives(p_, g, w_.turned, f);
          return true;
        }
      } else {
        turn(p_, w_.amplitudes, t, w_.turned);
      }
    }
    return false;
  }

  // To the zero itself, and the proof that the guard has no other in the piece: where |f| <= E, f'
  // cannot change its sign.
  Step cross(const LevelView &l, const Zero &zero, double rest) {
    const int g = zero.guard;
    double t = zero.tau * l.length;
    double f[4];
    // Where the guard is flat, Halley's method may leave the piece for another zero.
    if (!settle(g, t, f) || t > l.length) {
      t = zero.tau * l.length;
      turn(p_, w_.amplitudes, t, w_.turned);
      derivatives(p_, g, w_.turned, f);
      if (__builtin_fabs(f[0]) > margin(g))
        return Step::unclear;
    }
    const double error_there = error(l, g, w_.order[g]);
    const double second = second_derivative(g);
    double zone = error_there;
    for (int i = 0; i < w_.order[g]; ++i)
      zone *= zero.tau;
    // On either side of t the guard moves by f'^2 / (2 M) before its slope can vanish, M bounding
    // |f''|. Where that is more than 2 E, beyond which the sign is that of the polynomial, the
    // guard changes its sign once: f'^2 > 4 M E, and twice that leaves room for rounding. Where
    // rounding is most of E no shorter piece proves more: the sign changes once, within |f| <= E.
    if (!(f[1] < 0) ||
        (!zero.proven && !(f[1] * f[1] > 8 * second * zone) && !by_rounding(l, zero)))
      return Step::unclear;
    if (t > rest) { // none before the limit
      ++w_.pieces_of_phase;
      return pass_to_limit(rest);
    }
    w_.guard = g;
    w_.to_guard = t;
    w_.value = f[0];
    w_.slope = f[1];
    return Step::crossing;
  }

  Step pass_to_limit(double rest) {
    LevelView whole;
    whole.length = rest;
    return pass(whole, rest);
  }

  static constexpr int pieces_at_once = 10000, pieces_in_a_row = 16;
  static constexpr int pieces_kept = 32;
  static constexpr int trials_before_touch = 2;
  static constexpr int most_corrections = 60;

  long touches_ = 0;   ///< in the present trial
  bool again_ = false; ///< the same piece is to be judged with another order
};

} // namespace
} // namespace vibroimpact::motion
