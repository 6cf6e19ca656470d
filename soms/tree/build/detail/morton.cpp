#include "soms/tree/build/detail/morton.h"

#include "soms/base/box.h"
#include "soms/base/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

/// Digits of 11 bits: their counts fit the first cache.
constexpr int kDigit = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigit;

/// Sides below are as none: what scales them to steps would be endless.
constexpr double kLeastSide = 0x1p-960;

/// Triangles longer than this share of a cell are large.
constexpr double kLargeShare = 0.5;

/// Cells of fewer than 2^6 triangles, if these covered a surface evenly, are not divided by size.
constexpr int kLeastDividedBySize = 6;

/// Bits beyond those that tell evenly spread triangles of a surface from each other.
constexpr int kSpareBits = 6;

double longest(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

struct Middle {
  Vec3 twice;  ///< lower and upper corner together
  double extent;
};

Middle middle_of(const MeshView& mesh, TriangleId id) {
  const auto& corners = mesh.triangles[id];
  const Vec3& a = mesh.vertices[corners[0]];
  const Vec3& b = mesh.vertices[corners[1]];
  const Vec3& c = mesh.vertices[corners[2]];
  Middle m;
  m.extent = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double ab_low = a[k] < b[k] ? a[k] : b[k];
    const double ab_high = a[k] < b[k] ? b[k] : a[k];
    const double lower = ab_low < c[k] ? ab_low : c[k];
    const double upper = ab_high < c[k] ? c[k] : ab_high;
    const double extent = upper - lower;
    m.twice[k] = lower + upper;
    m.extent = m.extent < extent ? extent : m.extent;
  }
  return m;
}

}  // namespace

int id_bits_for(std::size_t count) {
  return static_cast<int>(std::bit_width(count - 1));
}

MortonCodes::MortonCodes(const Box& box, std::size_t count, int id_bits) : lower_(2 * box.lower) {
  const int doublings = static_cast<int>(std::bit_width(count)) - 1;
  const int sizes = std::clamp((doublings - kLeastDividedBySize) / 2, 0, kMostSizes);
  const int budget = 3 * (doublings + 1) / 2 + kSpareBits + sizes;
  place_bits(box.extent(), std::min(budget, 64 - id_bits), sizes);
}

void MortonCodes::place_bits(Vec3 sides, int budget, int sizes) {
  const Vec3 extent = sides;
  const double size = longest(sides);
  std::array<std::array<int, kMostAxisBits>, 3> places;  // by bit of the step, highest first
  std::array<int, 3> used = {};
  double next_size = size;
  int place = 63;
  const int last = 64 - budget;
  while (place >= last) {
    std::size_t axis = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      if (used[k] < kMostAxisBits && sides[k] > kLeastSide &&
          (axis == 3 || sides[k] > sides[axis])) {
        axis = k;
      }
    }
    if (axis == 3) {
      break;
    }
    if (size_count_ < sizes && sides[axis] <= next_size) {
      most_[static_cast<std::size_t>(size_count_)] = kLargeShare * next_size;
      const auto s = static_cast<std::size_t>(++size_count_);
      small_[s] = small_[s - 1] | MortonKey{1} << place--;
      next_size *= 0.5;
      continue;
    }
    places[axis][static_cast<std::size_t>(used[axis]++)] = place--;
    sides[axis] *= 0.5;
  }
  bits_ = 63 - place;
  for (std::size_t k = 0; k < 3; ++k) {
    const double steps = std::ldexp(1.0, used[k]);
    // Middles come as twice themselves.
    scale_[k] = used[k] > 0 ? 0.5 * steps / extent[k] : 0;
    last_[k] = steps - 1;
    fill_tables(k, std::span(places[k]).first(static_cast<std::size_t>(used[k])));
  }
}

