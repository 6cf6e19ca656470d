#include "soms/base/arithmetic.h"

#include "soms/base/error.h"

#include <limits>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace soms {

namespace {

/// A number that the compiler may not calculate with beforehand.
double at_run_time(double x) {
  volatile double value = x;
  return value;
}

/// Both sums are ties, which other roundings than to nearest, ties to even, take elsewhere.
bool rounds_to_nearest() {
  const double one = at_run_time(1);
  return at_run_time(one + at_run_time(0x1p-53)) == 1 &&
         at_run_time(one - at_run_time(0x1p-54)) == 1;
}

bool keeps_subnormal_numbers() {
  const double least = at_run_time(std::numeric_limits<double>::denorm_min());
  const double half = at_run_time(0.5) * at_run_time(std::numeric_limits<double>::min());
  return at_run_time(least + least) != 0 && at_run_time(half) != 0;
}

}  // namespace

void check_arithmetic() {
#if defined(__SSE2__)
  // Rounding control, flush-to-zero, denormals-are-zero: a quick look before the slow one.
  constexpr unsigned kSettings = 0xe040;
  if ((_mm_getcsr() & kSettings) == 0) {
    return;
  }
#endif
  if (!rounds_to_nearest()) {
    throw Error(ErrorKind::unsupported, "this thread does not round to nearest",
                "call fesetround(FE_TONEAREST) first");
  }
  if (!keeps_subnormal_numbers()) {
    throw Error(ErrorKind::unsupported, "this thread flushes subnormal numbers to zero",
                "clear flush-to-zero and denormals-are-zero, which -ffast-math sets");
  }
}

}  // namespace soms
