#include "motion/kernel/kernel_functions.h"

namespace vibroimpact::motion {

const Kernel kernel_avx2 = kernel_called("avx2");

} // namespace vibroimpact::motion
