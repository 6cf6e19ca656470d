/// \file
/// Who is right? Decided without any tree, before a time counts.
#pragma once

#include "soms/base/box.h"

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace soms::bench {

/// What the judge found about one library's answers to a set.
struct Verdict {
  std::size_t checked = 0;  ///< of its answers, those that the judge decided
  std::size_t wrong = 0;    ///< of these, wrong ones
  std::vector<std::size_t> wrong_questions;
};

/// Counts pairs of triangles that share a point: every pair whose boxes meet, found by a grid, is
/// decided exactly on vertices moved by Pose::apply. No tree, no filter, nothing kept from pose to
/// pose.
class PairCounter {
 public:
  PairCounter(const FloatMesh& mover, const FloatMesh& fixed);

  /// Stops at one if `any`.
  [[nodiscard]] std::uint64_t count(const Pose& pose, bool any) const;

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

  FloatMesh mover_;
  FloatMesh fixed_;
  std::vector<Box> boxes_;  // of the fixed triangles
  Box bounds_;
  double side_ = 1;
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
  std::vector<std::uint32_t> large_;  // triangles of very many cells
};

/// Judges the answers of several libraries to one set: every question on which two differ, and as
/// many others, evenly spread, as fit when `budget` triangles of the mover are looked at. A
/// library's list may be shorter than the others'.
[[nodiscard]] std::vector<Verdict> judge(const PairCounter& counter, Job job,
                                         std::span<const Pose> poses,
                                         std::span<const std::vector<std::uint64_t>> answers,
                                         double budget);

/// The same of frames of boxes: the first frame, the last, the middle one and those on which two
/// differ, counted by a sweep.
[[nodiscard]] std::vector<Verdict> judge(std::span<const std::vector<FloatBox>> frames,
                                         std::span<const std::vector<std::uint64_t>> answers);

}  // namespace soms::bench
