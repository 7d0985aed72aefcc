// The functions of a kernel, for one kind of machine; included by the kernel_*.cc only.
#pragma once

#include "motion/kernel/kernel_march.h"
#include "motion/kernel/kernel_outputs.h"

namespace vibroimpact::motion {
namespace {

inline MarchEnd advance(const PhaseView &phase, MarchState &walk, double limit) {
  return March(phase, walk).advance(limit);
}

inline void exponential_of(const double *x, double *result) { store(result, exponential(load(x))); }

inline void sine_cosine_of(const double *x, double *sines, double *cosines) {
  const SineCosine8 of = sine_cosine(load(x));
  store(sines, of.sine);
  store(cosines, of.cosine);
}

constexpr Kernel kernel_called(const char *name) {
  return {.name = name,
          .advance = advance,
          .turn = turn,
          .include_part = include_part,
          .derivatives = derivatives,
          .guard_margin = guard_margin,
          .form_noise = form_noise,
          .change = change,
          .integrate = integrate,
          .exponential = exponential_of,
          .sine_cosine = sine_cosine_of};
}

} // namespace
} // namespace vibroimpact::motion
