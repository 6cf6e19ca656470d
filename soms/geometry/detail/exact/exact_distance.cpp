#include "soms/geometry/detail/exact/exact_distance.h"

#include "soms/base/assert.h"
#include "soms/base/double_limits.h"
#include "soms/geometry/detail/exact/leading_part.h"
#include "soms/geometry/detail/parts/odd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

/// log2 of the number, off by less than 1 either way.
long magnitude(const SquaredDistance& s) {
  return static_cast<long>(s.numerator.bit_length()) -
         static_cast<long>(s.denominator.bit_length()) + 2L * s.exponent;
}

/// a * 2^a_shift against b * 2^b_shift.
std::strong_ordering compare_shifted(const Integer& a, long a_shift, const Integer& b,
                                     long b_shift) {
  if (a_shift == b_shift) {
    return a <=> b;
  }
  return a_shift > b_shift ? (a << static_cast<std::size_t>(a_shift - b_shift)) <=> b
                           : a <=> (b << static_cast<std::size_t>(b_shift - a_shift));
}

/// Off by a few units in the last place at most. \pre It is above 0.
double approximate_distance(const SquaredDistance& squared) {
  const LeadingPart above = leading_part(squared.numerator);
  const LeadingPart below = leading_part(squared.denominator);
  // The exponent is made even, so that half of it is whole.
  const int exponent = above.exponent - below.exponent + 2 * squared.exponent;
  const int odd = exponent & 1;
  const double root = std::sqrt((above.value / below.value).high * (odd != 0 ? 2.0 : 1.0));
  return std::ldexp(root, (exponent - odd) / 2);
}

bool in_unit(const Integer& part, const Integer& whole) {
  return part.sign() >= 0 && part <= whole;
}

}  // namespace

std::strong_ordering compare(const SquaredDistance& a, const SquaredDistance& b) {
  if (a.numerator.sign() == 0 || b.numerator.sign() == 0) {
    return a.numerator.sign() <=> b.numerator.sign();
  }
  const long difference = magnitude(a) - magnitude(b);
  if (difference > 2 || difference < -2) {
    return difference <=> 0L;
  }
  return compare_shifted(a.numerator * b.denominator, 2L * a.exponent, b.numerator * a.denominator,
                         2L * b.exponent);
}

std::strong_ordering compare(const SquaredDistance& a, double distance) {
  if (distance == 0 || a.numerator.sign() == 0) {
    return a.numerator.sign() <=> (distance == 0 ? 0 : 1);
  }
  if (std::isinf(distance)) {
    return std::strong_ordering::less;
  }
  const Odd odd(distance);
  const Integer number(odd.number);
  return compare(a, SquaredDistance{number * number, Integer(1), odd.exponent});
}

Bracket bracket(const SquaredDistance& squared) {
  if (squared.numerator.sign() == 0) {
    return {0, 0};
  }
  double lower = approximate_distance(squared);
  while (compare(squared, lower) < 0) {
    lower = std::nextafter(lower, 0.0);
  }
  for (double upper = lower;; upper = std::nextafter(upper, kInfinity)) {
    const std::strong_ordering order = compare(squared, upper);
    if (order <= 0) {
      return {order == 0 ? upper : lower, upper};
    }
    lower = upper;
  }
}

bool is_zero(const IntegerVec& v) {
  return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0;
}

