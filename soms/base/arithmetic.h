/// \file
/// What the library asks of the processor, and how it gets it: plain IEEE double arithmetic.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace soms {

/// Throws unless the calling thread rounds to nearest and keeps subnormal numbers.
/// \errors ErrorKind::unsupported.
/// \cost   A few flops.
void check_arithmetic();

/// The value, calculated by now: without it a compiler may finish the calculation of what a
/// function returns after a PlainArithmetic has gone (clang does).
[[nodiscard]] inline double settled(double value) {
#if defined(__SSE2__)
  asm volatile("" : "+x"(value) : : "memory");
#elif defined(__aarch64__)
  asm volatile("" : "+w"(value) : : "memory");
#endif
  return value;
}

/// While it lives, the thread rounds to nearest, keeps subnormal numbers and traps nothing; then
/// its settings are again those that were found; where they were others, the flags of
/// floating-point exceptions, too.
/// Moved vertices, boxes and error bounds are facts about that arithmetic, and a host program may
/// have chosen another kind (`fesetround`, `feenableexcept`, flush-to-zero, which linking anything
/// with -ffast-math may switch on). Every function of the library that calculates holds one, and
/// so does each of its threads; `Pose::apply`, `midpoint`, the rules of splitting and the operators
/// of `Vec3` and `Box`, all shorter than a look at the settings, take the arithmetic that they
/// find.
/// \errors ErrorKind::unsupported where the settings are others and cannot be changed: on
///         processors other than x86 with SSE2 and 64-bit ARM; WebAssembly has no others.
/// \cost   Reading one register; 30 cycles or so more where the settings are others.
class PlainArithmetic {
 public:
#if defined(__SSE2__)
  PlainArithmetic() : found_(_mm_getcsr()) {
    if (is_other()) [[unlikely]] {
      _mm_setcsr(kPlain);
    }
  }

  ~PlainArithmetic() {
    if (is_other()) [[unlikely]] {
      _mm_setcsr(found_);
    }
  }
#elif defined(__aarch64__)
  PlainArithmetic() {
    asm volatile("mrs %0, fpcr" : "=r"(found_)::"memory");
    if (is_other()) [[unlikely]] {
      asm volatile("msr fpcr, %0" ::"r"(kPlain) : "memory");
    }
  }

  ~PlainArithmetic() {
    if (is_other()) [[unlikely]] {
      asm volatile("msr fpcr, %0" ::"r"(found_) : "memory");
    }
  }
#elif defined(__wasm__)
  PlainArithmetic() {
  }  // there is no other

  ~PlainArithmetic() {
  }
#else
  PlainArithmetic() {
    check_arithmetic();
  }
#endif

  PlainArithmetic(const PlainArithmetic&) = delete;
  PlainArithmetic& operator=(const PlainArithmetic&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr unsigned kPlain = 0x1f80;  ///< every exception masked, nothing else set
  static constexpr unsigned kFlags = 0x003f;

  [[nodiscard]] bool is_other() const {
    return (found_ & ~kFlags) != kPlain;
  }

  unsigned found_;
#elif defined(__aarch64__)
  static constexpr unsigned long kPlain = 0;

  [[nodiscard]] bool is_other() const {
    return found_ != kPlain;
  }

  unsigned long found_ = 0;
#endif
};

}  // namespace soms
