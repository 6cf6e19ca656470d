#include "soms/tree/build/detail/reference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace soms::detail {

namespace {

using lanes::Box4;
using lanes::F4;

/// Where the widest triangle is wider than this share of the box of the middles, the plane in the
/// middle cuts it: a second look is due (docs/decisions/0008).
constexpr float kWideShare = 0.5F;

/// Bins of a look at all planes; the quality builder takes the most for runs that are worth it.
constexpr std::size_t kFewBins = 16;
constexpr std::uint32_t kManyBinsFrom = 256;

std::size_t longest(F4 v) {
  const std::size_t xy = v[1] > v[0] ? 1 : 0;
  return v[2] > v[xy] ? 2 : xy;
}

[[gnu::always_inline]] inline Box4 box_of(const Reference& r) {
  const F4 middle = r.point();
  const F4 half = r.half_extent();
  return {middle - half, middle + half};
}

/// Blocks of a leaf's triangles: what a query pays for.
float cost_of(float area, std::uint32_t count, std::uint32_t per_leaf) {
  const std::uint32_t blocks = (count + per_leaf - 1) / per_leaf;
  return area * static_cast<float>(blocks);
}

[[gnu::always_inline]] inline PrimitiveRange range_of(std::span<const Reference> all,
                                                      std::uint32_t first, std::uint32_t count) {
  PrimitiveRange range;
  range.first = first;
  for (const Reference& r : all.subspan(first, count)) {
    range.add(r);
  }
  return range;
}

/// Most references that are divided between any two of them.
constexpr std::uint32_t kSweep = ReferenceDivider::kSweep;

using Order = std::array<std::uint8_t, kSweep>;

// Dividing is compiled for the instructions that every processor has and for AVX2, with the same
// results: nothing is fused or reordered, and everything is inlined.

/// Four lanes.
struct FourLanes {
  using Floats = F4;
  using Ints [[gnu::vector_size(16)]] = std::int32_t;
  static constexpr Ints kLane = {0, 1, 2, 3};
};

#if defined(__x86_64__)
/// Eight lanes, where AVX2 is.
struct EightLanes {
  using Floats [[gnu::vector_size(32)]] = float;
  using Ints [[gnu::vector_size(32)]] = std::int32_t;
  static constexpr Ints kLane = {0, 1, 2, 3, 4, 5, 6, 7};
};
#endif

/// References by their middles on an axis, equal ones as they lie: each is put where as many are
/// before it, which takes no branch that depends on them. All places are counted side by side.
template <class Lanes>
[[gnu::always_inline]] inline Order order_of(std::span<const Reference> refs, std::size_t axis) {
  constexpr std::size_t kWidth = sizeof(typename Lanes::Floats) / sizeof(float);
  constexpr std::size_t kRows = kSweep / kWidth;
  const std::size_t n = refs.size();
  std::array<float, kSweep> key;
  for (std::size_t i = 0; i < kSweep; ++i) {
    key[i] = refs[std::min(i, n - 1)].middle[axis];
  }
  std::array<typename Lanes::Floats, kRows> own;
  std::array<typename Lanes::Ints, kRows> before;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::memcpy(&own[row], &key[kWidth * row], sizeof own[row]);
    before[row] = typename Lanes::Ints{};
  }
  for (std::size_t j = 0; j < n; ++j) {
    const typename Lanes::Floats other = typename Lanes::Floats{} + key[j];
    const auto place = static_cast<std::int32_t>(j);
    for (std::size_t row = 0; row < kRows; ++row) {
      const typename Lanes::Ints lane = Lanes::kLane + static_cast<std::int32_t>(kWidth * row);
      before[row] -= (other < own[row]) | ((other == own[row]) & (place < lane));
    }
  }
  std::array<std::int32_t, kSweep> places;
  for (std::size_t row = 0; row < kRows; ++row) {
    std::memcpy(&places[kWidth * row], &before[row], sizeof before[row]);
  }
  Order order = {};
  for (std::size_t i = 0; i < n; ++i) {
    order[static_cast<std::size_t>(places[i])] = static_cast<std::uint8_t>(i);
  }
  return order;
}

}  // namespace

