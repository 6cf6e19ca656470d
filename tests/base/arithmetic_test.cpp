#include "soms/base/arithmetic.h"

#include "soms/base/error.h"
#include "soms/base/pose.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <functional>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace soms {
namespace {

void expect_unsupported(const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unsupported);
  }
}

TEST(Arithmetic, AcceptsThePlainKind) {
  EXPECT_NO_THROW(check_arithmetic());
  EXPECT_NO_THROW(check(Pose{}));
}

TEST(Arithmetic, RefusesOtherRoundings) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    expect_unsupported(check_arithmetic);
    expect_unsupported([] { check(Pose{}); });
    std::fesetround(FE_TONEAREST);
  }
  EXPECT_NO_THROW(check_arithmetic());
}

#if defined(__SSE2__)
TEST(Arithmetic, RefusesFlushingToZero) {
  constexpr unsigned kFlushToZero = 0x8000;
  constexpr unsigned kDenormalsAreZero = 0x0040;
  const unsigned plain = _mm_getcsr();
  for (const unsigned bits : {kFlushToZero, kDenormalsAreZero, kFlushToZero | kDenormalsAreZero}) {
    _mm_setcsr(plain | bits);
    expect_unsupported(check_arithmetic);
    _mm_setcsr(plain);
  }
  EXPECT_NO_THROW(check_arithmetic());
}
#endif

}  // namespace
}  // namespace soms
