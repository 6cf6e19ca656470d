#include "tests/query/margins/gap.h"

#include "soms/geometry/triangle_distance.h"
#include "soms/query/detail/leaf_pairs.h"

#include "tests/query/overlap_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::test {

namespace {

using detail::BlockTask;
using detail::Kernels;
using detail::NearFilter;
using detail::NodeKeys;
using detail::NodeTask;
using detail::PoseNumbers;

Vec3 point_within(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

/// Off orthonormal by nearly what poses may be, the same way in every entry or along the axes.
Pose off_by_all(Rng& rng) {
  Pose pose;
  const double by = rng.below(2) == 0 ? 0.4999e-6 : -0.4999e-6;
  const bool everywhere = rng.below(2) == 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose.m[4 * i + j] += i == j || everywhere ? by : 0;
    }
  }
  return pose;
}

Pose any_rotation(Rng& rng) {
  return rng.below(3) == 0 ? off_by_all(rng) : awkward_rotation(rng);
}

/// Triangles of a body about the origin: its corner is the end of a diagonal of its box, in the
/// direction `way` of the world.
Triangle facing(Rng& rng, const Pose& pose, const Vec3& way, double size) {
  Vec3 corner;
  for (std::size_t j = 0; j < 3; ++j) {
    const double along = pose.m[j] * way.x + pose.m[4 + j] * way.y + pose.m[8 + j] * way.z;
    const double half = size * (rng.below(3) == 0 ? rng.unit() * 0x1p-10 : 1);
    corner[j] = along < 0 ? -half : half;
  }
  const Vec3 third = rng.below(2) == 0 ? -corner : Vec3{corner.x, -corner.y, -corner.z};
  return {corner, -corner, third};
}

/// A triangle or a segment through the origin, across `way`.
Triangle across(Rng& rng, const Pose& pose, const Vec3& way, double size) {
  const auto corner = [&] {
    const Vec3 p = cross(way, point_within(rng, 1));
    return size * Vec3{pose.m[0] * p.x + pose.m[4] * p.y + pose.m[8] * p.z,
                       pose.m[1] * p.x + pose.m[5] * p.y + pose.m[9] * p.z,
                       pose.m[2] * p.x + pose.m[6] * p.y + pose.m[10] * p.z};
  };
  const Vec3 first = corner();
  return {first, -first, rng.below(2) == 0 ? first : corner()};
}

Gap gap_of(Rng& rng, double far, double size_x, double size_y, double length) {
  Gap gap;
  gap.pose_x = any_rotation(rng);
  gap.pose_y = rng.below(3) == 0 ? gap.pose_x : any_rotation(rng);
  Vec3 way = point_within(rng, 1);
  if (rng.below(2) == 0) {
    way = rng.below(2) == 0 ? Vec3{1, 1, 1} : Vec3{0, 0, 1};
  }
  way = way * (1 / std::sqrt(dot(way, way)));
  const bool flat = rng.below(4) == 0;
  gap.x = flat ? across(rng, gap.pose_x, way, size_x) : facing(rng, gap.pose_x, way, size_x);
  gap.y = flat ? across(rng, gap.pose_y, way, size_y) : facing(rng, gap.pose_y, -way, size_y);
  const Vec3 place = rng.below(2) == 0 ? Vec3{} : point_within(rng, far);
  gap.pose_x = moving(gap.pose_x, gap.x.a, place);
  gap.pose_y = moving(gap.pose_y, gap.y.a, place + length * way);
  return gap;
}

double& entry_of(Gap& gap, std::uint64_t which) {
  if (which < 24) {
    return (which < 12 ? gap.pose_x : gap.pose_y).m[which % 12];
  }
  const std::array<Vec3*, 6> corners{&gap.x.a, &gap.x.b, &gap.x.c, &gap.y.a, &gap.y.b, &gap.y.c};
  return (*corners[(which - 24) / 3])[which % 3];
}

NodeTask task_of_roots(const Seen& seen, const PoseNumbers& numbers) {
  NodeTask task = {};
  task.pose = &numbers;
  task.x = seen.frame.x().layout().nodes().data();
  task.y = seen.frame.y().layout().nodes().data();
  task.pairs = 1;
  return task;
}

