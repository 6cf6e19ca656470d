/// \file
/// How near are two surfaces, and are they nearer than a clearance? Surfaces only: a body wholly
/// inside another has a distance above 0 from it.
///
/// \code
/// const soms::Body a{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const soms::Body b(a.shape, soms::Pose::translation(0, 0, 5));
/// const soms::Distance answer = soms::distance(a, b);
/// std::cout << answer.distance.lower << " apart, from " << answer.point_a << " to "
///           << answer.point_b << '\n';
/// std::cout << std::boolalpha << "farther than 2: "
///           << soms::distance(a, b, {.at_most = 2}).farther << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 3 apart, from Vec3{0, 0, 1} to Vec3{0, 0, 4}
/// farther than 2: true
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// Options of a distance query.
struct DistanceOptions {
  /// Beyond this the answer is `farther`, without a pair; infinity for no limit.
  double at_most = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool operator==(const DistanceOptions&) const = default;
};

template <>
struct Fields<DistanceOptions> {
  static constexpr const char* kName = "DistanceOptions";
  static constexpr const char* kMeaning = "Options of distance.";
  static constexpr auto kList =
      std::tuple(field("at_most", &DistanceOptions::at_most, "Beyond this the answer is farther."));
};

/// Answer of a distance query of two bodies.
struct Distance {
  /// Holds the least distance of the moved, rounded surfaces. The doubles next to it where coverage
  /// is complete and the answer is not `farther`; [0, 0] exactly where the bodies overlap;
  /// [infinity, infinity] where a mesh is empty. Where coverage is `cut`, what was proved so far.
  Bracket distance;
  /// The least (i, j) among the pairs of triangles at exactly this distance, i of the first body;
  /// nothing where a mesh is empty or the answer is `farther`. Where coverage is `cut`, the nearest
  /// pair so far, if any.
  std::optional<TrianglePair> triangles = std::nullopt;
  Vec3 point_a = {};  ///< the end of a shortest segment on the first triangle of the pair, in world
  Vec3 point_b = {};  ///< the other end, on the second
  /// The distance exceeds `at_most`: `distance.lower` is `at_most`, `distance.upper` infinity.
  bool farther = false;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Distance&) const = default;
};

/// The least distance of two surfaces, by exact decisions on the moved vertices (Pose::apply): 0
/// exactly where `overlap` finds a pair. A triangle without area is the segment or point it is.
/// The answer but for `cost` does not depend on trees, layouts, threads or instruction sets.
/// distance(b, a) has the same bracket; where several pairs are equally near it may name another.
///
/// The points are within 4 units in the last place of the largest coordinate of the pair of the
/// ends of a shortest segment. Where there are many, as between parallel faces, the middle ones are
/// named (triangle_distance.h).
///
/// \errors  ErrorKind::not_rigid, not_finite, out_of_range for a pose (checked in O(1)); usage for
///          a negative `at_most`; cancelled.
/// \cost    Typically logarithmic in the triangle counts. Equally near pairs cost time, not memory.
/// \threads Any number of callers. A query that takes long is dealt out to as many threads as
///          `limits` says; most end before that pays.
/// \source  Larsen, Gottschalk, Lin and Manocha 2000 (distance by box hierarchies), Dial 1969
///          (buckets).
[[nodiscard]] Distance distance(const Body& a, const Body& b, const DistanceOptions& options = {},
                                const Limits& limits = {});

/// Answers for a batch of poses: columns, one entry a pose, as those of `Distance`.
struct DistanceBatch {
  std::vector<double> lower;                           ///< n
  std::vector<double> upper;                           ///< n
  std::vector<std::optional<TrianglePair>> triangles;  ///< n
  std::vector<Vec3> point_a;                           ///< n
  std::vector<Vec3> point_b;                           ///< n
  std::vector<std::uint8_t> farther;                   ///< n flags, 0 or 1
  std::vector<Coverage> coverage;                      ///< n
  std::vector<Cost> costs;                             ///< n
  Cost cost;                                           ///< of all poses together

  [[nodiscard]] bool operator==(const DistanceBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return lower.size(); }

  /// The answer for a pose.
  [[nodiscard]] Distance at(std::size_t pose) const;
};

template <>
struct Fields<Distance> {
  static constexpr const char* kName = "Distance";
  static constexpr const char* kMeaning = "Answer of distance.";
  static constexpr const char* kBatchName = "DistanceBatch";
  static constexpr const char* kBatchMeaning = "Answers of distance for n poses.";
  static constexpr const char* kRows = "poses";
  using Batch = DistanceBatch;
  static constexpr auto kList = std::tuple(
      field("distance", &Distance::distance, BracketColumns<Batch>{&Batch::lower, &Batch::upper},
            "The distance"),
      field("farther", &Distance::farther, &Batch::farther, "The distance exceeds at_most."),
      field("triangles", &Distance::triangles, &Batch::triangles,
            "The least pair at this distance."),
      field("point_a", &Distance::point_a, &Batch::point_a,
            "The end of its shortest segment on a, in world.")
          .where_named(),
      field("point_b", &Distance::point_b, &Batch::point_b, "The other end, on b.").where_named(),
      coverage_field(&Distance::coverage, &Batch::coverage),
      cost_field(&Distance::cost, &Batch::costs));
};

/// `distance` of `mover` at each of `poses` to `fixed`: the answers of single queries.
///
/// \shape   `poses`: n.
/// \errors  As `distance`; a pose at fault is named by its index.
[[nodiscard]] DistanceBatch distance(const Shape& mover, std::span<const Pose> poses,
                                     const Body& fixed, const DistanceOptions& options = {},
                                     const Limits& limits = {});

}  // namespace soms
