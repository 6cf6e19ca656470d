#include "soms/geometry/detail/exact/exact_point.h"

#include "soms/base/double_limits.h"
#include "soms/base/portable.h"
#include "soms/geometry/detail/exact/leading_part.h"
#include "soms/geometry/detail/parts/odd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::array<Feature, 6> kBorders{1, 2, 4, 3, 6, 5};

std::size_t shift(int by) {
  return static_cast<std::size_t>(by);
}

/// above / below * 2^exponent against the middle of two neighbors.
std::strong_ordering compare_middle(const Integer& above, const Integer& below, int exponent,
                                    double x, double y) {
  const Odd a(x);
  const Odd b(y);
  const int unit = std::min({a.number == 0 ? b.exponent : a.exponent,
                             b.number == 0 ? a.exponent : b.exponent, exponent + 1});
  const auto in_units = [&](const Odd& odd) {
    return odd.number == 0 ? Integer() : Integer(odd.number, shift(odd.exponent - unit));
  };
  return (above << shift(exponent + 1 - unit)) <=> (in_units(a) + in_units(b)) * below;
}

bool is_even(double x) {
  return (bit_cast<std::uint64_t>(x) & 1U) == 0;
}

IntegerVec plus(const IntegerVec& a, const IntegerVec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

}  // namespace

double nearest_double(const Integer& above, const Integer& below, int exponent) {
  if (above.sign() == 0) {
    return 0;
  }
  const LeadingPart a = leading_part(above);
  const LeadingPart b = leading_part(below);
  double x = std::ldexp((a.value / b.value).high, a.exponent - b.exponent + exponent);
  for (;;) {
    const double up = std::nextafter(x, kInfinity);
    const double down = std::nextafter(x, -kInfinity);
    const std::strong_ordering upper = compare_middle(above, below, exponent, x, up);
    if (upper > 0 || (upper == 0 && !is_even(x))) {
      x = up;
      continue;
    }
    const std::strong_ordering lower = compare_middle(above, below, exponent, down, x);
    if (lower < 0 || (lower == 0 && !is_even(x))) {
      x = down;
      continue;
    }
    return x + 0.0;
  }
}

ExactPoint::ExactPoint(const Vec3& point, const Triangle& triangle, Feature guess)
    : pair_(triangle, {point, point, point}) {
  if (is(guess)) {
    feature_ = guess;
  } else {
    const auto* const found = std::find_if(kBorders.begin(), kBorders.end(),
                                           [this](Feature border) { return is(border); });
    feature_ = found == kBorders.end() ? kFace : *found;
  }
  squared_ = measured();
}

bool ExactPoint::is(Feature feature) const {
  switch (corner_count(feature)) {
    case 1:
      return is_corner(first_corner(feature));
    case 2:
      return is_edge(feature);
    default:
      return is_inside();
  }
}

bool ExactPoint::is_corner(std::size_t i) const {
  const IntegerVec r = at(i) - point();
  return dot(r, at((i + 1) % 3) - at(i)).sign() >= 0 && dot(r, at((i + 2) % 3) - at(i)).sign() >= 0;
}

bool ExactPoint::is_edge(Feature edge) const {
  const IntegerVec& first = at(first_corner(edge));
  const IntegerVec r = first - point();
  const IntegerVec e = at(last_corner(edge)) - first;
  const Integer re = dot(r, e);
  const Integer ee = dot(e, e);
  if (re.sign() >= 0 || (re + ee).sign() <= 0) {
    return false;
  }
  const std::size_t other = first_corner(static_cast<Feature>(kFace & ~edge));
  // A corner in the edge, of a triangle without area, comes first.
  return dot(r * ee - e * re, at(other) - first).sign() >= 0 && !is_corner(other);
}

/// Surely inside the face, and on none of its edges.
bool ExactPoint::is_inside() const {
  const IntegerVec n = normal();
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(cross(at((i + 1) % 3) - at(i), point() - at(i)), n).sign() <= 0) {
      return false;
    }
  }
  return true;
}

IntegerVec ExactPoint::normal() const {
  return cross(at(1) - at(0), at(2) - at(0));
}

SquaredDistance ExactPoint::measured() const {
  const IntegerVec r = at(first_corner(feature_)) - point();
  if (corner_count(feature_) == 1) {
    return {dot(r, r), Integer(1), pair_.exponent()};
  }
  if (feature_ == kFace) {
    const IntegerVec n = normal();
    const Integer height = dot(n, r);
    return {height * height, dot(n, n), pair_.exponent()};
  }
  const IntegerVec e = at(last_corner(feature_)) - at(first_corner(feature_));
  const Integer re = dot(r, e);
  Integer ee = dot(e, e);
  return {dot(r, r) * ee - re * re, std::move(ee), pair_.exponent()};
}

Vec3 ExactPoint::nearest() const {
  const IntegerVec& first = at(first_corner(feature_));
  Integer below(1);
  IntegerVec above = first;
  if (feature_ == kFace) {
    const IntegerVec n = normal();
    below = dot(n, n);
    above = plus(point() * below, n * dot(n, first - point()));
  } else if (corner_count(feature_) == 2) {
    const IntegerVec e = at(last_corner(feature_)) - first;
    below = dot(e, e);
    above = plus(first * below, e * dot(point() - first, e));
  }
  const int exponent = pair_.exponent();
  return {nearest_double(above.x, below, exponent), nearest_double(above.y, below, exponent),
          nearest_double(above.z, below, exponent)};
}

}  // namespace soms::detail
