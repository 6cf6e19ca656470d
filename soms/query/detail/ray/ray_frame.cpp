#include "soms/query/detail/ray/ray_frame.h"

#include "soms/geometry/detail/exact/power_of_two.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in ray_frame.h.
constexpr double kLineRounding = 128 * 0x1p-53;
constexpr double kOffsetRounding = 0x1p-95;
constexpr double kLineUnderflow = 0x1p-1064;
constexpr double kMostLineSlack = 0x1p50;
constexpr double kLineOfResidual = 12;
static_assert(2 + 2 + 6 + 2 + 4 <= 16 && 96.6 + 16 < 128);
static_assert(60 + 27 + 14 + 28.6 + 12.4 + 1 <= 2 * 128 && 10.5 <= kLineOfResidual);
static_assert(8.02 + 8.02 + 24.1 + 14.8 + 12 + 25.7 + 4 < 128);

/// Four roundings of the place of a ray's end, relative to its terms; kLineUnderflow covers what
/// underflows.
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

std::array<double, 3> product(const Matrix3& m, const std::array<double, 3>& v) {
  std::array<double, 3> u;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = (m[i][0] * v[0] + m[i][1] * v[1]) + m[i][2] * v[2];
  }
  return u;
}

std::array<double, 3> coordinates(const Vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace

/// A ray turned to an axis.
struct RayFrame::Sheared {
  std::array<std::size_t, 3> axis;  // the ray's, and those across it
  double sign;                      // of the direction on the ray's axis
  std::array<double, 3> slope;      // of the axes across; 0 on the ray's own
  std::array<double, 3> from;       // from the ray to the tree's origin, across
  double start;                     // along, from the tree's origin
  double rounding;                  // W in the mesh's units
};

RayFrame::RayFrame(const WideTree& tree, const Pose& pose)
    : reference_(tree, pose),
      rotation_(rotation(pose)),
      scale_(tree.scale()),
      near_(2 * reference_.extent),
      rounding_(kLineRounding * reference_.extent + kLineUnderflow),
      residual_(kLineOfResidual * reference_.residual * reference_.extent) {
  const Vec3 half = tree.bounds().extent() * 0.5;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& r = rotation_[k];
    half_[k] =
        ((std::abs(r[0]) * half.x + std::abs(r[1]) * half.y) + std::abs(r[2]) * half.z) + rounding_;
  }
}

/// False if the ray's line surely passes the moved box.
bool RayFrame::shear(const RayLine& line, const ScaledDirection& direction,
                     Sheared& sheared) const {
  const std::array<double, 3> d = coordinates(direction.high);
  std::size_t k = std::abs(d[1]) > std::abs(d[0]) ? 1 : 0;
  k = std::abs(d[2]) > std::abs(d[k]) ? 2 : k;
  const std::array<double, 3> o = coordinates(line.origin);
  const std::array<double, 3> origin = coordinates(reference_.origin);
  const std::array<double, 3> half = coordinates(half_);
  const DoubleDouble ahead = two_sum(origin[k], -o[k]);
  double offset = std::abs(ahead.high);
  std::array<double, 3> shadow = {};
  sheared.axis = {k, (k + 1) % 3, (k + 2) % 3};
  sheared.sign = d[k] < 0 ? -1 : 1;
  sheared.slope[0] = 0;
  sheared.from[0] = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    const std::size_t axis = sheared.axis[i];
    const DoubleDouble to = two_sum(origin[axis], -o[axis]);
    double slope = 0;
    if (d[axis] == 0) {
      sheared.from[i] = to.high;
    } else if (std::abs(to.high) <= near_ && std::abs(ahead.high) <= near_) {
      slope = d[axis] / d[k];
      sheared.from[i] = to.high - slope * ahead.high;
    } else {
      const DoubleDouble wide = direction.part[axis] / direction.part[k];
      slope = wide.high;
      sheared.from[i] = (to - wide * ahead).high;
    }
    sheared.slope[i] = slope;
    offset += std::abs(to.high);
    shadow[i] = half[axis] + std::abs(slope) * half[k];
  }
  sheared.start = -sheared.sign * ahead.high;
  sheared.rounding = rounding_ + offset * kOffsetRounding;
  return !(std::abs(sheared.from[1]) > shadow[1] + sheared.rounding ||
           std::abs(sheared.from[2]) > shadow[2] + sheared.rounding);
}

