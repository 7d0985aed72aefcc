// Eight numbers side by side, as the machine of the file that includes it has them: one register
// of AVX-512, two of AVX2 with FMA, or plain numbers. Only kernel_avx512.cc, kernel_avx2.cc and
// kernel_plain.cc include it.
//
// AVX-512 and AVX2 give the same bits: multiplications and additions are fused only where `fused`
// stands (the files are compiled with -ffp-contract=off), and sums over the eight have one order.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__AVX512F__) || (defined(__AVX2__) && defined(__FMA__))
#include <immintrin.h>
#endif

namespace vibroimpact::motion {
namespace { // each including file has its own

#if defined(__AVX512F__)

struct V8 {
  __m512d v;
};
using Bits8 = __m512i;

inline V8 load(const double *p) { return {_mm512_loadu_pd(p)}; }
inline void store(double *p, V8 a) { _mm512_storeu_pd(p, a.v); }
inline V8 all(double a) { return {_mm512_set1_pd(a)}; }
inline V8 operator+(V8 a, V8 b) { return {_mm512_add_pd(a.v, b.v)}; }
inline V8 operator-(V8 a, V8 b) { return {_mm512_sub_pd(a.v, b.v)}; }
inline V8 operator*(V8 a, V8 b) { return {_mm512_mul_pd(a.v, b.v)}; }
inline V8 operator/(V8 a, V8 b) { return {_mm512_div_pd(a.v, b.v)}; }
/// a b + c and c - a b, rounded once
inline V8 fused(V8 a, V8 b, V8 c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
inline V8 fused_minus(V8 a, V8 b, V8 c) { return {_mm512_fnmadd_pd(a.v, b.v, c.v)}; }
inline V8 magnitude(V8 a) { return {_mm512_abs_pd(a.v)}; }
inline V8 square_root(V8 a) { return {_mm512_sqrt_pd(a.v)}; }
inline V8 lower(V8 a, V8 b) { return {_mm512_min_pd(a.v, b.v)}; }
inline V8 upper(V8 a, V8 b) { return {_mm512_max_pd(a.v, b.v)}; }
/// One bit for each place in which a < b, the first place in the lowest bit.
inline unsigned below(V8 a, V8 b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ); }
inline unsigned below_or_equal(V8 a, V8 b) { return _mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ); }
inline Bits8 bits(V8 a) { return _mm512_castpd_si512(a.v); }
/// a where the bit `place` of `which` is set, else b
template <int place> V8 by_bit(Bits8 which, V8 a, V8 b) {
  const __mmask8 mask = _mm512_test_epi64_mask(which, _mm512_set1_epi64(std::int64_t{1} << place));
  return {_mm512_mask_blend_pd(mask, b.v, a.v)};
}
/// 2^n, n the number in the low bits
inline V8 power_of_two(Bits8 n) { return {_mm512_castsi512_pd(_mm512_slli_epi64(n, 52))}; }
inline double sum(V8 a) {
  const __m256d four =
      _mm256_add_pd(_mm512_castpd512_pd256(a.v), _mm512_extractf64x4_pd(a.v, 1)); // i + (i + 4)
  const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
  return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
}

#elif defined(__AVX2__) && defined(__FMA__)

struct V8 {
  __m256d a, b;
};
struct Bits8 {
  __m256i a, b;
};

inline V8 load(const double *p) { return {_mm256_loadu_pd(p), _mm256_loadu_pd(p + 4)}; }
inline void store(double *p, V8 x) {
  _mm256_storeu_pd(p, x.a);
  _mm256_storeu_pd(p + 4, x.b);
}
inline V8 all(double x) { return {_mm256_set1_pd(x), _mm256_set1_pd(x)}; }
inline V8 operator+(V8 x, V8 y) { return {_mm256_add_pd(x.a, y.a), _mm256_add_pd(x.b, y.b)}; }
inline V8 operator-(V8 x, V8 y) { return {_mm256_sub_pd(x.a, y.a), _mm256_sub_pd(x.b, y.b)}; }
inline V8 operator*(V8 x, V8 y) { return {_mm256_mul_pd(x.a, y.a), _mm256_mul_pd(x.b, y.b)}; }
inline V8 operator/(V8 x, V8 y) { return {_mm256_div_pd(x.a, y.a), _mm256_div_pd(x.b, y.b)}; }
inline V8 fused(V8 x, V8 y, V8 z) {
  return {_mm256_fmadd_pd(x.a, y.a, z.a), _mm256_fmadd_pd(x.b, y.b, z.b)};
}
inline V8 fused_minus(V8 x, V8 y, V8 z) {
  return {_mm256_fnmadd_pd(x.a, y.a, z.a), _mm256_fnmadd_pd(x.b, y.b, z.b)};
}
inline V8 magnitude(V8 x) {
  const __m256d sign = _mm256_set1_pd(-0.0);
  return {_mm256_andnot_pd(sign, x.a), _mm256_andnot_pd(sign, x.b)};
}
inline V8 square_root(V8 x) { return {_mm256_sqrt_pd(x.a), _mm256_sqrt_pd(x.b)}; }
inline V8 lower(V8 x, V8 y) { return {_mm256_min_pd(x.a, y.a), _mm256_min_pd(x.b, y.b)}; }
inline V8 upper(V8 x, V8 y) { return {_mm256_max_pd(x.a, y.a), _mm256_max_pd(x.b, y.b)}; }
inline unsigned below(V8 x, V8 y) {
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x.a, y.a, _CMP_LT_OQ))) |
         static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x.b, y.b, _CMP_LT_OQ))) << 4;
}
inline unsigned below_or_equal(V8 x, V8 y) {
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x.a, y.a, _CMP_LE_OQ))) |
         static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x.b, y.b, _CMP_LE_OQ))) << 4;
}
inline Bits8 bits(V8 x) { return {_mm256_castpd_si256(x.a), _mm256_castpd_si256(x.b)}; }
template <int place> V8 by_bit(Bits8 which, V8 x, V8 y) {
  const auto one = [](__m256i w, __m256d p, __m256d q) {
    return _mm256_blendv_pd(q, p, _mm256_castsi256_pd(_mm256_slli_epi64(w, 63 - place)));
  };
  return {one(which.a, x.a, y.a), one(which.b, x.b, y.b)};
}
inline V8 power_of_two(Bits8 n) {
  return {_mm256_castsi256_pd(_mm256_slli_epi64(n.a, 52)),
          _mm256_castsi256_pd(_mm256_slli_epi64(n.b, 52))};
}
inline double sum(V8 x) {
  const __m256d four = _mm256_add_pd(x.a, x.b);
  const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
  return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
}

