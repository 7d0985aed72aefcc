#include "motion/kernel/kernel_functions.h"

namespace vibroimpact::motion {

const Kernel kernel_plain = kernel_called("plain");

} // namespace vibroimpact::motion