void MortonCodes::fill_tables(std::size_t axis, std::span<const int> places) {
  for (std::size_t byte = 0; byte < spread_[axis].size(); ++byte) {
    auto& table = spread_[axis][byte];
    table[0] = 0;
    for (std::size_t bit = 0; bit < 8; ++bit) {
      const std::size_t from_low = 8 * byte + bit;
      const MortonKey own =
          from_low < places.size() ? MortonKey{1} << places[places.size() - 1 - from_low] : 0;
      for (std::size_t value = 0; value < std::size_t{1} << bit; ++value) {
        table[(std::size_t{1} << bit) + value] = table[value] | own;
      }
    }
  }
}

MortonKey MortonCodes::key(const MeshView& mesh, TriangleId id) const {
  const Middle middle = middle_of(mesh, id);
  MortonKey code = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = (middle.twice[k] - lower_[k]) * scale_[k];
    const auto step = static_cast<std::uint32_t>(
        static_cast<std::int32_t>(at > 0 ? (at < last_[k] ? at : last_[k]) : 0));
    code |= spread_[k][0][step & 255] | spread_[k][1][step >> 8 & 255] | spread_[k][2][step >> 16];
  }
  std::size_t small = 0;
  for (int s = 0; s < size_count_; ++s) {
    small += static_cast<std::size_t>(middle.extent <= most_[static_cast<std::size_t>(s)]);
  }
  return code | small_[small] | id;
}

void radix_sort(layout::Pages<MortonKey>& keys, layout::Pages<MortonKey>& spare, int first_bit,
                int end_bit, const Limits& limits) {
  const std::size_t count = keys.size();
  // A few large chunks, each with a table of its own.
  const std::size_t size = std::max<std::size_t>((count + 7) / 8, 1);
  std::vector<std::array<std::uint32_t, kDigits>> places((count - 1) / size + 1);
  for (int bit = first_bit; bit < end_bit; bit += kDigit) {
    const MortonKey mask = (MortonKey{1} << std::min(kDigit, end_bit - bit)) - 1;
    for_each_chunk(count, size, limits, [&](std::size_t begin, std::size_t end) {
      auto& counts = places[begin / size];
      counts.fill(0);
      for (std::size_t i = begin; i < end; ++i) {
        ++counts[keys[i] >> bit & mask];
      }
    });
    std::uint32_t next = 0;
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
      for (auto& place : places) {
        const std::uint32_t n = place[digit];
        place[digit] = next;
        next += n;
      }
    }
    for_each_chunk(count, size, limits, [&](std::size_t begin, std::size_t end) {
      auto& place = places[begin / size];
      for (std::size_t i = begin; i < end; ++i) {
        const MortonKey key = keys[i];
        spare[place[key >> bit & mask]++] = key;
      }
    });
    keys.swap(spare);
  }
}

layout::Pages<MortonKey> sorted_keys(const MeshView& mesh, const Box& box, const Limits& limits) {
  constexpr std::size_t kCodesPerTask = 32768;
  const std::size_t count = mesh.triangles.size();
  const MortonCodes codes(box, count, id_bits_for(count));
  layout::Pages<MortonKey> keys;
  layout::Pages<MortonKey> spare;
  keys.resize(count);
  for_each_chunk(count, kCodesPerTask, limits, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      keys[i] = codes.key(mesh, static_cast<TriangleId>(i));
    }
  });
  spare.resize(count);
  radix_sort(keys, spare, 64 - codes.bits(), 64, limits);
  return keys;
}

bool refine_keys(const MeshView& mesh, std::span<MortonKey> run, int id_bits) {
  const MortonKey ids = (MortonKey{1} << id_bits) - 1;
  Box box;
  for (const MortonKey key : run) {
    box.grow(0.5 * middle_of(mesh, static_cast<TriangleId>(key & ids)).twice);
  }
  const MortonCodes codes(box, run.size(), id_bits);
  if (codes.bits() == 0) {
    return false;
  }
  for (MortonKey& key : run) {
    key = codes.key(mesh, static_cast<TriangleId>(key & ids));
  }
  std::sort(run.begin(), run.end());
  return (run.front() ^ run.back()) >> id_bits != 0;
}

}  // namespace soms::detail
