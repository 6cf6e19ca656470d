/// \file
/// Where is the surface of a closed body nearest to a point, and on which side of it is the point?
///
/// \code
/// const soms::ClosedBody ball{soms::Body{soms::generate_sphere(320)}};  // of radius 1
/// for (const double z : {0.75, 1.0, 1.25}) {
///   const soms::SignedClosest answer = soms::closest(ball, {0, 0, z});
///   std::cout << "z = " << z << ": " << answer.side << ", " << answer.distance().upper << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// z = 0.75: inside, -0.246109
/// z = 1: on, 0
/// z = 1.25: outside, 0.25
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"

#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// The nearest point of a closed body, and the side.
struct SignedClosest {
  Closest closest;              ///< its `cost` is that of both
  Side side = Side::undecided;  ///< as `contains` has it: `on` exactly where the distance is 0

  /// Holds the signed distance: that of the surface, below 0 inside. Symmetric about 0 where the
  /// side is undecided.
  [[nodiscard]] Bracket distance() const;

  [[nodiscard]] bool operator==(const SignedClosest&) const = default;
};

/// `closest` and `contains` in one call. The sign is a decision of its own, by parity: never a
/// guess from a normal or a winding number.
///
/// \errors  As `closest`.
/// \cost    That of both.
/// \threads As `closest`.
[[nodiscard]] SignedClosest closest(const ClosedBody& body, const Vec3& point,
                                    const ClosestOptions& options = {}, const Limits& limits = {});

/// Answers for a batch of points, one entry a point.
struct SignedClosestBatch {
  ClosestBatch closest;    ///< its `costs` and `cost` are those of both
  std::vector<Side> side;  ///< n

  [[nodiscard]] bool operator==(const SignedClosestBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return side.size(); }

  /// The answer for a point.
  [[nodiscard]] SignedClosest at(std::size_t point) const;
};

template <>
struct Fields<SignedClosest> {
  static constexpr const char* kName = "SignedClosest";
  static constexpr const char* kMeaning = "Answer of closest for a point and a ClosedBody.";
  static constexpr const char* kBatchName = "SignedClosestBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest for n points and a ClosedBody.";
  static constexpr const char* kRows = "points";
  using Batch = SignedClosestBatch;
  static constexpr auto kList = std::tuple(
      field("closest", &SignedClosest::closest, &Batch::closest,
            "The nearest point of the surface."),
      field("side", &SignedClosest::side, &Batch::side, "Where the point lies, as contains says."));
};

/// The same for each of `points`: the answers and costs of single queries.
///
/// \shape   `points`: n.
/// \errors  As the batch of `closest`.
/// \threads As many as `limits` says share the points.
[[nodiscard]] SignedClosestBatch closest(const ClosedBody& body, std::span<const Vec3> points,
                                         const ClosestOptions& options = {},
                                         const Limits& limits = {});

}  // namespace soms