PrimitiveFrame frame_of(const Box& box) {
  const Vec3 extent = box.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  return {box.center(), size > 0 ? std::ldexp(1.0, std::min(1000, -std::ilogb(size))) : 1};
}

// Where middles are much closer than triangles are large: areas of such boxes are still floats.
constexpr double kMostHalf = 0x1p40;
// Of middles only those go beyond that are all the same but for rounding.
constexpr double kMostMiddle = 0x1p60;

Reference reference_of(const MeshView& mesh, TriangleId id, const PrimitiveFrame& frame) {
  const auto& corners = mesh.triangles[id];
  const Vec3& a = mesh.vertices[corners[0]];
  const Vec3& b = mesh.vertices[corners[1]];
  const Vec3& c = mesh.vertices[corners[2]];
  Reference r;
  r.id = id;
  for (std::size_t k = 0; k < 3; ++k) {
    const double ab_low = a[k] < b[k] ? a[k] : b[k];
    const double ab_high = a[k] < b[k] ? b[k] : a[k];
    const double lower = (ab_low < c[k] ? ab_low : c[k]) - frame.origin[k];
    const double upper = (ab_high < c[k] ? c[k] : ab_high) - frame.origin[k];
    r.middle[k] = static_cast<float>(
        std::clamp((lower + upper) * (0.5 * frame.scale), -kMostMiddle, kMostMiddle));
    r.half[k] = static_cast<float>(std::min((upper - lower) * (0.5 * frame.scale), kMostHalf));
  }
  return r;
}

ReferenceDivider::ReferenceDivider(const BuildOptions& options)
    : per_leaf_(static_cast<std::uint32_t>(options.per_leaf)),
      quality_(options.rule == Rule::quality) {
  for (std::uint32_t count = 0; count < blocks_.size(); ++count) {
    blocks_[count] = cost_of(1, count, per_leaf_);
  }
}

Halves ReferenceDivider::halve(std::span<const Reference> all, const PrimitiveRange& run) {
  Halves halves;
  halves.even = true;
  halves.left.first = run.first;
  halves.right.first = run.first + run.count / 2;
  for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
    (i < halves.right.first ? halves.left : halves.right).add(all[i]);
  }
  return halves;
}

Halves ReferenceDivider::divide(std::span<Reference> all, const PrimitiveRange& run) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    return divide_by_avx2(all, run);
  }
#endif
  return divide_plainly(all, run);
}

Halves ReferenceDivider::divide_plainly(std::span<Reference> all, const PrimitiveRange& run) {
  return divide_by<FourLanes>(all, run);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] Halves ReferenceDivider::divide_by_avx2(std::span<Reference> all,
                                                                const PrimitiveRange& run) {
  return divide_by<EightLanes>(all, run);
}
#endif

template <class Lanes>
Halves ReferenceDivider::divide_by(std::span<Reference> all, const PrimitiveRange& run) {
  const F4 extent = run.middles.upper - run.middles.lower;
  const std::size_t axis = longest(extent);
  if (!(extent[axis] > 0)) {
    return halve(all, run);
  }
  if (run.count <= kSweep) {
    return sweep<Lanes>(all, run);
  }
  Plane plane;
  if (quality_ || 2 * run.widest[axis] > kWideShare * extent[axis]) {
    plane = cheapest_plane(all.subspan(run.first, run.count), run);
  }
  if (!plane.found) {
    const float lower = run.middles.lower[axis];
    const float upper = run.middles.upper[axis];
    const float middle = 0.5F * (lower + upper);
    plane = {axis, middle > lower ? middle : upper, true};
  }
  return cut(all, run, plane);
}

