/// \file
/// Which triangles of two bodies share a point? Surfaces only: a body wholly inside another
/// overlaps nothing of it.
///
/// \code
/// const soms::Body fixed{soms::generate_sphere(320)};  // of radius 1, about the origin
/// soms::Body moved = fixed;
/// for (const double x : {1.0, 2.5}) {
///   moved.pose = soms::Pose::translation(x, 0, 0);
///   const soms::Overlap answer = soms::overlap(moved, fixed);
///   std::cout << "at " << x << ": " << answer.pairs.size() << " pairs of triangles touch\n";
/// }
/// const std::vector<soms::Pose> poses{moved.pose, soms::Pose::translation(0, 1, 0)};
/// const soms::OverlapBatch batch =
///     soms::overlap(fixed.shape, poses, fixed, {.mode = soms::OverlapMode::any});
/// std::cout << "any: " << int{batch.any[0]} << ' ' << int{batch.any[1]} << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// at 1: 114 pairs of triangles touch
/// at 2.5: 0 pairs of triangles touch
/// any: 0 1
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// How much of an overlap is wanted.
enum class OverlapMode {
  all,    ///< every pair, sorted
  any,    ///< stop at the first pair found; which one is not promised
  first,  ///< the least pair by (i, j)
};

template <>
inline constexpr auto kWords<OverlapMode> =
    words("OverlapMode", "Which pairs an overlap lists: all, some one, or the least.", "all", "any",
          "first");

/// Options of an overlap query.
struct OverlapOptions {
  OverlapMode mode = OverlapMode::all;
  /// Most pairs returned; more are cut, and the answer says so. The first found by one thread.
  /// With modes `any` and `first`, which return one pair at most, 0 alone has an effect, and any
  /// other limit is ErrorKind::usage.
  std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();

  [[nodiscard]] bool operator==(const OverlapOptions&) const = default;
};

template <>
struct Fields<OverlapOptions> {
  static constexpr const char* kName = "OverlapOptions";
  static constexpr const char* kMeaning = "Options of overlap.";
  static constexpr auto kList =
      std::tuple(field("mode", &OverlapOptions::mode, "Which pairs are listed."),
                 field("limit", &OverlapOptions::limit, "Most pairs returned.").where_given());
};

/// Answer of an overlap query of two bodies.
struct Overlap {
  bool any = false;
  std::vector<TrianglePair> pairs;  ///< sorted by first, then second; one pair in modes any, first
  Coverage coverage = Coverage::complete;
  Cost cost;

  [[nodiscard]] bool operator==(const Overlap&) const = default;

  /// FNV-1a 64 over the sorted pairs as little-endian u32: two runs agree when their hashes do.
  [[nodiscard]] std::uint64_t hash() const;
};

template <>
struct Fields<Overlap> {
  static constexpr const char* kName = "Overlap";
  static constexpr const char* kMeaning = "Answer of overlap.";
  static constexpr auto kTruth = &Overlap::any;
  static constexpr auto kList =
      std::tuple(field("any", &Overlap::any, "Some pair of triangles shares a point."),
                 list("pairs", &Overlap::pairs, "k",
                      "Triangle of a, triangle of b; sorted. One pair in modes any, first."),
                 field("coverage", &Overlap::coverage, "How much of the question is decided."),
                 field("cost", &Overlap::cost, "Work done."));
};

/// Pairs of triangles of `a` and `b` that share at least one point, decided exactly on the moved
/// vertices (Pose::apply). Touching counts; a triangle without area is the segment or point it is.
/// Symmetric: overlap(b, a) has the columns swapped. An empty mesh overlaps nothing.
///
/// Surfaces only: a car wholly inside a closed hall does not overlap its walls.
///
/// \errors  ErrorKind::not_rigid, not_finite, out_of_range for a pose (checked in O(1)); usage for
///          a `limit` without effect; cancelled.
/// \cost    Typically logarithmic in the triangle counts plus linear in the answer.
/// \threads Any number of callers; `limits` splits one query, but for mode `first` and where
/// there
///          is a limit.
[[nodiscard]] Overlap overlap(const Body& a, const Body& b, const OverlapOptions& options = {},
                              const Limits& limits = {});

/// Answers for a batch of poses: arrays, one entry a pose, pairs as values and offsets.
struct OverlapBatch {
  std::vector<std::uint8_t> any;       ///< n flags, 0 or 1
  std::vector<Coverage> coverage;      ///< n
  std::vector<std::uint64_t> offsets;  ///< n + 1; pairs of pose k are [offsets[k], offsets[k+1])
  std::vector<TrianglePair> pairs;     ///< in modes any and first: the pair found, if any
  std::vector<Cost> costs;             ///< n
  Cost cost;                           ///< of all poses together

  [[nodiscard]] bool operator==(const OverlapBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return any.size(); }

  [[nodiscard]] std::span<const TrianglePair> pairs_of(std::size_t pose) const {
    return std::span(pairs).subspan(offsets[pose], offsets[pose + 1] - offsets[pose]);
  }

  /// The answer for a pose.
  [[nodiscard]] Overlap at(std::size_t pose) const;
};

template <>
struct Fields<OverlapBatch> {
  static constexpr const char* kName = "OverlapBatch";
  static constexpr const char* kMeaning = "Answers of overlap for n poses.";
  static constexpr auto kOffsets = &OverlapBatch::offsets;
  static constexpr auto kValues = &OverlapBatch::pairs;
  static constexpr auto kList = std::tuple(
      list("any", &OverlapBatch::any, "n", "Some pair of triangles shares a point."),
      list("offsets", &OverlapBatch::offsets, "n + 1",
           "Pose i has the pairs offsets[i] to offsets[i + 1]."),
      list("pairs", &OverlapBatch::pairs, "k", "The pairs of all poses."),
      list("coverage", &OverlapBatch::coverage, "n", "How much of the question is decided."),
      list("costs", &OverlapBatch::costs, "n", "Work done."),
      field("cost", &OverlapBatch::cost, "Work done for all poses together."));
};

/// `overlap` of `mover` at each of `poses` with `fixed`; answers and costs equal those of single
/// queries on one thread, whatever the batch and the number of threads. `limit` counts for each
/// pose.
///
/// \shape   `poses`: n; the answer's arrays are described there.
/// \errors  As `overlap`; a pose at fault is named by its index.
[[nodiscard]] OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses,
                                   const Body& fixed, const OverlapOptions& options = {},
                                   const Limits& limits = {});

}  // namespace soms
