#include "soms/geometry/orientation.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/predicates.h"

#include <cfloat>

#if defined(__FAST_MATH__)
#error "soms decides signs by rounding bounds: compile it without -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "the bounds hold for arithmetic in double, not in extended");

namespace soms {

Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const PlainArithmetic plain;
  return detail::Predicates{}.orientation(a, b, c, d);
}

Sign orientation2d(const Vec3& a, const Vec3& b, const Vec3& c, Projection plane) {
  const PlainArithmetic plain;
  return detail::Predicates{}.orientation2d(a, b, c, plane);
}

}  // namespace soms
