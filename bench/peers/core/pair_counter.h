/// \file
/// Which triangles of two posed meshes share a point? Decided without any tree, before a time
/// counts.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace soms::bench {

/// Counts pairs of triangles that share a point: every pair whose boxes meet, found by a grid, is
/// decided exactly on vertices moved by Pose::apply. No tree, no filter, nothing kept from pose to
/// pose.
class PairCounter {
 public:
  PairCounter(const FloatMesh& mover, const FloatMesh& fixed);

  /// Stops at one if `any`.
  [[nodiscard]] std::uint64_t count(const Pose& pose, bool any) const;

  /// Triangles of the mover and of the fixed body that share a point.
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  [[nodiscard]] std::vector<Pair> pairs(const Pose& pose) const;

  [[nodiscard]] std::size_t mover_triangles() const { return mover_.triangles.size(); }

 private:
  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };

  struct CellHash {
    std::size_t operator()(const Cell& c) const;
  };

  [[nodiscard]] Cell cell_of(const Vec3& p) const;

  template <class Visit>
  void each_cell(const Box& box, const Visit& visit) const;

  [[nodiscard]] std::vector<std::uint32_t> candidates(const Box& box) const;

  /// Shows each pair to `visit` until it returns false.
  template <class Visit>
  void each_pair(const Pose& pose, const Visit& visit) const;

  FloatMesh mover_;
  FloatMesh fixed_;
  std::vector<Box> boxes_;  // of the fixed triangles
  Box bounds_;
  double side_ = 1;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
  std::vector<std::uint32_t> large_;  // triangles of very many cells
};

}  // namespace soms::bench
