/// \file
/// The law of a turning motion in whole numbers.
#pragma once

#include "soms/motion/detail/exact/integer_polynomial.h"
#include "soms/motion/rigid_motion.h"

#include <array>
#include <cstddef>

namespace soms::detail {

/// Over a stretch of the way, from `from` to `until`, as polynomials in s from 0 to 1, where
/// t = from + s (until - from). The law (motion_bounds.h) is x = w + R(q) (a - c), with w and q
/// linear in s. M(q) = |q|^2 R(q) is a matrix of polynomials of degree 2. So
///   |q|^2 x = |q|^2 w + M (a - c), and a = c + M^T (x - w) / |q|^2
/// backwards, are of degree 3. Here q and w are 2^k times theirs, which makes all coefficients
/// whole, and places are `squared()` times theirs. |q|^2 is above 0 for 0 <= t <= 1, as q0 and q1
/// are no more than a right angle apart.
class TurnPolynomials {
 public:
  /// `unit`: places are whole multiples of 2^unit. \pre The motion is not straight,
  /// 0 <= from <= until <= 1.
  TurnPolynomials(const RigidMotion& motion, double from, double until, int unit);

  /// 2^k |q|^2, what places are multiplied by. Directions are multiplied by |q|^2 alone.
  [[nodiscard]] const IntegerPolynomial& squared() const { return squared_; }

  /// k
  [[nodiscard]] std::size_t halvings() const { return halvings_; }

  /// A point of the body, in world.
  [[nodiscard]] PolynomialVec moved(const IntegerVec& point) const;

  /// A point of the world, in coordinates of the body.
  [[nodiscard]] PolynomialVec seen(const IntegerVec& point) const;

  /// A direction of the body, in world.
  [[nodiscard]] PolynomialVec turned(const IntegerVec& direction) const;

  /// A direction of the world, in coordinates of the body.
  [[nodiscard]] PolynomialVec turned_back(const IntegerVec& direction) const;

 private:
  std::size_t halvings_ = 0;
  IntegerPolynomial squared_;
  IntegerPolynomial length_;             ///< |q|^2
  std::array<PolynomialVec, 3> matrix_;  ///< rows of M
  PolynomialVec center_;                 ///< w
  IntegerVec pivot_;                     ///< c
};

/// above / below
struct StretchTime {
  Integer above;
  Integer below;
};

/// How t stands in a stretch: s = (t - from) / (until - from). Both numbers are 0 where the stretch
/// has no length and t is in it. \pre from <= t
[[nodiscard]] StretchTime stretch_time(double from, double until, double t);

}  // namespace soms::detail
