#include "soms/query/detail/winding/angle_sum.h"

#include <algorithm>

namespace soms::detail {

namespace {

constexpr double kTangentOfEighth = 0x1.a827999fcef32p-2;  // of pi / 8
constexpr double kTurnsOfRadian = 0x1.45f306dc9c883p-3;    // 1 / (2 pi)
constexpr int kLastPower = 45;

/// Gregory's series. \pre |s| <= tan(pi / 8)
double arctangent(double s) {
  const double square = s * s;
  double sum = 1.0 / kLastPower;
  for (int power = kLastPower - 2; power > 0; power -= 2) {
    sum = 1.0 / power - square * sum;
  }
  return s * sum;
}

}  // namespace

double argument_in_turns(double re, double im) {
  const double x = std::abs(re);
  const double y = std::abs(im);
  const double large = std::max(x, y);
  const double small = std::min(x, y);
  double turns = small <= kTangentOfEighth * large
                     ? arctangent(small / large) * kTurnsOfRadian
                     : 0.125 + arctangent((small - large) / (small + large)) * kTurnsOfRadian;
  turns = y > x ? 0.25 - turns : turns;
  turns = std::signbit(re) && x > 0 ? 0.5 - turns : turns;
  return std::signbit(im) ? -turns : turns;
}

}  // namespace soms::detail
