// exp, sin and cos for the flight kernel, two numbers at a time, the same on every machine.
//
// SLEEF's functions whose results are the same in all widths and without fused operations.
#pragma once

#include <sleef.h>

namespace vibroimpact::integration {

struct Two {
  double first, second;
};
struct TwoAngles {
  Two sine, cosine;
};

#ifdef __SSE2__

inline Two exponential(Two x) {
  const __m128d y = Sleef_cinz_expd2_u10sse2(_mm_setr_pd(x.first, x.second));
  return {_mm_cvtsd_f64(y), _mm_cvtsd_f64(_mm_unpackhi_pd(y, y))};
}

inline TwoAngles sine_cosine(Two x) {
  const Sleef___m128d_2 y = Sleef_cinz_sincosd2_u10sse2(_mm_setr_pd(x.first, x.second));
  return {{_mm_cvtsd_f64(y.x), _mm_cvtsd_f64(_mm_unpackhi_pd(y.x, y.x))},
          {_mm_cvtsd_f64(y.y), _mm_cvtsd_f64(_mm_unpackhi_pd(y.y, y.y))}};
}

#else

inline Two exponential(Two x) {
  return {Sleef_cinz_expd1_u10purec(x.first), Sleef_cinz_expd1_u10purec(x.second)};
}

inline TwoAngles sine_cosine(Two x) {
  const Sleef_double_2 first = Sleef_cinz_sincosd1_u10purec(x.first);
  const Sleef_double_2 second = Sleef_cinz_sincosd1_u10purec(x.second);
  return {{first.x, second.x}, {first.y, second.y}};
}

#endif

} // namespace vibroimpact::integration
