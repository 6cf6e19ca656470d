#include "soms/query/detail/ray/ray_frame.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in ray_frame.h.
constexpr double kLineRounding = 128 * 0x1p-53;
constexpr double kOffsetRounding = 0x1p-95;
constexpr double kLineUnderflow = 0x1p-1064;
constexpr double kMostLineSlack = 0x1p50;
static_assert(8.02 + 8.02 + 24.1 + 14.8 + 12 + 25.7 + 4 < 128);

/// Four roundings of the place of a ray's end, relative to its terms.
constexpr double kEndRounding = 0x1p-50;

constexpr double kMostPlace = 0x1p100;

/// At most x, or at least it; what is beyond all bodies is cut.
float down(double x) {
  x = std::clamp(x, -kMostPlace, kMostPlace);
  return static_cast<float>(x - (std::abs(x) * 0x1p-22 + 0x1p-100));
}

float up(double x) {
  return -down(-x);
}

float slack_of(double x) {
  return static_cast<float>((x + 0x1p-100) * (1 + 0x1p-22));
}

}  // namespace

RayFrame::RayFrame(const WideTree& tree, const Pose& pose)
    : rotation_(rotation(pose)),
      origin_(pose.apply(tree.origin())),
      scale_(tree.scale()),
      rounding_(kLineRounding * moved_extent(pose, tree.bounds()) + kLineUnderflow) {
  const Vec3 half = tree.bounds().extent() * 0.5;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& r = rotation_[k];
    half_[k] =
        ((std::abs(r[0]) * half.x + std::abs(r[1]) * half.y) + std::abs(r[2]) * half.z) + rounding_;
  }
}

bool RayFrame::start(const RayLine& line, const ScaledDirection& direction,
                     RayCourse& course) const {
  const Vec3& d = direction.high;
  std::size_t k = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    k = std::abs(d[axis]) > std::abs(d[k]) ? axis : k;
  }
  const Vec3& o = line.origin;
  const DoubleDouble ahead = two_sum(origin_[k], -o[k]);
  LineNumbers& numbers = course.numbers;
  double offset = std::abs(ahead.high);
  std::array<double, 2> shadow;
  for (std::size_t i = 1; i < 3; ++i) {
    const std::size_t axis = (k + i) % 3;
    const DoubleDouble to = two_sum(origin_[axis], -o[axis]);
    const DoubleDouble slope =
        d[axis] == 0 ? DoubleDouble() : direction.part[axis] / direction.part[k];
    numbers.from[i] = (to - slope * ahead).high;
    offset = std::max(offset, std::abs(to.high));
    shadow[i - 1] = half_[axis] + std::abs(slope.high) * half_[k];
    for (std::size_t j = 0; j < 3; ++j) {
      numbers.exact[i][j] = rotation_[axis][j] - slope.high * rotation_[k][j];
      numbers.row[i][j] = static_cast<float>(numbers.exact[i][j]);
    }
  }
  const double rounding = rounding_ + offset * kOffsetRounding;
  if (std::abs(numbers.from[1]) > shadow[0] + rounding ||
      std::abs(numbers.from[2]) > shadow[1] + rounding) {
    return false;
  }
  const bool backward = d[k] < 0;
  for (std::size_t j = 0; j < 3; ++j) {
    numbers.exact[0][j] = backward ? -rotation_[k][j] : rotation_[k][j];
    numbers.row[0][j] = static_cast<float>(numbers.exact[0][j]);
  }
  const double slack = rounding * scale_;
  numbers.scale = slack > kMostLineSlack ? 0 : scale_;
  numbers.slack = slack_of(std::min(slack, kMostLineSlack));
  course.start = backward ? ahead.high : -ahead.high;
  course.speed = std::abs(d[k]);
  const double length = std::ldexp(line.length, direction.exponent);
  course.longest = length * (1 + 0x1p-50) + 0x1p-1000;
  course.shortest = length * (1 - 0x1p-50) - 0x1p-1000;
  numbers.near_open = down(course.start * numbers.scale);
  numbers.near_sure = up(course.start * numbers.scale);
  const double way = course.shortest * course.speed;
  const double place = course.start + way;
  numbers.far_sure =
      std::isinf(way)
          ? static_cast<float>(kMostPlace)
          : down((place - (std::abs(course.start) + std::abs(way)) * kEndRounding) * numbers.scale);
  course.set_far(course.longest);
  return true;
}

void RayCourse::set_far(double time) {
  const double way = time * speed;
  if (std::isinf(way) || numbers.scale == 0) {
    numbers.far_open = static_cast<float>(kMostPlace);
    return;
  }
  const double place = (start + way) + (std::abs(start) + way) * kEndRounding;
  numbers.far_open = up(place * numbers.scale);
}

}  // namespace soms::detail