/// Least sum of area times blocks over the bounds of bins on all axes.
ReferenceDivider::Plane ReferenceDivider::cheapest_plane(std::span<const Reference> run,
                                                         const PrimitiveRange& range) {
  const std::size_t count_of_bins = quality_ && range.count >= kManyBinsFrom ? kMostBins : kFewBins;
  const F4 lower = range.middles.lower;
  const F4 extent = range.middles.upper - lower;
  F4 scale = lanes::splat(0);
  for (std::size_t k = 0; k < 3; ++k) {
    // Bins of an axis too short for them would be subnormal or none.
    scale[k] =
        extent[k] > 0x1p-100F ? static_cast<float>(count_of_bins) * (1 - 0x1p-20F) / extent[k] : 0;
  }
  auto& bins = bins_;
  for (auto& axis : bins) {
    std::fill_n(axis.begin(), count_of_bins, Bin{});
  }
  for (const Reference& r : run) {
    const F4 place = (r.point() - lower) * scale;
    const Box4 box = box_of(r);
    for (std::size_t k = 0; k < 3; ++k) {
      Bin& bin = bins[k][static_cast<std::size_t>(static_cast<std::int32_t>(place[k]))];
      bin.box.grow(box);
      ++bin.count;
    }
  }
  Plane best;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(scale[k] > 0)) {
      continue;
    }
    std::array<float, kMostBins> right;
    Box4 box;
    std::uint32_t count = 0;
    for (std::size_t i = count_of_bins - 1; i > 0; --i) {
      box.grow(bins[k][i].box);
      count += bins[k][i].count;
      right[i] = count > 0 ? cost_of(box.half_area(), count, per_leaf_) : 0;
    }
    box = Box4{};
    count = 0;
    for (std::size_t i = 1; i < count_of_bins; ++i) {
      box.grow(bins[k][i - 1].box);
      count += bins[k][i - 1].count;
      if (count == 0 || count == range.count) {
        continue;
      }
      const float cost = cost_of(box.half_area(), count, per_leaf_) + right[i];
      if (cost < least) {
        least = cost;
        // The first place of bin i, so that what was counted right goes right, but for rounding.
        best = {k, lower[k] + static_cast<float>(i) / scale[k], true};
      }
    }
  }
  if (best.found) {
    // Above the least middle and not above the greatest: no side is empty.
    const float low = range.middles.lower[best.axis];
    best.value = best.value > low ? std::min(best.value, range.middles.upper[best.axis])
                                  : range.middles.upper[best.axis];
  }
  return best;
}

/// Left is what lies below the plane. Each reference is written to both sides, and one counts.
Halves ReferenceDivider::cut(std::span<Reference> all, const PrimitiveRange& run,
                             const Plane& plane) {
  if (right_.size() < run.count) {
    right_.resize(run.count);
  }
  Reference* left = all.data() + run.first;
  Reference* right = right_.data();
  const Reference* const end = left + run.count;
  for (const Reference* from = left; from < end; ++from) {
    const Reference r = *from;
    const std::size_t side = r.middle[plane.axis] < plane.value ? 0 : 1;
    *left = r;
    *right = r;
    left += 1 - side;
    right += side;
  }
  std::copy(right_.data(), right, left);
  const auto left_count = static_cast<std::uint32_t>(run.count - (right - right_.data()));
  return {range_of(all, run.first, left_count),
          range_of(all, run.first + left_count, run.count - left_count), false};
}

/// The cheapest of all cuts between neighbors, on all axes. There are at most kSweep references.
template <class Lanes>
Halves ReferenceDivider::sweep(std::span<Reference> all, const PrimitiveRange& run) {
  const std::uint32_t n = run.count;
  const auto refs = all.subspan(run.first, n);
  std::array<Box4, kSweep> boxes;
  for (std::uint32_t i = 0; i < n; ++i) {
    boxes[i] = box_of(refs[i]);
  }
  Order best_order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  std::uint32_t best_left = n / 2;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Order order = order_of<Lanes>(refs, axis);
    std::array<float, kSweep> right;
    Box4 box;
    for (std::uint32_t i = n - 1; i > 0; --i) {
      box.grow(boxes[order[i]]);
      right[i] = box.half_area() * blocks_[n - i];
    }
    box = Box4{};
    for (std::uint32_t i = 1; i < n; ++i) {
      box.grow(boxes[order[i - 1]]);
      const float cost = box.half_area() * blocks_[i] + right[i];
      if (cost < least) {
        least = cost;
        best_left = i;
        best_order = order;
      }
    }
  }
  std::array<Reference, kSweep> sorted;
  for (std::uint32_t i = 0; i < n; ++i) {
    sorted[i] = refs[best_order[i]];
  }
  std::copy(sorted.begin(), sorted.begin() + n, refs.begin());
  return {range_of(all, run.first, best_left), range_of(all, run.first + best_left, n - best_left),
          false};
}

}  // namespace soms::detail
