/// \file
/// Where is a surface nearest to a point? Which of its triangles are near?
///
/// \code
/// const soms::Body ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const soms::Closest answer = soms::closest(ball, {0, 0, 4});
/// std::cout << "nearest: " << answer.point << ", " << answer.distance.lower << " away\n";
/// const std::vector<soms::Vec3> points{{0, 0, 4}, {0, 0, 9}};
/// const soms::ClosestBatch batch = soms::closest(ball, points, {.at_most = 5});
/// std::cout << "farther than 5: " << int{batch.farther[0]} << ", " << int{batch.farther[1]}
///           << '\n';
/// const soms::NearTriangles near = soms::near_triangles(ball, points, 3.01);
/// std::cout << near.offsets[1] << " triangles are at most 3.01 from the first point\n";
/// \endcode
/// It prints:
/// \verbatim
/// nearest: Vec3{0, 0, 1}, 3 away
/// farther than 5: 0, 1
/// 20 triangles are at most 3.01 from the first point
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/geometry/point_distance.h"
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

/// Options of queries of points.
struct ClosestOptions {
  /// Triangles beyond this are left out; infinity for no limit.
  double at_most = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool operator==(const ClosestOptions&) const = default;
};

template <>
struct Fields<ClosestOptions> {
  static constexpr const char* kName = "ClosestOptions";
  static constexpr const char* kMeaning = "Options of queries of points.";
  static constexpr auto kList =
      std::tuple(field("at_most", &ClosestOptions::at_most, "Triangles beyond this are left out."));
};

/// The nearest point of a body.
struct Closest {
  /// Holds the least distance of the point from the moved, rounded surface. The doubles next to it
  /// where coverage is complete and the answer is not `farther`. [0, 0] exactly where the point is
  /// on the surface; [infinity, infinity] where the mesh is empty. Where coverage is `cut`, what
  /// was proved so far.
  Bracket distance;
  /// The least number among the triangles at exactly this distance; nothing where the mesh is empty
  /// or the answer is `farther`. Where coverage is `cut`, the nearest triangle so far, if any.
  std::optional<TriangleId> triangle = std::nullopt;
  Vec3 point = {};                                    ///< the nearest point of it, in world
  TriangleFeature feature = TriangleFeature::vertex;  ///< where on the triangle that lies
  /// The distance exceeds `at_most`: `distance.lower` is `at_most`, `distance.upper` infinity.
  /// False for an empty mesh, which is infinitely far from everything.
  bool farther = false;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Closest&) const = default;
};

/// The nearest point of a surface to `point`, by exact decisions on the moved vertices
/// (Pose::apply). A triangle without area is the segment or point it is. The distance is that of
/// the surface: a point inside a closed body has a distance above 0, too. The answer but for
/// `cost` does not depend on trees, layouts, threads or instruction sets.
///
/// Each coordinate of the nearest point is the exact one rounded to the nearest double, ties to
/// even. `feature` is that of the exact point: `edge` where it is on an edge of the named triangle.
///
/// \errors  ErrorKind::not_finite, out_of_range for the point; those and not_rigid for the pose;
///          usage for a negative `at_most`; cancelled.
/// \cost    Typically logarithmic in the number of triangles. Equally near triangles cost time, not
///          memory. `Cost::node_tests` counts boxes bounded, `triangle_tests` triangles bounded.
/// \threads Any number of callers; a query takes one thread.
/// \source  Roussopoulos, Kelley and Vincent 1995 (nearest neighbors by a tree of boxes); Ericson
///          2004, 5.1.5 (point and triangle).
[[nodiscard]] Closest closest(const Body& body, const Vec3& point,
                              const ClosestOptions& options = {}, const Limits& limits = {});

/// Answers for a batch of points: columns, one entry a point, as those of `Closest`.
struct ClosestBatch {
  std::vector<double> lower;                        ///< n
  std::vector<double> upper;                        ///< n
  std::vector<std::optional<TriangleId>> triangle;  ///< n
  std::vector<Vec3> point;                          ///< n
  std::vector<TriangleFeature> feature;             ///< n
  std::vector<std::uint8_t> farther;                ///< n flags, 0 or 1
  std::vector<Coverage> coverage;                   ///< n
  std::vector<Cost> costs;                          ///< n
  Cost cost;                                        ///< of all points together

  [[nodiscard]] bool operator==(const ClosestBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return lower.size(); }

  /// The answer for a point.
  [[nodiscard]] Closest at(std::size_t point) const;
};