#else

struct V8 {
  double v[8];
};
struct Bits8 {
  std::uint64_t v[8];
};

template <class Function> V8 each(Function function) {
  V8 result;
  for (int i = 0; i < 8; ++i)
    result.v[i] = function(i);
  return result;
}
inline V8 load(const double *p) {
  V8 result;
  std::memcpy(result.v, p, sizeof result.v);
  return result;
}
inline void store(double *p, const V8 &a) { std::memcpy(p, a.v, sizeof a.v); }
inline V8 all(double a) {
  return each([&](int) { return a; });
}
inline V8 operator+(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] + b.v[i]; });
}
inline V8 operator-(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] - b.v[i]; });
}
inline V8 operator*(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] * b.v[i]; });
}
inline V8 operator/(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] / b.v[i]; });
}
inline V8 fused(const V8 &a, const V8 &b, const V8 &c) {
  return each([&](int i) { return a.v[i] * b.v[i] + c.v[i]; });
}
inline V8 fused_minus(const V8 &a, const V8 &b, const V8 &c) {
  return each([&](int i) { return c.v[i] - a.v[i] * b.v[i]; });
}
inline V8 magnitude(const V8 &a) {
  return each([&](int i) { return std::abs(a.v[i]); });
}
inline V8 square_root(const V8 &a) {
  return each([&](int i) { return std::sqrt(a.v[i]); });
}
inline V8 lower(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
inline V8 upper(const V8 &a, const V8 &b) {
  return each([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
inline unsigned below(const V8 &a, const V8 &b) {
  unsigned mask = 0;
  for (int i = 0; i < 8; ++i)
    mask |= a.v[i] < b.v[i] ? 1u << i : 0u;
  return mask;
}
inline unsigned below_or_equal(const V8 &a, const V8 &b) {
  unsigned mask = 0;
  for (int i = 0; i < 8; ++i)
    mask |= a.v[i] <= b.v[i] ? 1u << i : 0u;
  return mask;
}
inline Bits8 bits(const V8 &a) {
  Bits8 result;
  std::memcpy(result.v, a.v, sizeof result.v);
  return result;
}
template <int place> V8 by_bit(const Bits8 &which, const V8 &a, const V8 &b) {
  return each([&](int i) { return (which.v[i] >> place & 1) != 0 ? a.v[i] : b.v[i]; });
}
inline V8 power_of_two(const Bits8 &n) {
  Bits8 shifted;
  for (int i = 0; i < 8; ++i)
    shifted.v[i] = n.v[i] << 52;
  V8 result;
  std::memcpy(result.v, shifted.v, sizeof result.v);
  return result;
}
inline double sum(const V8 &a) {
  return (a.v[0] + a.v[4] + (a.v[2] + a.v[6])) + (a.v[1] + a.v[5] + (a.v[3] + a.v[7]));
}

#endif

/// a b + c, rounded once where the vectors are
inline double fused(double a, double b, double c) {
#if defined(__FMA__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

// Adding and subtracting it rounds to the nearest integer, which then stands in the low bits.
constexpr double rounder = 0x1.8p52;

/// exp(x) to 1.2 units of the last place for |x| <= 708; clamped beyond. x = n ln 2 + r, |r| <= ln
/// 2 / 2, ln 2 in two parts, and the Taylor polynomial of degree 13 in r: remainder below 5e-18.
inline V8 exponential(V8 x) {
  x = lower(upper(x, all(-708)), all(708));
  const V8 shifted = fused(x, all(0x1.71547652b82fep0), all(rounder));
  const V8 n = shifted - all(rounder);
  const V8 r = fused_minus(n, all(0x1.a39ef35793c76p-33), fused_minus(n, all(0x1.62e42feep-1), x));
  const V8 r2 = r * r;
  const V8 r4 = r2 * r2;
  const V8 low = fused(r2, fused(r, all(1.0 / 6), all(0.5)), r);
  const V8 middle =
      fused(r2, fused(r, all(1.0 / 5040), all(1.0 / 720)), fused(r, all(1.0 / 120), all(1.0 / 24)));
  const V8 high = fused(r4, fused(r, all(1.0 / 6227020800.0), all(1.0 / 479001600)),
                        fused(r2, fused(r, all(1.0 / 39916800), all(1.0 / 3628800)),
                              fused(r, all(1.0 / 362880), all(1.0 / 40320))));
  const V8 part = fused(r4, fused(r4, high, middle), low);
  const Bits8 exponent = bits((n + all(1023)) + all(rounder));
  return fused(part, power_of_two(exponent), power_of_two(exponent));
}

struct SineCosine8 {
  V8 sine, cosine;
};

/// To a unit of the last place of one for |x| <= 1e5, beyond which the reduction loses digits: x =
/// n pi / 2 + r, pi / 2 in three parts of 33 bits and the rest, so that their products with n are
/// exact without fused operations too; Taylor polynomials to r^17 and r^16, |r| <= pi / 4, whose
/// remainders are below 1e-18.
inline SineCosine8 sine_cosine(V8 x) {
  const V8 shifted = fused(x, all(0x1.45f306dc9c883p-1), all(rounder));
  const V8 n = shifted - all(rounder);
  V8 r = fused_minus(n, all(0x1.921fb544p0), x);
  r = fused_minus(n, all(0x1.0b4611a6p-34), r);
  r = fused_minus(n, all(0x1.3198a2e037073p-69), r);
  const V8 r2 = r * r;
  const V8 r4 = r2 * r2;
  const V8 r8 = r4 * r4;
  const V8 s0 = fused(r2, all(1.0 / 120), all(-1.0 / 6));
  const V8 s4 = fused(r2, all(1.0 / 362880), all(-1.0 / 5040));
  const V8 s8 = fused(r2, all(1.0 / 6227020800.0), all(-1.0 / 39916800));
  const V8 s12 = fused(r2, all(1.0 / 355687428096000.0), all(-1.0 / 1307674368000.0));
  const V8 s = fused(r2 * r, fused(r8, fused(r4, s12, s8), fused(r4, s4, s0)), r);
  const V8 c0 = fused(r2, all(1.0 / 24), all(-0.5));
  const V8 c4 = fused(r2, all(1.0 / 40320), all(-1.0 / 720));
  const V8 c8 = fused(r2, all(1.0 / 479001600), all(-1.0 / 3628800));
  const V8 c12 = fused(r2, all(1.0 / 20922789888000.0), all(-1.0 / 87178291200.0));
  const V8 c = fused(r2, fused(r8, fused(r4, c12, c8), fused(r4, c4, c0)), all(1));
  const Bits8 quadrant = bits(shifted);
  const V8 sine = by_bit<0>(quadrant, c, s);
  const V8 cosine = by_bit<0>(quadrant, s, c);
  const V8 minus_sine = all(0) - sine;
  const V8 minus_cosine = all(0) - cosine;
  const Bits8 next = bits(shifted + all(1));
  return {by_bit<1>(quadrant, minus_sine, sine), by_bit<1>(next, minus_cosine, cosine)};
}

} // namespace
} // namespace vibroimpact::motion
