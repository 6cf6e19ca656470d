#include "soms/geometry/detail/exact/exact_ray.h"

#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/exact/grid.h"
#include "soms/geometry/detail/exact/leading_part.h"

#include <cmath>
#include <utility>

namespace soms::detail {

namespace {

constexpr double kEndlessRay = std::numeric_limits<double>::infinity();

/// log2 of a number above 0, off by less than 1 either way.
long magnitude(const RayTime& t) {
  return static_cast<long>(t.above.bit_length()) - static_cast<long>(t.below.bit_length()) +
         t.exponent;
}

/// Off by a few units in the last place; 0 or infinity beyond doubles. \pre It is above 0.
double approximate(const RayTime& t) {
  const LeadingPart above = leading_part(t.above);
  const LeadingPart below = leading_part(t.below);
  return std::ldexp((above.value / below.value).high, above.exponent - below.exponent + t.exponent);
}

}  // namespace

std::strong_ordering compare(const RayTime& a, const RayTime& b) {
  if (a.above.sign() != b.above.sign() || a.above.sign() == 0) {
    return a.above.sign() <=> b.above.sign();
  }
  if (a.above.sign() > 0) {
    const long difference = magnitude(a) - magnitude(b);
    if (difference > 2 || difference < -2) {
      return difference <=> 0L;
    }
  }
  const Integer left = a.above * b.below;
  const Integer right = b.above * a.below;
  return a.exponent >= b.exponent
             ? (left << static_cast<std::size_t>(a.exponent - b.exponent)) <=> right
             : left <=> (right << static_cast<std::size_t>(b.exponent - a.exponent));
}

std::strong_ordering compare(const RayTime& a, double t) {
  if (std::isinf(t)) {
    return t < 0 ? std::strong_ordering::greater : std::strong_ordering::less;
  }
  const Odd odd(t);
  return compare(a, {Integer(odd.number), Integer(1), odd.exponent});
}

Bracket bracket(const RayTime& time) {
  if (time.above.sign() == 0) {
    return {0, 0};
  }
  double lower = approximate(time);
  while (compare(time, lower) < 0) {
    lower = std::nextafter(lower, 0.0);
  }
  for (double upper = lower;; upper = std::nextafter(upper, kEndlessRay)) {
    const std::strong_ordering order = compare(time, upper);
    if (order <= 0) {
      return {order == 0 ? upper : lower, upper};
    }
    lower = upper;
  }
}

ExactRay::ExactRay(const RayLine& line, const Triangle& triangle) {
  std::array<Odd, 15> places;  // corners, the origin, a segment's end
  std::array<Odd, 3> directions;
  put_odds(triangle.a, places.data());
  put_odds(triangle.b, &places[3]);
  put_odds(triangle.c, &places[6]);
  put_odds(line.origin, &places[9]);
  if (line.segment) {
    put_odds(line.ahead, &places[12]);
  } else {
    put_odds(line.ahead, directions.data());
  }
  place_unit_ = unit_of(places);
  origin_ = on_grid(&places[9], place_unit_);
  for (std::size_t i = 0; i < 3; ++i) {
    corner_[i] = on_grid(&places[3 * i], place_unit_) - origin_;
  }
  direction_unit_ = line.segment ? place_unit_ : unit_of(directions);
  direction_ = line.segment ? on_grid(&places[12], place_unit_) - origin_
                            : on_grid(directions.data(), direction_unit_);
  meet(line.length);
}

ExactRay::ExactRay(const std::array<IntegerVec, 3>& corners, int place_unit,
                   const IntegerVec& direction, int direction_unit, double length)
    : corner_(corners),
      direction_(direction),
      place_unit_(place_unit),
      direction_unit_(direction_unit) {
  meet(length);
}

void ExactRay::meet(double length) {
  for (std::size_t i = 0; i < 3; ++i) {
    volume_[i] = dot(direction_, cross(corner_[i], corner_[(i + 1) % 3]));
  }
  const Integer steep = (volume_[0] + volume_[1]) + volume_[2];  // of direction and normal
  steepness_ = steep.sign();
  const auto any = [this](int sign) {
    return volume_[0].sign() == sign || volume_[1].sign() == sign || volume_[2].sign() == sign;
  };
  if (any(1) && any(-1)) {
    return;
  }
  const IntegerVec normal = cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
  if (steepness_ == 0) {
    meet_within(normal, length);
    return;
  }
  const Integer height = dot(normal, corner_[0]);
  time_ = steepness_ > 0 ? time_of(height, steep) : time_of(-height, -steep);
  hit_ = time_.above.sign() >= 0 && compare(time_, length) <= 0;
}

RayTime ExactRay::time_of(Integer above, Integer below) const {
  return {std::move(above), std::move(below), place_unit_ - direction_unit_};
}

IntegerVec ExactRay::edge(std::size_t i) const {
  return corner_[(i + 1) % 3] - corner_[i];
}

/// The line lies in the plane of the triangle, or in a plane with its edges if it has no area; or
/// the direction is zero, of a segment that is a point.
void ExactRay::meet_within(const IntegerVec& normal, double length) {
  const Integer square = dot(direction_, direction_);
  if (square.sign() == 0) {
    meet_point(normal);
    return;
  }
  IntegerVec across = cross(direction_, normal);  // in the plane, across the line
  for (std::size_t i = 0; i < 3 && is_zero(across); ++i) {
    const IntegerVec e = edge(i);
    across = e * square - direction_ * dot(direction_, e);
  }
  // Where all edges are along the line, so is the triangle, or it is beside it.
  const bool along = is_zero(across);
  std::array<Integer, 3> beside;
  for (std::size_t i = 0; i < 3; ++i) {
    beside[i] = dot(across, corner_[i]);
    if (along && !is_zero(cross(direction_, corner_[i]))) {
      return;
    }
  }
  bool found = false;
  std::array<RayTime, 2> ends;
  const auto add = [&](RayTime t) {
    if (!found || compare(t, ends[0]) < 0) {
      ends[0] = t;
    }
    if (!found || compare(t, ends[1]) > 0) {
      ends[1] = std::move(t);
    }
    found = true;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (beside[i].sign() == 0) {
      add(time_of(dot(corner_[i], direction_), square));
    } else if (beside[i].sign() == -beside[j].sign()) {
      const Integer whole = beside[j] - beside[i];
      const IntegerVec place = corner_[i] * beside[j] - corner_[j] * beside[i];
      const Integer above = dot(place, direction_);
      add(whole.sign() > 0 ? time_of(above, whole * square) : time_of(-above, -whole * square));
    }
  }
  if (found && ends[1].above.sign() >= 0 && compare(ends[0], length) <= 0) {
    hit_ = true;
    time_ = ends[0].above.sign() < 0 ? RayTime{} : ends[0];
  }
}

/// A point is in a triangle with area if it is in its plane and not beyond an edge; in one without
/// area if it is in one of its edges.
void ExactRay::meet_point(const IntegerVec& normal) {
  if (is_zero(normal)) {
    hit_ = is_at(0) || is_at(1) || is_at(2) || is_within(0) || is_within(1) || is_within(2);
    return;
  }
  hit_ = dot(normal, corner_[0]).sign() == 0;
  for (std::size_t i = 0; i < 3 && hit_; ++i) {
    hit_ = dot(normal, cross(corner_[i], corner_[(i + 1) % 3])).sign() >= 0;
  }
}

/// The point is the corner.
bool ExactRay::is_at(std::size_t i) const {
  return is_zero(corner_[i] * time_.below - direction_ * time_.above);
}

/// The point is between the ends of an edge.
bool ExactRay::is_within(std::size_t i) const {
  const IntegerVec point = direction_ * time_.above;
  const IntegerVec from = corner_[i] * time_.below - point;
  const IntegerVec to = corner_[(i + 1) % 3] * time_.below - point;
  return is_zero(cross(from, to)) && dot(from, to).sign() < 0;
}

std::array<Feature, 3> ExactRay::features() const {
  std::array<Feature, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_at(i)) {
      found[0] = static_cast<Feature>(1U << i);
      return found;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_within(i)) {
      found[count++] = static_cast<Feature>(1U << i | 1U << (i + 1) % 3);
    }
  }
  if (count == 0) {
    found[0] = kFace;
  }
  return found;
}

Vec3 ExactRay::point() const {
  const IntegerVec way = direction_ * time_.above;
  const auto rounded = [&](const Integer& from, const Integer& along) {
    return nearest_double(from * time_.below + along, time_.below, place_unit_);
  };
  return {rounded(origin_.x, way.x), rounded(origin_.y, way.y), rounded(origin_.z, way.z)};
}

bool ExactRay::crossed_beside() const {
  if (steepness_ == 0) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    int sign = volume_[i].sign();
    if (sign == 0) {
      const IntegerVec turn = cross(direction_, edge(i));
      sign = turn.x.sign() != 0   ? turn.x.sign()
             : turn.y.sign() != 0 ? turn.y.sign()
                                  : turn.z.sign();
    }
    if (sign != steepness_) {
      return false;
    }
  }
  return true;
}

}  // namespace soms::detail
