#include "motion/kernel/kernel.h"

#include "common/decompositions.h"

#include <Eigen/Core>

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

void dense_exponential(const double *generator, int size, double time, double *result) {
  const Eigen::Map<const RowMajor> b(generator, size, size);
  Eigen::Map<RowMajor>(result, size, size) = exponential(time * b);
}

void turn_large_block(const double *generator, int size, double time, const double *from,
                      double *to) {
  const Eigen::Map<const RowMajor> b(generator, size, size);
  const Vector turned = exponential(time * b) * ConstVectorView(from, size);
  Eigen::Map<Eigen::VectorXd>(to, size) = turned;
}

} // namespace vibroimpact::motion