template <>
struct Fields<Closest> {
  static constexpr const char* kName = "Closest";
  static constexpr const char* kMeaning = "Answer of closest for a point.";
  static constexpr const char* kBatchName = "ClosestBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest for n points.";
  static constexpr const char* kRows = "points";
  using Batch = ClosestBatch;
  static constexpr auto kList = std::tuple(
      field("distance", &Closest::distance, BracketColumns<Batch>{&Batch::lower, &Batch::upper},
            "The distance"),
      field("farther", &Closest::farther, &Batch::farther, "The distance exceeds at_most."),
      field("triangle", &Closest::triangle, &Batch::triangle,
            "The least triangle at this distance."),
      field("point", &Closest::point, &Batch::point, "The nearest point, in world.").where_named(),
      field("feature", &Closest::feature, &Batch::feature, "Where on the triangle that lies.")
          .where_named(),
      coverage_field(&Closest::coverage, &Batch::coverage),
      cost_field(&Closest::cost, &Batch::costs));
};

/// `closest` of each of `points`: the answers and costs of single queries.
///
/// \shape   `points`: n.
/// \errors  As `closest`; a point at fault is named by its index.
/// \threads As many as `limits` says share the points.
[[nodiscard]] ClosestBatch closest(const Body& body, std::span<const Vec3> points,
                                   const ClosestOptions& options = {}, const Limits& limits = {});

/// Triangles near points: rows of any length, one a point.
struct NearTriangles {
  std::vector<std::uint64_t> offsets = {0};  ///< n + 1: row i is [offsets[i], offsets[i + 1])
  std::vector<TriangleId> triangle;          ///< of all rows, each by distance, then by number
  std::vector<double> lower;                 ///< the distance is between this
  std::vector<double> upper;                 ///< and this: the doubles next to it
  /// n. `cut`: the row has what was found so far; others may be nearer. What the deadline left
  /// undecided has wider bounds, and is in their order.
  std::vector<Coverage> coverage;
  std::vector<Cost> costs;  ///< n
  Cost cost;                ///< of all points together

  [[nodiscard]] bool operator==(const NearTriangles&) const = default;

  /// The number of points.
  [[nodiscard]] std::size_t size() const { return coverage.size(); }
};

template <>
struct Fields<NearTriangles> {
  static constexpr const char* kName = "NearTriangles";
  static constexpr const char* kMeaning = "Triangles near each of n points.";
  static constexpr auto kOffsets = &NearTriangles::offsets;
  static constexpr auto kValues = &NearTriangles::triangle;
  static constexpr auto kList = std::tuple(
      list("offsets", &NearTriangles::offsets, "n + 1",
           "Point i has the triangles offsets[i] to offsets[i + 1]."),
      list("triangle", &NearTriangles::triangle, "k", "The triangles of all points."),
      list("lower", &NearTriangles::lower, "k", "The distance is at least this."),
      list("upper", &NearTriangles::upper, "k", "The distance is at most this."),
      list("coverage", &NearTriangles::coverage, "n", "How much of the question is decided."),
      list("costs", &NearTriangles::costs, "n", "Work done."),
      field("cost", &NearTriangles::cost, "Work done for all points together."));
};

/// The `count` nearest triangles of each of `points`, or as many as there are within `at_most`:
/// in the order of their exact distances, equally near ones by number.
///
/// \shape   `points`: n.
/// \errors  As `closest`; a point at fault is named by its index.
/// \cost    As `closest`, and O(log count) decisions for each triangle that is a candidate.
/// \threads As many as `limits` says share the points.
[[nodiscard]] NearTriangles nearest_triangles(const Body& body, std::span<const Vec3> points,
                                              std::size_t count, const ClosestOptions& options = {},
                                              const Limits& limits = {});

/// All triangles of which some point is at most `radius` from a point, decided exactly, for each of
/// `points`; in the order of `nearest_triangles`. Radius 0 asks for triangles that a point is on.
///
/// \shape   `points`: n.
/// \errors  As `nearest_triangles`; ErrorKind::usage for a radius that is negative or not a number.
/// \cost    O(k log k) decisions for k triangles found. Until its row is sorted, each takes some
///          300 bytes, and a hundred more if it is exactly as near as another, by another corner.
/// \threads As `nearest_triangles`.
[[nodiscard]] NearTriangles near_triangles(const Body& body, std::span<const Vec3> points,
                                           double radius, const ClosestOptions& options = {},
                                           const Limits& limits = {});

}  // namespace soms
