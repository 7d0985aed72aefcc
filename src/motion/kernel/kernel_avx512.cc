#include "motion/kernel/kernel_functions.h"

namespace vibroimpact::motion {

const Kernel kernel_avx512 = kernel_called("avx512");

} // namespace vibroimpact::motion
