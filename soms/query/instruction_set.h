/// \file
/// Which instruction set queries run on. Answers and costs are the same on all.
#pragma once

#include <string_view>
#include <vector>

namespace soms {

/// Instruction sets that this build has and this processor runs, the plainest first: of scalar,
/// sse4, avx2, avx512, neon and simd128 (WebAssembly).
[[nodiscard]] std::vector<std::string_view> instruction_sets();

/// The one that queries run on: the one that the environment's SOMS_ISA names, else the best.
/// \errors  ErrorKind::usage where SOMS_ISA names none, unsupported where this processor lacks it;
/// queries throw the same.
[[nodiscard]] std::string_view instruction_set();

}  // namespace soms
