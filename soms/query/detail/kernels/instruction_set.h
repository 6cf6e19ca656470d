/// \file
/// Which instruction set's kernels a query runs on.
#pragma once

#include "soms/query/detail/kernels/kernels.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Kernels that this build has and this processor runs, the plainest first.
[[nodiscard]] std::vector<const Kernels*> kernels_here();

/// Kernels by name, of scalar, sse4, avx2, avx512, neon and simd128.
/// \errors  ErrorKind::usage for an unknown name, unsupported for what this processor lacks.
[[nodiscard]] const Kernels& kernels_named(std::string_view name);

/// Kernels that the environment's SOMS_ISA names, else the best that the processor runs. Looked up
/// once.
/// \errors  As `kernels_named`.
[[nodiscard]] const Kernels& kernels();

namespace scalar {
[[nodiscard]] const Kernels& kernels();
}  // namespace scalar

#if defined(__x86_64__)
namespace sse4 {
[[nodiscard]] const Kernels& kernels();
}  // namespace sse4

namespace avx2 {
[[nodiscard]] const Kernels& kernels();
}  // namespace avx2

namespace avx512 {
[[nodiscard]] const Kernels& kernels();
}  // namespace avx512
#elif defined(__aarch64__)
namespace neon {
[[nodiscard]] const Kernels& kernels();
}  // namespace neon
#elif defined(__wasm_simd128__)
namespace simd128 {
[[nodiscard]] const Kernels& kernels();
}  // namespace simd128
#endif

}  // namespace soms::detail
