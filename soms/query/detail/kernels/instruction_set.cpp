#include "soms/query/detail/kernels/instruction_set.h"

#include "soms/base/error.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace soms::detail {

namespace {

constexpr std::array<std::string_view, 6> kNames{"scalar", "sse4", "avx2",
                                                 "avx512", "neon", "simd128"};

}  // namespace

std::vector<const Kernels*> kernels_here() {
  std::vector<const Kernels*> here{&scalar::kernels()};
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("sse4.1") && __builtin_cpu_supports("popcnt")) {
    here.push_back(&sse4::kernels());
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi")) {
    here.push_back(&avx2::kernels());
  }
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("bmi2")) {
    here.push_back(&avx512::kernels());
  }
#elif defined(__aarch64__)
  here.push_back(&neon::kernels());
#elif defined(__wasm_simd128__)
  here.push_back(&simd128::kernels());
#endif
  return here;
}

const Kernels& kernels_named(std::string_view name) {
  std::string offered;
  for (const Kernels* kernels : kernels_here()) {
    if (kernels->name == name) {
      return *kernels;
    }
    offered += (offered.empty() ? "" : ", ") + std::string(kernels->name);
  }
  const bool known = std::find(kNames.begin(), kNames.end(), name) != kNames.end();
  throw Error(known ? ErrorKind::unsupported : ErrorKind::usage,
              "SOMS_ISA: " + std::string(name) +
                  (known ? " is not supported by this processor" : " is not an instruction set"),
              "use one of " + offered + ", or unset it");
}

const Kernels& kernels() {
  static const Kernels& chosen = []() -> const Kernels& {
    const char* const name = std::getenv("SOMS_ISA");
    return name != nullptr && *name != '\0' ? kernels_named(name) : *kernels_here().back();
  }();
  return chosen;
}

}  // namespace soms::detail
