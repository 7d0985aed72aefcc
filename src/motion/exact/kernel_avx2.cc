#include "motion/exact/kernel_walk.h"

namespace vibroimpact::motion {

namespace {

WalkEnd advance(const PhaseView &phase, Walk &walk, double limit) {
  return Walker(phase, walk).advance(limit);
}

void exponential_of(const double *x, double *result) { store(result, exponential(load(x))); }

void sine_cosine_of(const double *x, double *sines, double *cosines) {
  const SineCosine8 of = sine_cosine(load(x));
  store(sines, of.sine);
  store(cosines, of.cosine);
}

} // namespace

const Kernel kernel_avx2 = {"avx2", advance,   turn,           derivatives,
                            change, integrate, exponential_of, sine_cosine_of};

} // namespace vibroimpact::motion
