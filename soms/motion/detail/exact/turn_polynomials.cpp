#include "soms/motion/detail/exact/turn_polynomials.h"

#include "soms/geometry/detail/exact/grid.h"

#include <algorithm>
#include <utility>

namespace soms::detail {

namespace {

IntegerPolynomial linear(Integer constant, Integer slope) {
  std::vector<Integer> coefficients;
  coefficients.push_back(std::move(constant));
  coefficients.push_back(std::move(slope));
  return IntegerPolynomial(std::move(coefficients));
}

IntegerVec places_of(const Vec3& v, int unit) {
  std::array<Odd, 3> odds;
  put_odds(v, odds.data());
  return on_grid(odds.data(), unit);
}

}  // namespace

TurnPolynomials::TurnPolynomials(const RigidMotion& motion, double from, double until, int unit)
    : pivot_(places_of(motion.pivot(), unit)) {
  const std::array<Odd, 2> times{Odd(from), Odd(until)};
  const int time_unit = std::min(unit_of(times), 0);
  halvings_ = static_cast<std::size_t>(-time_unit);
  const Integer begin = on_grid(times[0], time_unit);
  const Integer length = on_grid(times[1], time_unit) - begin;
  // 2^k (a + t d), by t = (begin + s length) / 2^k.
  const auto between = [&](const Integer& a, const Integer& d) {
    return linear((a << halvings_) + begin * d, length * d);
  };
  std::array<Odd, 8> odds;
  for (std::size_t i = 0; i < 4; ++i) {
    odds[i] = Odd(motion.from()[i]);
    odds[4 + i] = Odd(motion.to()[i]);
  }
  const int turn_unit = unit_of(odds);
  std::array<IntegerPolynomial, 4> q;
  for (std::size_t i = 0; i < 4; ++i) {
    const Integer start = on_grid(odds[i], turn_unit);
    q[i] = between(start, on_grid(odds[4 + i], turn_unit) - start);
  }
  const auto& [w, x, y, z] = q;
  const IntegerPolynomial ww = w * w;
  const IntegerPolynomial xx = x * x;
  const IntegerPolynomial yy = y * y;
  const IntegerPolynomial zz = z * z;
  const auto twice_sum = [](const IntegerPolynomial& a, const IntegerPolynomial& b) {
    return (a + b) * Integer(2);
  };
  const auto twice_difference = [](const IntegerPolynomial& a, const IntegerPolynomial& b) {
    return (a - b) * Integer(2);
  };
  matrix_[0] = {(ww + xx) - (yy + zz), twice_difference(x * y, w * z), twice_sum(x * z, w * y)};
  matrix_[1] = {twice_sum(x * y, w * z), (ww + yy) - (xx + zz), twice_difference(y * z, w * x)};
  matrix_[2] = {twice_difference(x * z, w * y), twice_sum(y * z, w * x), (ww + zz) - (xx + yy)};
  length_ = (ww + xx) + (yy + zz);
  squared_ = length_ * Integer(1, halvings_);
  const IntegerVec start = places_of(motion.pivot_from(), unit);
  const IntegerVec step = places_of(motion.pivot_to(), unit) - start;
  center_ = {between(start.x, step.x), between(start.y, step.y), between(start.z, step.z)};
}

PolynomialVec TurnPolynomials::moved(const IntegerVec& point) const {
  const PolynomialVec arm = turned((point - pivot_) * Integer(1, halvings_));
  return {length_ * center_[0] + arm[0], length_ * center_[1] + arm[1],
          length_ * center_[2] + arm[2]};
}

PolynomialVec TurnPolynomials::seen(const IntegerVec& point) const {
  PolynomialVec place = pivot_ * squared_;
  const PolynomialVec arm =
      (point * Integer(1, halvings_)) * IntegerPolynomial({Integer(1)}) - center_;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      place[i] = place[i] + matrix_[j][i] * arm[j];
    }
  }
  return place;
}

PolynomialVec TurnPolynomials::turned(const IntegerVec& direction) const {
  return {dot(matrix_[0], direction), dot(matrix_[1], direction), dot(matrix_[2], direction)};
}

PolynomialVec TurnPolynomials::turned_back(const IntegerVec& direction) const {
  PolynomialVec back;
  for (std::size_t i = 0; i < 3; ++i) {
    back[i] = dot(PolynomialVec{matrix_[0][i], matrix_[1][i], matrix_[2][i]}, direction);
  }
  return back;
}

StretchTime stretch_time(double from, double until, double t) {
  const std::array<Odd, 3> times{Odd(from), Odd(until), Odd(t)};
  const int unit = unit_of(times);
  const Integer begin = on_grid(times[0], unit);
  return {on_grid(times[2], unit) - begin, on_grid(times[1], unit) - begin};
}

}  // namespace soms::detail
