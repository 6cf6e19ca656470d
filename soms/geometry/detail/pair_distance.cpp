#include "soms/geometry/detail/pair_distance.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/geometry/detail/axis_gap.h"
#include "soms/geometry/detail/feature_proof.h"
#include "soms/geometry/detail/nearest_guess.h"
#include "soms/geometry/detail/nearest_points.h"
#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

/// x * 2^exponent, and not above it.
DoubleDouble scaled_down(const DoubleDouble& x, int exponent) {
  if (exponent == 0) {
    return x;
  }
  const double least = std::max(below(x), 0.0);
  const double scaled = std::ldexp(least, exponent);
  return std::ldexp(scaled, -exponent) > least ? std::nextafter(scaled, 0.0) : scaled;
}

DoubleDouble scaled_up(const DoubleDouble& x, int exponent) {
  if (exponent == 0) {
    return x;
  }
  const double most = above(x);
  const double scaled = std::ldexp(most, exponent);
  return std::ldexp(scaled, -exponent) < most ? std::nextafter(scaled, kInfinity) : scaled;
}

}  // namespace

PairDistance::PairDistance(const Triangle& a, const Triangle& b)
    : a_(a), b_(b), stage_(Stage::doubles) {
  const PlainArithmetic plain;
  const AboutCorner<double> place(a, b);
  if (place.reach == 0) {
    settle_zero();
    return;
  }
  features_ = guess_features(place);
  upper_ = kInfinity;
  take(place, ends(place, features_));
}

template <class T>
void PairDistance::take(const AboutCorner<T>& place, const Ends<T>& found) {
  const DoubleDouble lower = scaled_down(found.lower, place.exponent);
  const DoubleDouble upper = scaled_up(found.upper, place.exponent);
  lower_ = std::max(lower_, lower);
  upper_ = std::min(upper_, upper);
}

Bracket PairDistance::bounds() const {
  return {below(lower_), above(upper_)};
}

void PairDistance::settle_zero() {
  stage_ = Stage::exact;
  lower_ = 0;
  upper_ = 0;
}

void PairDistance::refine() {
  if (stage_ == Stage::exact) {
    return;
  }
  if (stage_ == Stage::double_doubles) {
    decide();
    return;
  }
  if (!(lower_ > 0) && triangles_overlap(a_, b_, &exact_tests_)) {
    settle_zero();
    return;
  }
  stage_ = Stage::double_doubles;
  if (const std::optional<DoubleDouble> gap = axis_gap(a_, b_, lower_, upper_)) {
    lower_ = *gap;
    upper_ = *gap;
    return;
  }
  const AboutCorner<DoubleDouble> place(a_, b_);
  const Ends<DoubleDouble> found = ends(place, features_);
  take(place, found);
  points_ = found.points;
  exponent_ = place.exponent;
  has_points_ = true;
}

void PairDistance::decide() {
  ++exact_tests_;
  const ExactPair pair(a_, b_);
  exact_ = std::make_shared<const ExactDistance>(exact_distance(pair, features_));
  features_ = exact_->features;
  stage_ = Stage::exact;
}

std::strong_ordering PairDistance::compare_exactly(const PairDistance& other) const {
  if (is_zero() || other.is_zero()) {
    return other.is_zero() <=> is_zero();
  }
  return detail::compare(exact_->squared, other.exact_->squared);
}

/// A distance of 0 is a number, and never gets here.
std::strong_ordering PairDistance::compare_exactly(double distance) const {
  return detail::compare(exact_->squared, distance);
}

std::strong_ordering PairDistance::compare(PairDistance& other) {
  return RefinedOrder<PairDistance>::compare(*this, other);
}

std::strong_ordering PairDistance::compare(double distance) {
  return RefinedOrder<PairDistance>::compare(*this, distance);
}

Bracket PairDistance::distance() {
  const PlainArithmetic plain;
  for (;;) {
    if (below(lower_) == below(upper_) && above(lower_) == above(upper_)) {
      return bounds();
    }
    if (stage_ == Stage::exact) {
      break;
    }
    refine();
  }
  const Bracket found = bracket(exact_->squared);
  lower_ = found.lower;
  upper_ = found.upper;
  return found;
}

bool PairDistance::are_alike(const PairDistance& other) const {
  const bool same_a = same_corners(a_, features_[0], other.a_, other.features_[0]);
  const bool same_b = same_corners(b_, features_[1], other.b_, other.features_[1]);
  if (same_a && same_b) {
    return true;
  }
  const std::size_t face_of = same_a ? 0 : 1;
  const std::size_t corner_of = 1 - face_of;
  if (!(same_a || same_b) || features_[face_of] != kFace ||
      corner_count(features_[corner_of]) != 1 || corner_count(other.features_[corner_of]) != 1) {
    return false;
  }
  const Triangle& face = face_of == 0 ? a_ : b_;
  const Vec3& tip = corner(face_of == 0 ? b_ : a_, first_corner(features_[corner_of]));
  const Vec3& other_tip =
      corner(face_of == 0 ? other.b_ : other.a_, first_corner(other.features_[corner_of]));
  return surely_coplanar(face.b - face.a, face.c - face.a, other_tip - tip);
}

bool PairDistance::has_features_of(const PairDistance& other) const {
  if (is_zero() || other.is_zero() || !are_alike(other)) {
    return false;
  }
  const auto are_nearest = [](const PairDistance& pair) {
    return pair.exact_ != nullptr || prove(pair.a_, pair.b_, pair.features_).nearest;
  };
  return are_nearest(*this) && are_nearest(other);
}

std::array<Vec3, 2> PairDistance::points() const {
  const PlainArithmetic plain;
  if (stage_ == Stage::double_doubles && has_points_ && prove(a_, b_, features_).steady) {
    return in_world(points_, exponent_, a_);
  }
  return nearest_points(a_, b_);
}

}  // namespace soms::detail
