// FlightKernel::fly in vector lanes: the same arithmetic, decisions by masks.
//
// Only for the files that bring a pack of numbers (lane_kernel_*.cc): `Pack` has the operations of
// a double, `Pack::Mask` the logical ones, and both are types of that file alone, so that no code
// for one instruction set is taken for another's.
#pragma once

#include "integration/flight_arithmetic.h"
#include "integration/lane_arrays.h"

namespace vibroimpact::integration::flight_arithmetic {

/// After so many pieces the caller may look whether the run is to stop.
constexpr int rounds_at_once = 4096;

template <class Pack> class LaneMachine {
public:
  using Mask = typename Pack::Mask;
  using Value = Height<Pack>;

  /// The lanes from `first` on, as many as a pack holds. A copy of the pointers, which no store can
  /// be thought to change.
  LaneMachine(const LaneArrays &arrays, std::size_t first) : a(arrays), first_(first) {}

  /// One piece or one look at an instant, in all lanes. True when a lane has come to its end or
  /// passed a piece that is watched.
  bool advance() {
    const Pack stage = load(a.stage);
    trying_ = stage == Pack(LaneArrays::trying);
    locating_ = stage == Pack(LaneArrays::locating);
    if (none_of(trying_ | locating_))
      return false;
    end_ = passed_ = Pack(LaneArrays::none);
    h_ = load(a.h);
    move();
    evaluate_and_judge();
    if (any_of(locating_))
      correct();
    if (any_of(trying_))
      decide();
    store(a.end, end_);
    store(a.passed, passed_);
    return any_of((Pack(LaneArrays::none) < end_) | (Pack(0.0) < passed_));
  }

private:
  Pack load(const double *array, std::size_t entry = 0) const {
    return Pack::load(array + entry * n_lanes + first_);
  }
  void store(double *array, std::size_t entry, Pack value) const {
    value.store(array + entry * n_lanes + first_);
  }
  void store(double *array, Pack value) const { store(array, 0, value); }
  void blend(double *array, Mask where, Pack value) const { blend(array, 0, where, value); }
  void blend(double *array, std::size_t entry, Mask where, Pack value) const {
    store(array, entry, select(where, value, load(array, entry)));
  }

  void move() {
    const Pack one(1.0);
    const Pack nothing(0.0);
    growth_ = one;
    for (std::size_t j = 0; j < a.n_groups; ++j) {
      const Pack rate = load(a.rate, j);
      const Pack frequency = load(a.frequency, j);
      const Pack factor = any_of(rate != nothing) ? exponential(rate * h_) : one;
      Pack sine = nothing;
      Pack cosine = one;
      if (any_of(frequency != nothing))
        sine_cosine(frequency * h_, sine, cosine);
      growth_ = larger(growth_, factor);
      Pack real;
      Pack imaginary;
      rotate(load(a.start_real, j), load(a.start_imaginary, j), factor, sine, cosine, real,
             imaginary);
      store(a.end_size, j, load(a.start_size, j) * factor);
      store(a.end_real, j, real);
      store(a.end_imaginary, j, imaginary);
    }
  }

  Value evaluate(std::size_t guard) const {
    const std::size_t first = first_;
    const std::size_t end = a.n_groups * n_lanes + first;
    const std::size_t row = guard * a.n_groups * n_lanes;
    const double *const rate = a.rate;
    const double *const frequency = a.frequency;
    const double *const end_real = a.end_real;
    const double *const end_imaginary = a.end_imaginary;
    const double *const real = a.real + row;
    const double *const imaginary = a.imaginary + row;
    Value result{load(a.constant, guard), Pack(0.0)};
    for (std::size_t i = first; i < end; i += n_lanes)
      add_group(Pack::load(real + i), Pack::load(imaginary + i), Pack::load(end_real + i),
                Pack::load(end_imaginary + i), Pack::load(rate + i), Pack::load(frequency + i),
                result);
    return result;
  }
  void keep(std::size_t guard, const Value &value) const {
    store(a.end_value, guard, value.value);
    store(a.end_slope, guard, value.slope);
  }
  Value start(std::size_t guard) const {
    return {load(a.start_value, guard), load(a.start_slope, guard)};
  }

  void evaluate_and_judge() {
    const Span<Pack> span(h_);
    unclear_ = false_mask();
    falls_ = Pack(0.0);
    falling_ = load(a.falling);
    for (std::size_t g = 0; g < a.n_guards; ++g) {
      const Value end = evaluate(g);
      keep(g, end);
      if (any_of(trying_))
        judge(g, end, span);
    }
  }

  void judge(std::size_t guard, const Value &end, const Span<Pack> &span) {
    const Value begin = start(guard);
    const Pack bound = growth_ * load(a.bound, guard);
    const Pack margin = growth_ * load(a.margin, guard);
    const Mask zero = Pack(0.0) < load(a.zero, guard);
    Mask stays = positive(begin, end, span, bound, margin) & !zero;
    if (any_of(zero))
      stays = stays | (positive_from_zero(begin, end, span, bound, margin) & zero);
    const Mask falls =
        flight_arithmetic::falling(begin, end, span, bound, margin) & !zero & !stays & trying_;
    unclear_ = unclear_ | !(stays | falls);
    falls_ = falls_ + select(falls, Pack(1.0), Pack(0.0));
    falling_ = select(falls, Pack(static_cast<double>(guard)), falling_);
  }

  // The falling guard of each lane.
  void pick(Value &begin, Value &end, Pack &margin) const {
    for (std::size_t g = 0; g < a.n_guards; ++g) {
      const Mask here = falling_ == Pack(static_cast<double>(g));
      begin.value = select(here, load(a.start_value, g), begin.value);
      begin.slope = select(here, load(a.start_slope, g), begin.slope);
      end.value = select(here, load(a.end_value, g), end.value);
      end.slope = select(here, load(a.end_slope, g), end.slope);
      margin = select(here, load(a.margin, g), margin);
    }
  }

  void decide() {
    unclear_ = unclear_ | (Pack(1.0) < falls_);
    const Mask halve = trying_ & unclear_;
    const Mask fall = trying_ & !unclear_ & (Pack(0.0) < falls_);
    const Mask pass = trying_ & !unclear_ & !fall;
    blend(a.pieces, trying_, load(a.pieces) + Pack(1.0));
    if (any_of(pass))
      accept(pass);
    if (any_of(halve))
      shorten(halve);
    if (any_of(fall))
      begin_to_locate(fall);
  }

  void shorten(Mask where) {
    const Pack tries = load(a.tries) + Pack(1.0);
    blend(a.tries, where, tries);
    const Mask goes_on = (tries < Pack(halvings)) & (Pack(0.0) < h_);
    end_ = select(where & !goes_on, Pack(LaneArrays::unclear), end_);
    blend(a.h, where, Pack(0.5) * h_);
  }

  void accept(Mask where) {
    const Mask too_short = where & (h_ < larger(load(a.shortest), load(a.least)));
    end_ = select(too_short, Pack(LaneArrays::unclear), end_);
    where = where & !too_short;
    const Pack limit = load(a.limit);
    const Pack before = load(a.flown);
    const Pack flown = select(h_ == limit - before, limit, before + h_);
    const Mask on = where & (flown < limit);
    end_ = select(where & !on, Pack(LaneArrays::at_limit), end_);
    blend(a.flown, where, flown);
    blend(a.accepted, where, load(a.accepted) + Pack(1.0));
    const Mask watched = where & (Pack(0.0) < load(a.watched));
    passed_ = select(watched, h_, passed_);
    move_start(where, watched);
    begin_to_try(where, limit - flown);
    end_ = select(on & !(Pack(0.0) < load(a.h)), Pack(LaneArrays::unclear), end_);
  }

  // The start goes to the end where it is still to be seen.
  void move_start(double *start, double *end, std::size_t group, Mask where, Mask watched) const {
    const Pack before = load(start, group);
    const Pack after = load(end, group);
    store(start, group, select(where, after, before));
    store(end, group, select(watched, before, after));
  }

  void move_start(Mask where, Mask watched) const {
    for (std::size_t j = 0; j < a.n_groups; ++j) {
      move_start(a.start_real, a.end_real, j, where, watched);
      move_start(a.start_imaginary, a.end_imaginary, j, where, watched);
      move_start(a.start_size, a.end_size, j, where, watched);
    }
    for (std::size_t g = 0; g < a.n_guards; ++g) {
      blend(a.start_value, g, where, load(a.end_value, g));
      blend(a.start_slope, g, where, load(a.end_slope, g));
      blend(a.zero, g, where, Pack(0.0));
    }
  }

  void begin_to_try(Mask where, Pack rest) const {
    Trial<Pack> trial(rest);
    for (std::size_t g = 0; g < a.n_guards; ++g) {
      Pack sum = absolute(load(a.constant, g));
      Pack bound(0.0);
      for (std::size_t j = 0; j < a.n_groups; ++j) {
        const Pack amplitude = load(a.start_size, j);
        sum = sum + load(a.size, g * a.n_groups + j) * amplitude;
        bound = bound + load(a.fourth, g * a.n_groups + j) * amplitude;
      }
      const Pack margin = Pack(rounding_factor) * sum;
      blend(a.margin, g, where, margin);
      blend(a.bound, g, where, bound);
      trial.add(start(g), bound, margin);
    }
    blend(a.h, where, trial.length());
    blend(a.least, where, trial.shortest());
    blend(a.tries, where, Pack(0.0));
  }

  void begin_to_locate(Mask where) {
    Value begin{Pack(0.0), Pack(0.0)};
    Value end = begin;
    Pack margin(0.0);
    pick(begin, end, margin);
    blend(a.falling, where, falling_);
    blend(a.low, where, Pack(0.0));
    blend(a.high, where, h_);
    blend(a.h, where, zero_of_cubic(begin, end, h_));
    blend(a.tries, where, Pack(0.0));
    blend(a.stage, where, Pack(LaneArrays::locating));
  }

  // Looks whether the instant is the zero; if not, where to look next.
  void correct() {
    Value begin{Pack(0.0), Pack(0.0)};
    Value there = begin;
    Pack margin(0.0);
    pick(begin, there, margin);
    const Pack negligible = Pack(negligible_part) * margin;
    const Mask at_once = locating_ & (absolute(there.value) <= negligible);
    finish(at_once, h_, there);
    Mask where = locating_ & !at_once;
    Bracket<Pack> bracket{load(a.low), load(a.high)};
    Pack next = bracket.next(h_, there);
    const Pack rest = next - h_;
    const Mask near = where & (absolute(rest) * load(a.fastest) <= Pack(short_reach));
    const Mask settled = absolute(rest) <= Pack(2 * epsilon) * next;
    if (any_of(near)) {
      move_little(near, rest);
      pick(begin, there, margin);
      const Mask now = near & (settled | (absolute(there.value) <= negligible));
      finish(now, next, there);
      where = where & !now;
      Bracket<Pack> narrower = bracket;
      const Pack after = narrower.next(next, there);
      next = select(near, after, next);
      bracket.low = select(near, narrower.low, bracket.low);
      bracket.high = select(near, narrower.high, bracket.high);
    }
    blend(a.low, where, bracket.low);
    blend(a.high, where, bracket.high);
    blend(a.h, where, next);
    const Pack tries = load(a.tries) + Pack(1.0);
    blend(a.tries, where, tries);
    end_ = select(where & !(tries < Pack(corrections)), Pack(LaneArrays::unclear), end_);
  }

  void finish(Mask where, Pack instant, const Value &there) {
    const Mask falls = there.slope < Pack(0.0);
    const Pack end = select(falls, Pack(LaneArrays::at_guard), Pack(LaneArrays::unclear));
    end_ = select(where, end, end_);
    blend(a.time_to_guard, where, instant);
    blend(a.residual, where, absolute(there.value / there.slope));
  }

  void move_little(Mask where, Pack time) const {
    for (std::size_t j = 0; j < a.n_groups; ++j) {
      Pack real = load(a.end_real, j);
      Pack imaginary = load(a.end_imaginary, j);
      Pack size = load(a.end_size, j);
      rotate_little(load(a.rate, j), load(a.frequency, j), time, real, imaginary, size);
      blend(a.end_real, j, where, real);
      blend(a.end_imaginary, j, where, imaginary);
      blend(a.end_size, j, where, size);
    }
    for (std::size_t g = 0; g < a.n_guards; ++g) {
      const Value there = evaluate(g);
      blend(a.end_value, g, where, there.value);
      blend(a.end_slope, g, where, there.slope);
    }
  }

  static Mask false_mask() { return Pack(1.0) < Pack(0.0); }

  const LaneArrays a;
  std::size_t first_;
  Pack h_, growth_, falls_, falling_, end_, passed_;
  Mask trying_, locating_, unclear_;
};

template <class Pack> void fly_lanes(const LaneArrays &arrays) {
  constexpr std::size_t n_packs = n_lanes / Pack::width;
  bool ended = false;
  for (int round = 0; round < rounds_at_once && !ended; ++round)
    for (std::size_t i = 0; i < n_packs; ++i)
      ended = LaneMachine<Pack>(arrays, i * Pack::width).advance() || ended;
}

} // namespace vibroimpact::integration::flight_arithmetic