IntegerVec operator-(const IntegerVec& a, const IntegerVec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

IntegerVec operator*(const IntegerVec& a, const Integer& s) {
  return {a.x * s, a.y * s, a.z * s};
}

Integer dot(const IntegerVec& a, const IntegerVec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

IntegerVec cross(const IntegerVec& a, const IntegerVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

ExactPair::ExactPair(const Triangle& a, const Triangle& b) {
  const std::array<const Triangle*, 2> triangles{&a, &b};
  std::array<Odd, 18> odds;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < 18; ++i) {
    odds[i] = Odd(corner(*triangles[i / 9], i / 3 % 3)[i % 3]);
    least = odds[i].number == 0 ? least : std::min(least, odds[i].exponent);
  }
  exponent_ = least == std::numeric_limits<int>::max() ? 0 : least;
  const auto integer = [&](const Odd& odd) {
    return odd.number == 0
               ? Integer()
               : Integer(odd.number, static_cast<std::size_t>(odd.exponent - exponent_));
  };
  for (std::size_t i = 0; i < 6; ++i) {
    corners_[i] = {integer(odds[3 * i]), integer(odds[3 * i + 1]), integer(odds[3 * i + 2])};
  }
}

bool ExactPair::parts(const IntegerVec& n, const FeaturePair& features, std::size_t from,
                      bool turned) const {
  for (std::size_t t = 0; t < 2; ++t) {
    const int inward = (t == from) != turned ? -1 : 1;
    const IntegerVec& foot = at(t, first_corner(features[t]));
    for (std::size_t i = 0; i < 3; ++i) {
      if ((features[t] >> i & 1) == 0 && dot(n, at(t, i) - foot).sign() == -inward) {
        return false;
      }
    }
  }
  return true;
}

ExactPair::Found ExactPair::of_corners(const FeaturePair& features) const {
  const IntegerVec r = at(1, first_corner(features[1])) - at(0, first_corner(features[0]));
  if (!parts(r, features, 0, false)) {
    return std::nullopt;
  }
  return SquaredDistance{dot(r, r), Integer(1), exponent_};
}

ExactPair::Found ExactPair::of_corner_and_edge(const FeaturePair& features,
                                               std::size_t corner_of) const {
  const Feature edge = features[1 - corner_of];
  const IntegerVec& begin = at(1 - corner_of, first_corner(edge));
  const IntegerVec r = begin - at(corner_of, first_corner(features[corner_of]));
  const IntegerVec e = at(1 - corner_of, last_corner(edge)) - begin;
  Integer ee = dot(e, e);
  const Integer re = dot(r, e);
  if (ee.sign() == 0 || !in_unit(-re, ee) || !parts(r * ee - e * re, features, corner_of, false)) {
    return std::nullopt;
  }
  return SquaredDistance{dot(r, r) * ee - re * re, std::move(ee), exponent_};
}

ExactPair::Found ExactPair::of_corner_and_face(const FeaturePair& features,
                                               std::size_t corner_of) const {
  const std::size_t face_of = 1 - corner_of;
  const IntegerVec& tip = at(corner_of, first_corner(features[corner_of]));
  const IntegerVec r = at(face_of, 0) - tip;
  const IntegerVec n = cross(at(face_of, 1) - at(face_of, 0), at(face_of, 2) - at(face_of, 0));
  const Integer height = dot(n, r);
  if (height.sign() == 0 || !parts(n, features, corner_of, height.sign() < 0)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const IntegerVec& begin = at(face_of, i);
    if (dot(cross(at(face_of, (i + 1) % 3) - begin, tip - begin), n).sign() < 0) {
      return std::nullopt;
    }
  }
  return SquaredDistance{height * height, dot(n, n), exponent_};
}

ExactPair::Found ExactPair::of_edges(const FeaturePair& features) const {
  const IntegerVec& begin_a = at(0, first_corner(features[0]));
  const IntegerVec& begin_b = at(1, first_corner(features[1]));
  const IntegerVec e = at(0, last_corner(features[0])) - begin_a;
  const IntegerVec f = at(1, last_corner(features[1])) - begin_b;
  const IntegerVec r = begin_b - begin_a;
  const IntegerVec n = cross(e, f);
  const Integer height = dot(n, r);
  if (height.sign() == 0 || !parts(n, features, 0, height.sign() < 0)) {
    return std::nullopt;
  }
  Integer nn = dot(n, n);
  if (!in_unit(dot(cross(r, f), n), nn) || !in_unit(dot(cross(r, e), n), nn)) {
    return std::nullopt;
  }
  return SquaredDistance{height * height, std::move(nn), exponent_};
}

std::optional<SquaredDistance> ExactPair::squared_distance(const FeaturePair& features) const {
  const int a = corner_count(features[0]);
  const int b = corner_count(features[1]);
  if (a == 1 && b == 1) {
    return of_corners(features);
  }
  if (a == 2 && b == 2) {
    return of_edges(features);
  }
  const std::size_t corner_of = a == 1 ? 0 : 1;
  return a + b == 3 ? of_corner_and_edge(features, corner_of)
                    : of_corner_and_face(features, corner_of);
}

ExactDistance exact_distance(const ExactPair& pair, const FeaturePair& guess) {
  if (guess[0] != 0) {
    if (std::optional<SquaredDistance> squared = pair.squared_distance(guess)) {
      return {guess, *std::move(squared)};
    }
  }
  for (const FeaturePair& features : kFeaturePairs) {
    if (std::optional<SquaredDistance> squared = pair.squared_distance(features)) {
      return {features, *std::move(squared)};
    }
  }
  SOMS_ASSERT(false);
  return {};
}

}  // namespace soms::detail
