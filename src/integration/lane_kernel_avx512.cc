// Flights in lanes, eight numbers to a pack.
#include "integration/lane_arrays.h"

#ifdef __x86_64__

#include <sleef.h>

namespace vibroimpact::integration::flight_arithmetic {

namespace {

struct Pack8 {
  static constexpr std::size_t width = 8;
  struct Mask {
    __mmask8 bits;
    friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
    friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
    Mask operator!() const { return {static_cast<__mmask8>(~bits)}; }
  };

  Pack8() = default;
  explicit Pack8(double x) : v(_mm512_set1_pd(x)) {}
  explicit Pack8(__m512d x) : v(x) {}
  static Pack8 load(const double *from) { return Pack8(_mm512_load_pd(from)); }
  void store(double *to) const { _mm512_store_pd(to, v); }

  friend Pack8 operator+(Pack8 a, Pack8 b) { return Pack8(_mm512_add_pd(a.v, b.v)); }
  friend Pack8 operator-(Pack8 a, Pack8 b) { return Pack8(_mm512_sub_pd(a.v, b.v)); }
  friend Pack8 operator*(Pack8 a, Pack8 b) { return Pack8(_mm512_mul_pd(a.v, b.v)); }
  friend Pack8 operator/(Pack8 a, Pack8 b) { return Pack8(_mm512_div_pd(a.v, b.v)); }
  friend Mask operator<(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
  friend Mask operator<=(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)}; }
  friend Mask operator>(Pack8 a, Pack8 b) { return b < a; }
  friend Mask operator==(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
  friend Mask operator!=(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_NEQ_UQ)}; }

  __m512d v;
};

inline Pack8 select(Pack8::Mask where, Pack8 a, Pack8 b) {
  return Pack8(_mm512_mask_blend_pd(where.bits, b.v, a.v));
}
inline bool any_of(Pack8::Mask mask) { return mask.bits != 0; }
inline bool none_of(Pack8::Mask mask) { return mask.bits == 0; }
inline Pack8 square_root(Pack8 a) { return Pack8(_mm512_sqrt_pd(a.v)); }
inline Pack8 absolute(Pack8 a) { return Pack8(_mm512_abs_pd(a.v)); }
inline Pack8 exponential(Pack8 a) { return Pack8(Sleef_cinz_expd8_u10avx512fnofma(a.v)); }
inline void sine_cosine(Pack8 a, Pack8 &sine, Pack8 &cosine) {
  const Sleef___m512d_2 both = Sleef_cinz_sincosd8_u10avx512fnofma(a.v);
  sine.v = both.x;
  cosine.v = both.y;
}

} // namespace

} // namespace vibroimpact::integration::flight_arithmetic

#include "integration/lane_machine.h"

namespace vibroimpact::integration {

void fly_lanes_avx512(const LaneArrays &arrays) {
  flight_arithmetic::fly_lanes<flight_arithmetic::Pack8>(arrays);
}

} // namespace vibroimpact::integration

#endif