void RayFrame::see_blocks(const Sheared& sheared, LineNumbers& numbers) const {
  const auto& along = rotation_[sheared.axis[0]];
  LineView& view = numbers.block_view;
  for (std::size_t j = 0; j < 3; ++j) {
    view.column[j][0] = sheared.sign * along[j];
    for (std::size_t i = 1; i < 3; ++i) {
      view.column[j][i] = rotation_[sheared.axis[i]][j] - sheared.slope[i] * along[j];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      numbers.row[i][j] = static_cast<float>(view.column[j][i]);
    }
  }
  view.shift = {0, sheared.from[1], sheared.from[2], 0};
}

/// Turns the mesh's units into those of the layout: by a power of two, so nothing is rounded but
/// what underflows, which is nothing beside the slack.
void RayFrame::scale(LineView& view, double scale) {
  for (auto& column : view.column) {
    for (double& entry : column) {
      entry *= scale;
    }
  }
  for (double& entry : view.shift) {
    entry *= scale;
  }
}

void RayFrame::see_nodes(const Sheared& sheared, LineNumbers& numbers) const {
  std::array<double, 3> ahead;
  std::array<double, 3> start;
  for (std::size_t i = 0; i < 3; ++i) {
    ahead[sheared.axis[i]] = sheared.sign * (i == 0 ? 1 : sheared.slope[i]);
    start[sheared.axis[i]] = -sheared.from[i];
  }
  if (reference_.rotated) {
    ahead = product(reference_.inverse, ahead);
    start = product(reference_.inverse, start);
  }
  LineView& view = numbers.node_view;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double place = ahead[i] * numbers.block_view.column[j][0];
      view.column[j][i] = i == j ? place - 1 : place;
    }
    view.column[i][3] = numbers.block_view.column[i][0];
    view.shift[i] = start[i];
    const auto component = static_cast<float>(ahead[i]);
    numbers.ahead[i] = component;
    numbers.reach[i] = 1.0F / std::max(std::abs(component), kLeastAhead);
    numbers.inverse[i] = component < 0 ? -numbers.reach[i] : numbers.reach[i];
  }
}

bool RayFrame::start(const RayLine& line, const ScaledDirection& direction,
                     RayCourse& course) const {
  Sheared sheared;
  if (!shear(line, direction, sheared)) {
    return false;
  }
  LineNumbers& numbers = course.numbers;
  const double slack = sheared.rounding * scale_;
  const double node_slack = (2 * sheared.rounding + residual_) * scale_;
  const bool blind = node_slack > kMostLineSlack;
  numbers.scale = blind ? 0 : scale_;
  numbers.slack = slack_of(blind ? kMostLineSlack : slack);
  numbers.node_slack = slack_of(blind ? kMostLineSlack : node_slack);
  see_blocks(sheared, numbers);
  see_nodes(sheared, numbers);
  if (numbers.scale != 1) {
    scale(numbers.block_view, numbers.scale);
    scale(numbers.node_view, numbers.scale);
  }
  course.start = sheared.start;
  course.speed = std::abs(direction.high[sheared.axis[0]]);
  const double length = times_power_of_two(line.length, direction.exponent);
  course.longest = length * (1 + 0x1p-50) + 0x1p-1000;
  course.shortest = length * (1 - 0x1p-50) - 0x1p-1000;
  numbers.near_open = down(course.start * numbers.scale);
  numbers.near_sure = up(course.start * numbers.scale);
  const double way = course.shortest * course.speed;
  const double place = course.start + way;
  numbers.far_sure = std::isinf(way)
                         ? static_cast<float>(kMostPlace)
                         : down((place - ((std::abs(course.start) + std::abs(way)) * kEndRounding +
                                          kLineUnderflow)) *
                                numbers.scale);
  course.set_far(course.longest);
  return true;
}

void RayCourse::set_far(double time) {
  const double way = time * speed;
  if (std::isinf(way) || numbers.scale == 0) {
    numbers.far_open = static_cast<float>(kMostPlace);
    return;
  }
  const double place = (start + way) + ((std::abs(start) + way) * kEndRounding + kLineUnderflow);
  numbers.far_open = up(place * numbers.scale);
}

}  // namespace soms::detail
