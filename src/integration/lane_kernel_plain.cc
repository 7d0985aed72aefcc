// Flights in lanes without vectors, for any machine.
#include "integration/lane_arrays.h"

#include <cmath>
#include <sleef.h>

namespace vibroimpact::integration::flight_arithmetic {

namespace {

struct Pack1 {
  static constexpr std::size_t width = 1;
  struct Mask {
    bool bits;
    friend Mask operator&(Mask a, Mask b) { return {a.bits && b.bits}; }
    friend Mask operator|(Mask a, Mask b) { return {a.bits || b.bits}; }
    Mask operator!() const { return {!bits}; }
  };

  Pack1() = default;
  explicit Pack1(double x) : v(x) {}
  static Pack1 load(const double *from) { return Pack1(*from); }
  void store(double *to) const { *to = v; }

  friend Pack1 operator+(Pack1 a, Pack1 b) { return Pack1(a.v + b.v); }
  friend Pack1 operator-(Pack1 a, Pack1 b) { return Pack1(a.v - b.v); }
  friend Pack1 operator*(Pack1 a, Pack1 b) { return Pack1(a.v * b.v); }
  friend Pack1 operator/(Pack1 a, Pack1 b) { return Pack1(a.v / b.v); }
  friend Mask operator<(Pack1 a, Pack1 b) { return {a.v < b.v}; }
  friend Mask operator<=(Pack1 a, Pack1 b) { return {a.v <= b.v}; }
  friend Mask operator>(Pack1 a, Pack1 b) { return {a.v > b.v}; }
  friend Mask operator==(Pack1 a, Pack1 b) { return {a.v == b.v}; }
  friend Mask operator!=(Pack1 a, Pack1 b) { return {a.v != b.v}; }

  double v;
};

inline Pack1 select(Pack1::Mask where, Pack1 a, Pack1 b) { return where.bits ? a : b; }
inline bool any_of(Pack1::Mask mask) { return mask.bits; }
inline bool none_of(Pack1::Mask mask) { return !mask.bits; }
inline Pack1 square_root(Pack1 a) { return Pack1(std::sqrt(a.v)); }
inline Pack1 absolute(Pack1 a) { return Pack1(std::abs(a.v)); }
inline Pack1 exponential(Pack1 a) { return Pack1(Sleef_cinz_expd1_u10purec(a.v)); }
inline void sine_cosine(Pack1 a, Pack1 &sine, Pack1 &cosine) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(a.v);
  sine.v = both.x;
  cosine.v = both.y;
}

} // namespace

} // namespace vibroimpact::integration::flight_arithmetic

#include "integration/lane_machine.h"

namespace vibroimpact::integration {

void fly_lanes_plain(const LaneArrays &arrays) {
  flight_arithmetic::fly_lanes<flight_arithmetic::Pack1>(arrays);
}

} // namespace vibroimpact::integration
