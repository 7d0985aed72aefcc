// Flights in lanes, two numbers to a pack.
#include "integration/lane_arrays.h"

#ifdef __x86_64__

#include <sleef.h>

namespace vibroimpact::integration::flight_arithmetic {

namespace {

struct Pack2 {
  static constexpr std::size_t width = 2;
  struct Mask {
    __m128d bits;
    friend Mask operator&(Mask a, Mask b) { return {_mm_and_pd(a.bits, b.bits)}; }
    friend Mask operator|(Mask a, Mask b) { return {_mm_or_pd(a.bits, b.bits)}; }
    Mask operator!() const { return {_mm_xor_pd(bits, _mm_castsi128_pd(_mm_set1_epi32(-1)))}; }
  };

  Pack2() = default;
  explicit Pack2(double x) : v(_mm_set1_pd(x)) {}
  explicit Pack2(__m128d x) : v(x) {}
  static Pack2 load(const double *from) { return Pack2(_mm_load_pd(from)); }
  void store(double *to) const { _mm_store_pd(to, v); }

  friend Pack2 operator+(Pack2 a, Pack2 b) { return Pack2(_mm_add_pd(a.v, b.v)); }
  friend Pack2 operator-(Pack2 a, Pack2 b) { return Pack2(_mm_sub_pd(a.v, b.v)); }
  friend Pack2 operator*(Pack2 a, Pack2 b) { return Pack2(_mm_mul_pd(a.v, b.v)); }
  friend Pack2 operator/(Pack2 a, Pack2 b) { return Pack2(_mm_div_pd(a.v, b.v)); }
  friend Mask operator<(Pack2 a, Pack2 b) { return {_mm_cmplt_pd(a.v, b.v)}; }
  friend Mask operator<=(Pack2 a, Pack2 b) { return {_mm_cmple_pd(a.v, b.v)}; }
  friend Mask operator>(Pack2 a, Pack2 b) { return b < a; }
  friend Mask operator==(Pack2 a, Pack2 b) { return {_mm_cmpeq_pd(a.v, b.v)}; }
  friend Mask operator!=(Pack2 a, Pack2 b) { return {_mm_cmpneq_pd(a.v, b.v)}; }

  __m128d v;
};

inline Pack2 select(Pack2::Mask where, Pack2 a, Pack2 b) {
  return Pack2(_mm_or_pd(_mm_and_pd(where.bits, a.v), _mm_andnot_pd(where.bits, b.v)));
}
inline bool any_of(Pack2::Mask mask) { return _mm_movemask_pd(mask.bits) != 0; }
inline bool none_of(Pack2::Mask mask) { return _mm_movemask_pd(mask.bits) == 0; }
inline Pack2 square_root(Pack2 a) { return Pack2(_mm_sqrt_pd(a.v)); }
inline Pack2 absolute(Pack2 a) { return Pack2(_mm_andnot_pd(_mm_set1_pd(-0.0), a.v)); }
inline Pack2 exponential(Pack2 a) { return Pack2(Sleef_cinz_expd2_u10sse2(a.v)); }
inline void sine_cosine(Pack2 a, Pack2 &sine, Pack2 &cosine) {
  const Sleef___m128d_2 both = Sleef_cinz_sincosd2_u10sse2(a.v);
  sine.v = both.x;
  cosine.v = both.y;
}

} // namespace

} // namespace vibroimpact::integration::flight_arithmetic

#include "integration/lane_machine.h"

namespace vibroimpact::integration {

void fly_lanes_sse2(const LaneArrays &arrays) {
  flight_arithmetic::fly_lanes<flight_arithmetic::Pack2>(arrays);
}

} // namespace vibroimpact::integration

#endif
