/// \file
/// Every pair of parts that touches at any pose, and of each a fair sample of triangles.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/overlap.h"

#include "apps/soms/pairs/overlap_parts.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace soms::command {

/// Collects answers pose by pose. Memory grows with the pairs of parts that touch, not with pairs
/// of triangles or poses: of those a bounded sample is kept, in which each pair of parts has about
/// the same share, evenly spread over all of its pairs of triangles.
class OverlapRows {
 public:
  using Poses = std::pair<Pose, Pose>;

  /// A pair of triangles that was kept.
  struct Sample {
    std::uint64_t pose = 0;
    TrianglePair pair;
  };

  /// Two parts that touch.
  struct Row {
    std::uint32_t part_a = Part::kNoParent;
    std::uint32_t part_b = Part::kNoParent;
    std::uint64_t count = 0;  ///< pairs of triangles, of all poses
    std::uint64_t poses = 0;  ///< at which they touch
    std::uint64_t begin = 0;  ///< the first of them
    std::uint64_t end = 0;    ///< the last
    TrianglePair first = {};  ///< the least at pose `begin`
    Box box = {};             ///< holds every point where they touch
    std::vector<Sample> samples = {};
    std::uint64_t pause = 1;  ///< every so many pairs are kept; 0: none
  };

  /// Meshes must stay. Keeps at most `most` pairs of triangles; the first of each row is among them
  /// while there are at most so many rows.
  OverlapRows(const MeshView& a, const MeshView& b, std::size_t most);

  /// The pairs of parts of an answer, their boxes grown from those of the rows so far.
  /// \errors ErrorKind::cancelled.
  [[nodiscard]] std::vector<PartPair> parts(const Poses& poses, std::span<const TrianglePair> pairs,
                                            const Limits& limits) const;

  /// Adds the pairs of a pose, and the pairs of parts that these make, from `parts` or
  /// `part_pairs`; poses come in ascending order.
  void add(std::uint64_t pose, const Poses& poses, std::span<const TrianglePair> pairs,
           std::span<const PartPair> parts);

  /// In the order in which they first touched.
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// Poses of all samples, and perhaps of some that were dropped.
  [[nodiscard]] const std::map<std::uint64_t, Poses>& placed() const { return placed_; }

  /// Samples of all rows.
  [[nodiscard]] std::size_t held() const { return held_; }

 private:
  void begin_rows(std::uint64_t pose, std::span<const PartPair> parts);
  bool keep(Row& row, std::uint64_t pose, const TrianglePair& pair);
  void halve(Row& row);
  void thin_out();
  void drop_unused_poses();

  MeshView a_;
  MeshView b_;
  PartsOf parts_a_;
  PartsOf parts_b_;
  std::size_t most_;
  std::size_t share_;  ///< most samples of a row
  std::size_t held_ = 0;
  std::vector<Row> rows_;
  std::unordered_map<std::uint64_t, std::size_t> numbers_;  ///< of rows, by their parts
  std::map<std::uint64_t, Poses> placed_;
};

}  // namespace soms::command
