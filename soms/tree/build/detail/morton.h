/// \file
/// Triangles in the order of a space-filling curve that sets large ones apart.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/layout/detail/pages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms::detail {

/// A Morton code in the upper bits and a triangle's number in the lower ones: no two are equal.
using MortonKey = std::uint64_t;

/// Codes of triangles by their boxes' middles. Each bit halves a cell across its longest side, so
/// that a run of codes with a common prefix is a cell of a k-d tree. Where the longest side of
/// cells has halved, a bit says first whether the triangle is small against the cell: large ones
/// go to the left as a whole.
///
/// \source Morton 1966; Vinkler et al. 2017, Extended Morton codes for high performance bounding
///         volume hierarchy construction (axes by length, bits for sizes).
class MortonCodes {
 public:
  /// For `count` middles in `box`, with triangle numbers of `id_bits`.
  MortonCodes(const Box& box, std::size_t count, int id_bits);

  [[nodiscard]] MortonKey key(const MeshView& mesh, TriangleId id) const;

  /// Bits of a code; 0 if all middles are as one.
  [[nodiscard]] int bits() const { return bits_; }

 private:
  static constexpr int kMostAxisBits = 24;
  static constexpr int kMostSizes = 16;
  using Spread = std::array<std::array<MortonKey, 256>, kMostAxisBits / 8>;

  void place_bits(Vec3 sides, int budget, int sizes);
  void fill_tables(std::size_t axis, std::span<const int> places);

  Vec3 lower_;
  Vec3 scale_;                                ///< to whole steps on each axis
  std::array<double, 3> last_ = {};           ///< the last step
  std::array<Spread, 3> spread_;              ///< where bits of each byte of an axis go
  std::array<double, kMostSizes> most_ = {};  ///< extent of what is small, by size
  std::array<MortonKey, kMostSizes + 1> small_ = {};
  int size_count_ = 0;
  int bits_ = 0;
};

/// Bits that numbers below `count` need.
[[nodiscard]] int id_bits_for(std::size_t count);

/// Sorts by all bits from `first_bit` up to `end_bit`; equal ones stay as they lie. The same for
/// any number of threads. `spare` is as long.
void radix_sort(layout::Pages<MortonKey>& keys, layout::Pages<MortonKey>& spare, int first_bit,
                int end_bit, const Limits& limits);

/// Keys of all triangles of a mesh whose bounds are `box`, in order.
[[nodiscard]] layout::Pages<MortonKey> sorted_keys(const MeshView& mesh, const Box& box,
                                                   const Limits& limits);

/// Gives a run of keys new codes, relative to the box of its own middles, and sorts it. False if
/// these are all one, and nothing was done.
[[nodiscard]] bool refine_keys(const MeshView& mesh, std::span<MortonKey> run, int id_bits);

}  // namespace soms::detail
