// Flights in lanes, four numbers to a pack.
#include "integration/lane_arrays.h"

#ifdef __x86_64__

#include <sleef.h>

namespace vibroimpact::integration::flight_arithmetic {

namespace {

struct Pack4 {
  static constexpr std::size_t width = 4;
  struct Mask {
    __m256d bits;
    friend Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.bits, b.bits)}; }
    friend Mask operator|(Mask a, Mask b) { return {_mm256_or_pd(a.bits, b.bits)}; }
    Mask operator!() const {
      return {_mm256_xor_pd(bits, _mm256_castsi256_pd(_mm256_set1_epi32(-1)))};
    }
  };

  Pack4() = default;
  explicit Pack4(double x) : v(_mm256_set1_pd(x)) {}
  explicit Pack4(__m256d x) : v(x) {}
  static Pack4 load(const double *from) { return Pack4(_mm256_load_pd(from)); }
  void store(double *to) const { _mm256_store_pd(to, v); }

  friend Pack4 operator+(Pack4 a, Pack4 b) { return Pack4(_mm256_add_pd(a.v, b.v)); }
  friend Pack4 operator-(Pack4 a, Pack4 b) { return Pack4(_mm256_sub_pd(a.v, b.v)); }
  friend Pack4 operator*(Pack4 a, Pack4 b) { return Pack4(_mm256_mul_pd(a.v, b.v)); }
  friend Pack4 operator/(Pack4 a, Pack4 b) { return Pack4(_mm256_div_pd(a.v, b.v)); }
  friend Mask operator<(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
  friend Mask operator<=(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
  friend Mask operator>(Pack4 a, Pack4 b) { return b < a; }
  friend Mask operator==(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
  friend Mask operator!=(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_NEQ_UQ)}; }

  __m256d v;
};

inline Pack4 select(Pack4::Mask where, Pack4 a, Pack4 b) {
  return Pack4(_mm256_blendv_pd(b.v, a.v, where.bits));
}
inline bool any_of(Pack4::Mask mask) { return _mm256_movemask_pd(mask.bits) != 0; }
inline bool none_of(Pack4::Mask mask) { return _mm256_movemask_pd(mask.bits) == 0; }
inline Pack4 square_root(Pack4 a) { return Pack4(_mm256_sqrt_pd(a.v)); }
inline Pack4 absolute(Pack4 a) { return Pack4(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)); }
inline Pack4 exponential(Pack4 a) { return Pack4(Sleef_cinz_expd4_u10avx(a.v)); }
inline void sine_cosine(Pack4 a, Pack4 &sine, Pack4 &cosine) {
  const Sleef___m256d_2 both = Sleef_cinz_sincosd4_u10avx(a.v);
  sine.v = both.x;
  cosine.v = both.y;
}

} // namespace

} // namespace vibroimpact::integration::flight_arithmetic

#include "integration/lane_machine.h"

namespace vibroimpact::integration {

void fly_lanes_avx2(const LaneArrays &arrays) {
  flight_arithmetic::fly_lanes<flight_arithmetic::Pack4>(arrays);
}

} // namespace vibroimpact::integration

#endif
