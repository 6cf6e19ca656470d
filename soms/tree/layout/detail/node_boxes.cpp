#include "soms/tree/layout/detail/node_boxes.h"

#include "soms/tree/layout/detail/double_lanes.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace soms::layout {

namespace {

// Everything is inlined into set_boxes, which is compiled for the instructions that every processor
// has and for AVX2. Both give the same bytes: each lane is a float or a double, and nothing is
// fused or reordered but minima.

/// Boxes along other axes are taken where they have less than this share of the area.
constexpr double kWorthTurning = 0.9;

using NarrowFloats [[gnu::vector_size(16)]] = float;
#if defined(__x86_64__)
using WideFloats [[gnu::vector_size(32)]] = float;
#endif
using Bits64 [[gnu::vector_size(32)]] = std::int64_t;
using Bits32 [[gnu::vector_size(16)]] = std::int32_t;

/// Boxes of the lanes about the node's origin, and by how much each gives way; 0 in lanes that are
/// not in use.
struct LaneBoxes {
  std::array<D4, 3> lower;
  std::array<D4, 3> upper;
  D4 give;
};

[[gnu::always_inline]] inline Bits64 lanes_in_use(std::size_t count) {
  const auto n = static_cast<std::int64_t>(count);
  constexpr Bits64 kLane = {0, 1, 2, 3};
  return kLane < Bits64{n, n, n, n};
}

[[gnu::always_inline]] inline D4 magnitude(const D4& v) {
  return v < 0 ? -v : v;
}

/// 1-norms of the boxes' farthest corners from the origin.
[[gnu::always_inline]] inline D4 norms(const LaneBoxes& boxes) {
  D4 sum = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += greater(magnitude(boxes.lower[axis]), magnitude(boxes.upper[axis]));
  }
  return sum;
}

/// `Frame::doubt` in lanes.
[[gnu::always_inline]] inline D4 doubts(const Frame& frame, const D4& norm, bool oriented) {
  return (all_lanes(oriented ? 0x1p-22 : 0x1p-49) * norm + all_lanes(0x1p-50 * frame.size)) +
         all_lanes(0x1p-130);
}

/// Half the area of all boxes.
[[gnu::always_inline]] inline double half_area_of(const LaneBoxes& boxes) {
  const D4 x = boxes.upper[0] - boxes.lower[0];
  const D4 y = boxes.upper[1] - boxes.lower[1];
  const D4 z = boxes.upper[2] - boxes.lower[2];
  const D4 area = (x * y + y * z) + z * x;
  return ((area[0] + area[1]) + area[2]) + area[3];
}

/// Coordinates on an axis about the node's origin, in units of the layout.
[[gnu::always_inline]] inline D4 seen_from(const WideNode& node, const Frame& frame,
                                           std::size_t axis, const D4& v) {
  return ((v - all_lanes(frame.origin[axis])) - all_lanes(node.origin[axis])) *
         all_lanes(frame.scale);
}

[[gnu::always_inline]] inline LaneBoxes plain_boxes(std::span<const LaneContent> lanes,
                                                    const Frame& frame, const WideNode& node) {
  LaneBoxes boxes;
  const Bits64 used = lanes_in_use(lanes.size());
  std::array<const Box*, WideNode::kWidth> at;
  for (std::size_t k = 0; k < at.size(); ++k) {
    at[k] = &lanes[k < lanes.size() ? k : 0].bounds;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const D4 lower = {at[0]->lower[axis], at[1]->lower[axis], at[2]->lower[axis],
                      at[3]->lower[axis]};
    const D4 upper = {at[0]->upper[axis], at[1]->upper[axis], at[2]->upper[axis],
                      at[3]->upper[axis]};
    const D4 seen_lower = seen_from(node, frame, axis, lower);
    const D4 seen_upper = seen_from(node, frame, axis, upper);
    boxes.lower[axis] = used ? seen_lower : D4{};
    boxes.upper[axis] = used ? seen_upper : D4{};
  }
  const D4 give = doubts(frame, norms(boxes), false);
  boxes.give = used ? give : D4{};
  return boxes;
}

template <class Vector>
[[gnu::always_inline]] inline Vector splat_of(float x) {
  return Vector{} + x;
}

