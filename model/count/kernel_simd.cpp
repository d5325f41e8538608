#include "model/count/kernel.h"

namespace wedgesim::model {

const Kernel& simd_kernel() { return kScalarKernel; }

}  // namespace wedgesim::model
