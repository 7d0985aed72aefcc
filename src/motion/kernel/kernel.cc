#include "motion/kernel/kernel.h"

#include "common/decompositions.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace vibroimpact::motion {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

const Kernel &chosen() {
  constexpr std::array kernels = {&kernel_avx512, &kernel_avx2, &kernel_plain};
  const char *wanted = std::getenv("VIBROIMPACT_KERNEL");
  for (const Kernel *kernel : kernels)
    if (machine_has(*kernel) && (!wanted || std::string(wanted) == kernel->name))
      return *kernel;
  throw std::runtime_error("VIBROIMPACT_KERNEL = " + std::string(wanted ? wanted : "") +
                           " is none of avx512, avx2, plain that this machine has");
}

bool strictly_upper(const double *b, int size) {
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j)
      if (b[i * size + j] != 0)
        return false;
  return true;
}

// B^size = 0: the sum over k < size of (B t)^k x / k!. Row i of B sees later entries only, so that
// each power overwrites the one before.
void turn_by_series(const double *b, int size, double time, const double *from, double *to) {
  constexpr int small = 16;
  std::array<double, small> on_stack;
  Vector elsewhere(size > small ? size : 0);
  double *const power = size > small ? elsewhere.data() : on_stack.data();
  std::copy_n(from, size, power);
  if (to != from)
    std::copy_n(from, size, to);
  for (int k = 1; k < size; ++k)
    for (int i = 0; i < size; ++i) {
      double sum = 0;
      for (int j = i + 1; j < size; ++j)
        sum += b[i * size + j] * power[j];
      power[i] = sum * (time / k);
      to[i] += power[i];
    }
}

} // namespace

bool machine_has(const Kernel &kernel) {
#if defined(__x86_64__)
  if (&kernel == &kernel_avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  if (&kernel == &kernel_avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return &kernel == &kernel_plain;
}

const Kernel &kernel() {
  static const Kernel &fastest = chosen();
  return fastest;
}

void turn_dense_block(const double *generator, int size, double time, const double *from,
                      double *to) {
  if (strictly_upper(generator, size)) {
    turn_by_series(generator, size, time, from, to);
    return;
  }
  const Eigen::Map<const RowMajor> b(generator, size, size);
  const Vector turned = exponential(time * b) * ConstVectorView(from, size);
  Eigen::Map<Eigen::VectorXd>(to, size) = turned;
}

} // namespace vibroimpact::motion