template <class Vector>
[[gnu::always_inline]] inline Vector load_vector(const float* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

[[gnu::always_inline]] inline NarrowFloats lesser_half(const NarrowFloats& v) {
  return v;
}

[[gnu::always_inline]] inline NarrowFloats greater_half(const NarrowFloats& v) {
  return v;
}

#if defined(__x86_64__)
[[gnu::always_inline]] inline NarrowFloats lesser_half(const WideFloats& v) {
  const NarrowFloats low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
  const NarrowFloats high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  return high < low ? high : low;
}

[[gnu::always_inline]] inline NarrowFloats greater_half(const WideFloats& v) {
  const NarrowFloats low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
  const NarrowFloats high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
  return high > low ? high : low;
}
#endif

/// Bounds of points in float, several at a time.
template <class Vector>
struct PointBounds {
  std::array<Vector, 3> lower;
  std::array<Vector, 3> upper;
};

/// Bounds a block's corners along the axes, in float, as seen from the node, which sees the block's
/// origin at `place` along them.
template <class Vector>
[[gnu::always_inline]] inline void bound_corners(const TriangleBlock& block, const Axes& axes,
                                                 const std::array<float, 3>& place,
                                                 PointBounds<Vector>& bounds) {
  constexpr std::size_t kStep = sizeof(Vector) / sizeof(float);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto x = splat_of<Vector>(axes[axis]);
    const auto y = splat_of<Vector>(axes[3 + axis]);
    const auto z = splat_of<Vector>(axes[6 + axis]);
    const auto at = splat_of<Vector>(place[axis]);
    Vector lower = bounds.lower[axis];
    Vector upper = bounds.upper[axis];
    for (std::size_t c = 0; c < 9; c += 3) {
      for (std::size_t k = 0; k < TriangleBlock::kWidth; k += kStep) {
        const Vector v = ((x * load_vector<Vector>(&block.corner[c][k]) +
                           y * load_vector<Vector>(&block.corner[c + 1][k])) +
                          z * load_vector<Vector>(&block.corner[c + 2][k])) +
                         at;
        lower = v < lower ? v : lower;
        upper = v > upper ? v : upper;
      }
    }
    bounds.lower[axis] = lower;
    bounds.upper[axis] = upper;
  }
}

/// Columns of four rows' least or greatest numbers.
struct Quad {
  std::array<NarrowFloats, WideNode::kWidth> lane;
};

[[gnu::always_inline]] inline NarrowFloats lesser_of(const NarrowFloats& a, const NarrowFloats& b) {
  return b < a ? b : a;
}

[[gnu::always_inline]] inline D4 least_of(const Quad& q) {
  const NarrowFloats ab = lesser_of(__builtin_shufflevector(q.lane[0], q.lane[1], 0, 1, 4, 5),
                                    __builtin_shufflevector(q.lane[0], q.lane[1], 2, 3, 6, 7));
  const NarrowFloats cd = lesser_of(__builtin_shufflevector(q.lane[2], q.lane[3], 0, 1, 4, 5),
                                    __builtin_shufflevector(q.lane[2], q.lane[3], 2, 3, 6, 7));
  return __builtin_convertvector(lesser_of(__builtin_shufflevector(ab, cd, 0, 2, 4, 6),
                                           __builtin_shufflevector(ab, cd, 1, 3, 5, 7)),
                                 D4);
}

[[gnu::always_inline]] inline D4 greatest_of(const Quad& q) {
  Quad negative;
  for (std::size_t k = 0; k < q.lane.size(); ++k) {
    negative.lane[k] = -q.lane[k];
  }
  return -least_of(negative);
}

