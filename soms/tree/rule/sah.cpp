#include "soms/tree/rule/rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace soms::rule {

namespace {

constexpr std::size_t kBins = 16;

struct Bin {
  Box bounds;
  std::uint32_t count = 0;
};

/// Maps midpoints to bins, monotonically: 0 at the lower end of the inner box, 15 at the upper.
struct Binning {
  double lower = 0;
  double scale = 0;

  [[nodiscard]] std::size_t operator()(double m) const {
    const auto bin = static_cast<std::size_t>((m - lower) * scale);
    return bin < kBins ? bin : kBins - 1;
  }
};

struct Candidate {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t axis = 0;
  std::size_t bin = 0;  ///< first bin of the right side
};

/// Nothing where the axis has no extent, or one so small that its inverse overflows.
std::optional<Binning> binning(const Box& inner, std::size_t axis) {
  const double scale = static_cast<double>(kBins) / (inner.upper[axis] - inner.lower[axis]);
  if (!std::isfinite(scale)) {
    return std::nullopt;
  }
  return Binning{inner.lower[axis], scale};
}

/// The inverse of the node's size, as a power of two; 1 for a point.
double unit_of(const Box& box) {
  const Vec3 e = box.extent();
  const double size = std::max({e.x, e.y, e.z});
  return size > 0 ? std::ldexp(1.0, std::min(-std::ilogb(size), 1000)) : 1;
}

/// Half the area of a box in units in which the node measures about 1, so that the areas of tiny
/// nodes do not underflow and become alike.
double scaled_area(const Box& box, double unit) {
  const Vec3 e = box.extent() * unit;
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// The cheapest boundary between bins; of equal ones the first.
Candidate cheapest(const std::array<Bin, kBins>& bins, std::size_t axis, double unit) {
  std::array<double, kBins> right{};
  Box box;
  std::uint32_t count = 0;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    box.grow(bins[i].bounds);
    count += bins[i].count;
    right[i] = count == 0 ? 0 : scaled_area(box, unit) * count;
  }
  Candidate best;
  const std::uint32_t total = count + bins[0].count;
  box = Box{};
  count = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    box.grow(bins[i - 1].bounds);
    count += bins[i - 1].count;
    if (count == 0 || count == total) {
      continue;
    }
    const double cost = scaled_area(box, unit) * count + right[i];
    if (cost < best.cost) {
      best = {cost, axis, i};
    }
  }
  return best;
}

}  // namespace

Split sah(const SplitNode& node, std::size_t axis) {
  const double unit = unit_of(node.outer);
  Candidate best;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (axis + k) % 3;
    const auto bin = binning(node.inner, a);
    if (!bin) {
      continue;
    }
    std::array<Bin, kBins> bins;
    for (const Primitive& p : node.primitives) {
      Bin& b = bins[(*bin)(p.midpoint[a])];
      b.bounds.grow(p.bounds);
      ++b.count;
    }
    const Candidate candidate = cheapest(bins, a, unit);
    if (candidate.cost < best.cost) {
      best = candidate;
    }
  }
  if (best.bin == 0) {
    return soms(node, axis);
  }
  // The least midpoint of the right side makes the split a plane.
  const auto bin = binning(node.inner, best.axis);
  double value = node.inner.upper[best.axis];
  for (const Primitive& p : node.primitives) {
    const double m = p.midpoint[best.axis];
    if (m < value && (*bin)(m) >= best.bin) {
      value = m;
    }
  }
  return {best.axis, value};
}

}  // namespace soms::rule
