/// \file
/// Settings of the processor that a host program may have chosen before it calls the library.
#pragma once

#include <cfenv>
#include <string_view>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace soms::test {

/// The settings of this thread, flags of exceptions among them.
inline unsigned long arithmetic_settings() {
#if defined(__SSE2__)
  return _mm_getcsr();
#elif defined(__aarch64__)
  unsigned long settings = 0;
  asm volatile("mrs %0, fpcr" : "=r"(settings));
  return settings;
#else
  return static_cast<unsigned long>(std::fegetround());
#endif
}

struct HostMode {
  std::string_view name;
  int rounding = FE_TONEAREST;
  unsigned long set = 0;    ///< bits of the processor's register
  unsigned long clear = 0;  ///< likewise
};

/// Every other rounding, what flushes subnormal numbers, and exceptions that trap.
inline const std::vector<HostMode>& host_modes() {
  static const std::vector<HostMode> modes {
    {"upward", FE_UPWARD}, {"downward", FE_DOWNWARD}, {"toward_zero", FE_TOWARDZERO},
#if defined(__SSE2__)
        {"flush_to_zero", FE_TONEAREST, 0x8000}, {"denormals_are_zero", FE_TONEAREST, 0x0040},
        {"fast_math", FE_TONEAREST, 0x8040}, {"all_of_them", FE_UPWARD, 0x8040},
        {"traps", FE_TONEAREST, 0, 0x0e80},  // invalid, division by zero, overflow, underflow
#elif defined(__aarch64__)
        {"flush_to_zero", FE_TONEAREST, 1UL << 24}, {"all_of_them", FE_UPWARD, 1UL << 24},
#endif
  };
  return modes;
}

/// Puts a mode in force while it lives.
class HostArithmetic {
 public:
  explicit HostArithmetic(const HostMode& mode) : before_(arithmetic_settings()) {
    std::fesetround(mode.rounding);
    write((arithmetic_settings() | mode.set) & ~mode.clear);
  }

  ~HostArithmetic() {
    std::fesetround(FE_TONEAREST);
    write(before_);
  }

  HostArithmetic(const HostArithmetic&) = delete;
  HostArithmetic& operator=(const HostArithmetic&) = delete;

 private:
  static void write(unsigned long settings) {
#if defined(__SSE2__)
    _mm_setcsr(static_cast<unsigned>(settings));
#elif defined(__aarch64__)
    asm volatile("msr fpcr, %0" ::"r"(settings));
#else
    (void)settings;
#endif
  }

  unsigned long before_;
};

}  // namespace soms::test