/// Boxes along `axes`. Of the terms that a corner's coordinate is the sum of, at most `far`
/// together, none is off by more than 5 * 2^-24 of itself and of what is added to it (its corner's
/// rounding, its product's, three sums'), 2^-22 more for the axes' defect.
template <class Vector>
[[gnu::always_inline]] inline LaneBoxes turned_boxes(std::span<const LaneContent> lanes,
                                                     const Axes& axes, const Frame& frame,
                                                     const WideNode& node) {
  std::array<Quad, 3> lower = {};
  std::array<Quad, 3> upper = {};
  std::array<double, WideNode::kWidth> farthest = {};
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    PointBounds<Vector> bounds;
    bounds.lower.fill(splat_of<Vector>(std::numeric_limits<float>::infinity()));
    bounds.upper.fill(splat_of<Vector>(-std::numeric_limits<float>::infinity()));
    double far = 0;
    for (const TriangleBlock& block : lanes[k].blocks) {
      const Vec3 offset{block.origin[0] - node.origin[0], block.origin[1] - node.origin[1],
                        block.origin[2] - node.origin[2]};
      const Vec3 place = along(axes, offset * frame.scale);
      bound_corners(
          block, axes,
          {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z)},
          bounds);
      far = std::max(far, std::abs(place.x) + std::abs(place.y) + std::abs(place.z) +
                              static_cast<double>(block.l1_radius));
    }
    farthest[k] = far;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis].lane[k] = lesser_half(bounds.lower[axis]);
      upper[axis].lane[k] = greater_half(bounds.upper[axis]);
    }
  }
  LaneBoxes boxes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Which of -0 and 0 is least depends on the order; 0 is added so that there is only one.
    boxes.lower[axis] = least_of(lower[axis]) + 0.0;
    boxes.upper[axis] = greatest_of(upper[axis]) + 0.0;
  }
  const D4 give = doubts(frame, norms(boxes), true) +
                  0x1p-18 * D4{farthest[0], farthest[1], farthest[2], farthest[3]};
  boxes.give = lanes_in_use(lanes.size()) ? give : D4{};
  return boxes;
}

/// `rounded_up` in lanes, for numbers that are not negative.
[[gnu::always_inline]] inline NarrowFloats up_in_lanes(const D4& x) {
  const auto f = __builtin_convertvector(x, NarrowFloats);
  const Bits64 below = __builtin_convertvector(f, D4) < x;  // -1 where it holds
  Bits32 bits;
  std::memcpy(&bits, &f, sizeof bits);
  bits -= __builtin_convertvector(below, Bits32);
  NarrowFloats up;
  std::memcpy(&up, &bits, sizeof up);
  return up;
}

[[gnu::always_inline]] inline double greatest(const D4& v) {
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}

/// Rounds boxes outward into the node.
[[gnu::always_inline]] inline void store_boxes(const LaneBoxes& boxes, WideNode& node) {
  D4 distance = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto center =
        __builtin_convertvector(0.5 * (boxes.lower[axis] + boxes.upper[axis]), NarrowFloats);
    const D4 middle = __builtin_convertvector(center, D4);
    const NarrowFloats half =
        up_in_lanes(greater(boxes.upper[axis] - middle, middle - boxes.lower[axis]) + boxes.give);
    std::memcpy(node.center[axis].data(), &center, sizeof center);
    std::memcpy(node.half[axis].data(), &half, sizeof half);
    const D4 far = magnitude(middle) + __builtin_convertvector(half, D4);
    node.row[axis][3] = layout::rounded_up(greatest(far));
    distance += far;
  }
  // The sum of three had two roundings.
  node.l1_radius = layout::rounded_up(greatest(distance) * (1 + 0x1p-50));
}

template <class Vector>
[[gnu::always_inline]] inline void set_all(std::span<const LaneContent> lanes, const Axes& axes,
                                           const Frame& frame, WideNode& node) {
  const LaneBoxes plain = plain_boxes(lanes, frame, node);
  if (axes != kMeshAxes) {
    const LaneBoxes turned = turned_boxes<Vector>(lanes, axes, frame, node);
    if (half_area_of(turned) < kWorthTurning * half_area_of(plain)) {
      for (std::size_t k = 0; k < axes.size(); ++k) {
        node.row[k / 3][k % 3] = axes[k];
      }
      node.oriented = 1;
      store_boxes(turned, node);
      return;
    }
  }
  store_boxes(plain, node);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void set_by_avx2(std::span<const LaneContent> lanes, const Axes& axes,
                                         const Frame& frame, WideNode& node) {
  set_all<WideFloats>(lanes, axes, frame, node);
}
#endif

}  // namespace

void set_boxes_plainly(std::span<const LaneContent> lanes, const Axes& axes, const Frame& frame,
                       WideNode& node) {
  set_all<NarrowFloats>(lanes, axes, frame, node);
}

void set_boxes(std::span<const LaneContent> lanes, const Axes& axes, const Frame& frame,
               WideNode& node) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    set_by_avx2(lanes, axes, frame, node);
    return;
  }
#endif
  set_boxes_plainly(lanes, axes, frame, node);
}

}  // namespace soms::layout
