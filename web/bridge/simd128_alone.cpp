// In the place of soms/query/detail/kernels/instruction_set.cpp: a browser without SIMD128 loads no
// module that has it, so there is nothing to choose from.
#include "soms/query/detail/kernels/instruction_set.h"

namespace soms::detail {

const Kernels& kernels() {
  return simd128::kernels();
}

}  // namespace soms::detail