BlockTask task_of_blocks(const Seen& seen, const PoseNumbers& numbers) {
  BlockTask task = {};
  task.pose = &numbers;
  task.x = seen.frame.x().layout().blocks().data();
  task.y = seen.frame.y().layout().blocks().data();
  return task;
}

/// From the triangle of x to that of y in y's axes, of length 1 as floats have it.
std::array<float, 3> line_between(const Seen& seen) {
  const TriangleDistance d =
      triangle_distance(detail::moved(seen.frame.x(), 0), detail::moved(seen.frame.y(), 0));
  const Vec3 way = d.point_b - d.point_a;
  const Pose& pose = *seen.frame.y().pose;
  std::array<double, 3> line{};
  double square = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    line[j] = pose.m[j] * way.x + pose.m[4 + j] * way.y + pose.m[8 + j] * way.z;
    square += line[j] * line[j];
  }
  const double factor = square > 0 ? 1 / std::sqrt(square) : 0;
  return {static_cast<float>(line[0] * factor), static_cast<float>(line[1] * factor),
          static_cast<float>(line[2] * factor)};
}

/// The numbers with a share of the margins; `limit` gets what is left of the reach.
PoseNumbers with_share(const Seen& seen, double share, float& limit) {
  PoseNumbers numbers = seen.pose.numbers();
  const double exact = seen.distance * numbers.scale;
  const auto part = [&](double from, double to) {
    return static_cast<float>(from + share * (to - from));
  };
  limit = part(exact, seen.pose.limit());
  numbers.relative = part(0, numbers.relative);
  numbers.slack = part(exact, numbers.slack);
  numbers.rounding = part(0, numbers.rounding);
  numbers.shrink = part(1, numbers.shrink);
  return numbers;
}

/// The least share, to 1 %, with which `keeps` holds.
template <class Keeps>
double least_share(const Keeps& keeps) {
  double lower = 0;
  double upper = 2;
  if (keeps(0.0)) {
    return 0;
  }
  while (upper > 1.01 * lower && upper > 0x1p-20) {
    const double middle = lower == 0 ? upper / 4 : std::sqrt(lower * upper);
    (keeps(middle) ? upper : lower) = middle;
  }
  return upper;
}

/// V of relative_pose.h, a body's share.
double moved_extent(const detail::PosedShape& side) {
  const Box& box = side.layout().bounds();
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = std::abs(side.pose->m[4 * k + 3]);
    for (std::size_t j = 0; j < 3; ++j) {
      sum += std::abs(side.pose->m[4 * k + j]) *
             std::max(std::abs(box.lower[j]), std::abs(box.upper[j]));
    }
    most = std::max(most, sum);
  }
  return most;
}

/// The share of 256 u64 V and of 2^-19 of the radii (near_pose.h) that far triangles need.
double needed_of_far(const Seen& seen) {
  const detail::PosedShape& x = seen.frame.x();
  const detail::PosedShape& y = seen.frame.y();
  const Vec3 way = x.pose->apply(x.layout().origin()) - y.pose->apply(y.layout().origin());
  const double base = std::sqrt(dot(way, way));
  const PoseNumbers& numbers = seen.pose.numbers();
  const double exact = (seen.distance - base) * numbers.scale;
  const double radii = static_cast<double>(x.layout().blocks()[0].l1_radius) * numbers.ratio +
                       static_cast<double>(y.layout().blocks()[0].l1_radius);
  const double margin =
      256 * 0x1p-53 * (moved_extent(x) + moved_extent(y)) * numbers.scale + 0x1p-19 * radii;
  const double key = far_bounds_of(seen).of_triangles;
  return 1 + (key + 0x1p-22 * std::abs(key) - exact) / margin;
}

}  // namespace

Shape shape_of(const Triangle& t) {
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return Shape(mesh);
}

Gap random_gap(Rng& rng, double far) {
  const double size_x = std::exp2(-rng.uniform(0, 8));
  const double size_y = std::exp2(-rng.uniform(0, 8));
  const double sizes = size_x + size_y;
  const double length = rng.below(3) == 0   ? std::exp2(-rng.uniform(0, 60))
                        : rng.below(2) == 0 ? std::exp2(-rng.uniform(10, 16)) * sizes
                                            : rng.uniform(0, 40) * sizes;
  return gap_of(rng, far, size_x, size_y, length);
}

