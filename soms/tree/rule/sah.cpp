#include "soms/tree/rule/rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace soms::rule {

namespace {

constexpr std::size_t kBins = 16;

/// Boxes this much larger than the inner box have no finite area: none can be distinguished from
/// another.
constexpr double kMostSpan = 0x1p120;

/// Axes shorter than this share of the longest are left alone: their bins would overflow a float.
constexpr double kLeastShare = 0x1p-100;

/// Four lanes, of which three are the axes: loops over them become one vector instruction.
struct alignas(16) Lanes {
  std::array<float, 4> v;
};

Lanes filled(float x) {
  return {{x, x, x, x}};
}

void keep_least(Lanes& a, const Lanes& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    a.v[k] = b.v[k] < a.v[k] ? b.v[k] : a.v[k];
  }
}

void keep_greatest(Lanes& a, const Lanes& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    a.v[k] = b.v[k] > a.v[k] ? b.v[k] : a.v[k];
  }
}

/// Bounds of the primitives whose midpoints lie in a slice of the inner box.
struct Bin {
  Lanes lower = filled(std::numeric_limits<float>::infinity());
  Lanes upper = filled(-std::numeric_limits<float>::infinity());

  void grow(const Bin& other) {
    keep_least(lower, other.lower);
    keep_greatest(upper, other.upper);
  }

  [[nodiscard]] float half_area() const {
    const float x = upper.v[0] - lower.v[0];
    const float y = upper.v[1] - lower.v[1];
    const float z = upper.v[2] - lower.v[2];
    return x * y + y * z + z * x;
  }
};

/// All bins of the three axes, in units of the node: its inner box has longest side 1.
struct Histogram {
  std::array<std::array<Bin, kBins>, 3> bins;
  std::array<std::array<std::uint32_t, kBins>, 3> counts = {};
};

Histogram fill(const SplitNode& node, const Vec3& extent, double size) {
  Histogram h;
  const double to_unit = 1 / size;
  const auto span = static_cast<float>(std::min(node.unit / size, kMostSpan));
  // Midpoints at the upper end of the box fall into the last bin.
  const auto steps = [size](double e) {
    return e > size * kLeastShare
               ? static_cast<float>(static_cast<double>(kBins) * (1 - 0x1p-20) * (size / e))
               : 0;
  };
  const Lanes scale{{steps(extent.x), steps(extent.y), steps(extent.z), 0}};
  const std::array<double, 3> lower{node.inner.lower.x, node.inner.lower.y, node.inner.lower.z};
  for (const Primitive& p : node.primitives) {
    Lanes m = filled(0);
    for (std::size_t k = 0; k < 3; ++k) {
      m.v[k] = static_cast<float>((p.midpoint[k] - lower[k]) * to_unit);
    }
    Bin box;
    std::array<std::int32_t, 4> bin;
    for (std::size_t k = 0; k < 4; ++k) {
      box.lower.v[k] = m.v[k] - p.below[k] * span;
      box.upper.v[k] = m.v[k] + p.above[k] * span;
      bin[k] = static_cast<std::int32_t>(m.v[k] * scale.v[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto b = static_cast<std::size_t>(bin[k]);
      h.bins[k][b].grow(box);
      ++h.counts[k][b];
    }
  }
  return h;
}

struct Candidate {
  float cost = std::numeric_limits<float>::infinity();
  std::size_t axis = 0;
  std::size_t bin = 0;  ///< first bin of the right side; 0 when nothing was found
};

/// The cheapest boundary between bins of an axis that beats `best`; of equal ones the first.
void improve(Candidate& best, const Histogram& h, std::size_t axis, std::uint32_t total) {
  const auto& bins = h.bins[axis];
  const auto& counts = h.counts[axis];
  std::array<float, kBins> right;
  Bin box;
  std::uint32_t count = 0;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    box.grow(bins[i]);
    count += counts[i];
    right[i] = box.half_area() * static_cast<float>(count);
  }
  box = Bin{};
  count = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    box.grow(bins[i - 1]);
    count += counts[i - 1];
    const float cost = box.half_area() * static_cast<float>(count) + right[i];
    if (cost < best.cost && count > 0 && count < total) {
      best = {cost, axis, i};
    }
  }
}

}  // namespace

Split sah(const SplitNode& node, std::size_t axis) {
  const Vec3 extent = node.inner.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  if (!(size >= 0x1p-1000)) {
    return soms(node, axis);
  }
  const Histogram h = fill(node, extent, size);
  Candidate best;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (axis + k) % 3;
    if (extent[a] > size * kLeastShare) {
      improve(best, h, a, static_cast<std::uint32_t>(node.primitives.size()));
    }
  }
  // Nothing was found where boxes are so much larger than the inner box that areas overflow.
  if (best.bin == 0) {
    return soms(node, axis);
  }
  // Any plane above the least midpoint and not above the greatest leaves no side empty.
  const double lower = node.inner.lower[best.axis];
  const double upper = node.inner.upper[best.axis];
  const double share = static_cast<double>(best.bin) / static_cast<double>(kBins);
  const double value = lower + extent[best.axis] * share;
  return {best.axis, value > lower ? std::min(value, upper) : upper};
}

}  // namespace soms::rule
