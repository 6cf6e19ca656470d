/// \file
/// Which triangles of one mesh cross each other or touch, beyond the corners that they share?
///
/// \code
/// const soms::Mesh knot = soms::generate_knot(2000);
/// std::cout << "crosses itself: " << soms::self_overlap(soms::Shape(knot)).any << '\n';
/// soms::Mesh folded;
/// folded.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 1, 0}};
/// folded.triangles = {{0, 1, 2}, {0, 1, 3}, {2, 1, 0}};
/// const soms::SelfOverlap answer = soms::self_overlap(soms::Shape(folded));
/// std::cout << answer.pairs[0] << ", " << answer.pairs[1] << '\n'
///           << "the same corners: " << answer.duplicates[0] << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// crosses itself: 0
/// TrianglePair{a: 0, b: 1}, TrianglePair{a: 1, b: 2}
/// the same corners: TrianglePair{a: 0, b: 2}
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/overlap.h"
#include "soms/tree/shape.h"

#include <cstdint>
#include <tuple>
#include <vector>

namespace soms {

/// Which corners two triangles have in common.
enum class CommonCorners {
  index,     ///< those of one vertex
  position,  ///< those in one place, as of files that repeat vertices; -0 equals 0
};

template <>
inline constexpr auto kWords<CommonCorners> =
    words("CommonCorners",
          "Which corners two triangles have in common: those of one vertex, or those in one place.",
          "index", "position");

/// Options of self_overlap.
struct SelfOverlapOptions {
  CommonCorners by = CommonCorners::index;
  OverlapMode mode = OverlapMode::all;
  /// Most pairs returned, as in OverlapOptions; of duplicates too.
  std::uint64_t limit = OverlapOptions{}.limit;

  [[nodiscard]] bool operator==(const SelfOverlapOptions&) const = default;
};

template <>
struct Fields<SelfOverlapOptions> {
  static constexpr const char* kName = "SelfOverlapOptions";
  static constexpr const char* kMeaning = "Options of self_overlap.";
  static constexpr auto kList = std::tuple(
      field("by", &SelfOverlapOptions::by, "Which corners two triangles have in common."),
      field("mode", &SelfOverlapOptions::mode, "Which pairs are listed."),
      field("limit", &SelfOverlapOptions::limit, "Most pairs returned.").where_given());
};

/// Answer of self_overlap: pairs of triangles, the lesser first.
struct SelfOverlap {
  bool any = false;
  std::vector<TrianglePair> pairs;       ///< sorted; one pair in modes any, first
  std::vector<TrianglePair> duplicates;  ///< pairs with the same corners, sorted; in mode all alone
  Coverage coverage = Coverage::complete;
  Cost cost;

  [[nodiscard]] bool operator==(const SelfOverlap&) const = default;
};

template <>
struct Fields<SelfOverlap> {
  static constexpr const char* kName = "SelfOverlap";
  static constexpr const char* kMeaning = "Answer of self_overlap.";
  static constexpr auto kTruth = &SelfOverlap::any;
  static constexpr auto kList = std::tuple(
      field("any", &SelfOverlap::any, "Some pair of triangles shares more than corners."),
      list("pairs", &SelfOverlap::pairs, "k",
           "Two triangles, the lesser first; sorted. One pair in modes any, first."),
      list("duplicates", &SelfOverlap::duplicates, "m",
           "Two triangles with the same corners; sorted. In mode all alone."),
      field("coverage", &SelfOverlap::coverage, "How much of the question is decided."),
      field("cost", &SelfOverlap::cost, "Work done."));
};

/// Pairs of triangles of a mesh that share a point outside the convex hull of their common corners:
/// neighbors that fold onto each other, and any others that touch. Decided exactly on the mesh's
/// own vertices. A triangle without area is the segment or point that it is; a corner
/// that a triangle names twice counts once. Triangles with the same corners are listed apart, as
/// duplicates. A pose would change nothing.
///
/// \errors  ErrorKind::usage for a `limit` without effect; cancelled.
/// \cost    Typically linear in the number of triangles plus the answer; quadratic in the triangles
///          around one vertex, and in those with the same corners. By position, O(n) more on one
///          thread, which no deadline ends.
/// \threads Any number of callers; `limits` splits one query, but for mode `first` and where there
///          is a limit.
/// \source  The meaning of CGAL's `self_intersections`, for triangles without area, too.
[[nodiscard]] SelfOverlap self_overlap(const Shape& shape, const SelfOverlapOptions& options = {},
                                       const Limits& limits = {});

}  // namespace soms