Gap random_far_gap(Rng& rng, double far) {
  const double scale = rng.below(2) == 0 ? 1 : 0x1p-30;
  const double size_x = std::exp2(-rng.uniform(0, 8));
  const double size_y = std::exp2(-rng.uniform(0, 8));
  const double length =
      64 * (size_x + size_y) * (rng.below(2) == 0 ? 1 : std::exp2(rng.uniform(0, 30)));
  return gap_of(rng, far, scale * size_x, scale * size_y, length);
}

Gap changed(Rng& rng, Gap gap) {
  for (std::uint64_t left = 1 + rng.below(3); left > 0; --left) {
    double& number = entry_of(gap, rng.below(42));
    if (rng.below(3) == 0) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      number = std::nextafter(number, rng.below(2) == 0 ? kInfinity : -kInfinity);
    } else {
      number *= 1 + rng.uniform(-1, 1) * std::exp2(-rng.uniform(18, 52));
    }
  }
  return gap;
}

Seen::Seen(const Shape& shape_a, const Pose& pose_a, const Shape& shape_b, const Pose& pose_b)
    : a(shape_a, pose_a),
      b(shape_b, pose_b),
      frame(a, b),
      pose(frame),
      distance(triangle_distance(detail::moved(frame.x(), 0), detail::moved(frame.y(), 0))
                   .distance.upper) {
  pose.set_limit(distance);
}

Bounds bounds_of(Seen& seen, const Kernels& kernels) {
  const PoseNumbers& numbers = seen.pose.numbers();
  Bounds bounds;
  const NodeTask roots = task_of_roots(seen, numbers);
  NodeKeys keys;
  kernels.bound_nodes(&roots, 1, seen.pose.limit(), &keys);
  bounds.nodes = (keys.near & 1) != 0 && !(keys.key[0] > seen.pose.limit());
  bounds.of_nodes = seen.pose.distance_of(keys.key[0]);
  BlockTask blocks = task_of_blocks(seen, numbers);
  kernels.test_slabs(&blocks, 1);
  bounds.slabs = blocks.lanes_x == 1 && blocks.lanes_y == 1;
  blocks.lanes_x = 1;
  blocks.lanes_y = 1;
  detail::TriangleSlot slot;
  const float reach = seen.pose.limit();
  bounds.boxes = kernels.near_boxes(blocks, {reach, line_between(seen)}, slot) == 1;
  static_cast<void>(kernels.near_boxes(blocks, {0x1p60F, {0, 0, 0}}, slot));
  std::array<std::uint32_t, detail::kJudged> first{};
  std::array<std::uint32_t, detail::kJudged> second{};
  second.fill(sizeof(detail::TriangleSlot::Corners) / sizeof(float));
  detail::PairGaps gaps;
  kernels.near_pairs(&slot, first.data(), second.data(), 1, reach, gaps);
  bounds.pairs = gaps.near == 1 && !(gaps.lower[0] > reach);
  bounds.of_pairs = seen.pose.distance_of(gaps.lower[0]);
  return bounds;
}

FarBounds far_bounds_of(const Seen& seen) {
  NodeKeys keys;
  seen.pose.far_keys(task_of_roots(seen, seen.pose.numbers()), seen.pose.limit(), keys);
  detail::NearPose::BlockKeys of_triangles;
  seen.pose.far_keys(seen.frame.x().layout().blocks()[0], seen.frame.y().layout().blocks()[0],
                     of_triangles);
  return {keys.key[0], of_triangles[0][0]};
}

NeededOfGap needed(const Seen& seen, const Kernels& kernels) {
  NeededOfGap most;
  if (seen.pose.far()) {
    most.far = needed_of_far(seen);
    return most;
  }
  most.nodes = least_share([&](double share) {
    float limit = 0;
    const PoseNumbers numbers = with_share(seen, share, limit);
    const NodeTask roots = task_of_roots(seen, numbers);
    NodeKeys keys;
    kernels.bound_nodes(&roots, 1, limit, &keys);
    return !(keys.key[0] > limit);
  });
  most.slabs = least_share([&](double share) {
    float limit = 0;
    const PoseNumbers numbers = with_share(seen, share, limit);
    BlockTask blocks = task_of_blocks(seen, numbers);
    kernels.test_slabs(&blocks, 1);
    return blocks.lanes_x == 1 && blocks.lanes_y == 1;
  });
  return most;
}

}  // namespace soms::test
