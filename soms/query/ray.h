/// \file
/// What does a ray, or the segment between two points, hit? Watertight, by exact decisions.
///
/// \code
/// const soms::Body ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const soms::Ray down{{0.1, 0.2, 5}, {0, 0, -1}};
/// const soms::ClosestHit first = soms::closest_hit(ball, down);
/// std::cout << "hits triangle " << *first.triangle << " at " << first.point << '\n';
/// const soms::AllHits all = soms::all_hits(ball, std::vector{down});
/// for (std::size_t k = 0; k < all.kind.size(); ++k) {
///   std::cout << all.kind[k] << " at t = " << all.lower[k] << '\n';
/// }
/// std::cout << std::boolalpha << "sees: " << soms::sees(ball, {0, 0, 5}, {3, 0, 5}) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// hits triangle 7 at Vec3{0.1, 0.2, 0.9600817648353335}
/// enter at t = 4.03992
/// leave at t = 5.96008
/// sees: true
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// The points origin + t direction for 0 <= t <= length, ends included, in exact arithmetic. The
/// direction need not have unit length: t and `length` count in units of it.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double length = std::numeric_limits<double>::infinity();
  /// Where it is set, the ray is the segment from `origin` to this point, kept exactly: t is 1 at
  /// `end`, and `direction` and `length` play no part.
  std::optional<Vec3> end = std::nullopt;

  /// The segment from `from` to `to`, both included. If both are equal, it is that point.
  [[nodiscard]] static Ray between(const Vec3& from, const Vec3& to) {
    return {from, to - from, 1, to};
  }

  [[nodiscard]] bool operator==(const Ray&) const = default;
};

/// Options of queries of rays.
struct RayOptions {
  /// Takes no part: the triangle that a reflected ray starts on, say.
  std::optional<TriangleId> skip = std::nullopt;

  [[nodiscard]] bool operator==(const RayOptions&) const = default;
};

template <>
struct Fields<RayOptions> {
  static constexpr const char* kName = "RayOptions";
  static constexpr const char* kMeaning = "Options of queries of rays.";
  static constexpr auto kList =
      std::tuple(field("skip", &RayOptions::skip, "A triangle that takes no part."));
};

/// The first point of a surface on a ray. Where coverage is `cut`: of what was looked at so far.
struct ClosestHit {
  /// Holds the least t at which the ray meets the moved, rounded surface: the doubles next to it,
  /// or twice the same where it is a double. [infinity, infinity] where nothing is hit.
  Bracket t = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  /// The least number among the triangles met at exactly this t; nothing where nothing is hit.
  std::optional<TriangleId> triangle = std::nullopt;
  Vec3 point = {};  ///< where, in world: each coordinate the exact one, rounded to nearest
  /// The ray meets the side from which the triangle is seen counterclockwise. False where the ray
  /// lies in the triangle's plane, and for a triangle without area.
  bool front = false;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const ClosestHit&) const = default;
};

/// The first point of the surface on a ray, by exact decisions on the moved vertices (Pose::apply).
/// Triangles are closed sets: a ray through a shared edge or corner hits the triangles that share
/// it, and none slips between them. A triangle without area is the segment or point it is; one in
/// whose plane the ray lies is hit where the ray enters it. A surface point at t = 0 counts, unless
/// its triangle is skipped. The answer but for `cost` does not depend on trees, layouts, threads or
/// instruction sets.
///
/// \errors  ErrorKind::not_finite, out_of_range unless the origin is finite and within 2^300 and
///          the direction finite. ErrorKind::usage for a direction of zero, for a length that is
///          negative or not a number, and for a skipped triangle that the mesh does not have. Those
///          of the pose as for `overlap`.
/// \cost    Typically logarithmic in the number of triangles. `Cost::node_tests` counts boxes,
///          `triangle_tests` triangles, `exact_tests` those that needed exact arithmetic.
/// \threads Any number of callers; a query takes one thread.
/// \source  Woop, Benthin and Wald 2013 (watertight tests by edge functions).
[[nodiscard]] ClosestHit closest_hit(const Body& body, const Ray& ray,
                                     const RayOptions& options = {}, const Limits& limits = {});

/// Answers for a batch of rays: columns, one entry each, as those of `ClosestHit`.
struct ClosestHitBatch {
  std::vector<double> lower;                        ///< n, of t
  std::vector<double> upper;                        ///< n, of t
  std::vector<std::optional<TriangleId>> triangle;  ///< n
  std::vector<Vec3> point;                          ///< n
  std::vector<std::uint8_t> front;                  ///< n flags, 0 or 1
  std::vector<Coverage> coverage;                   ///< n
  std::vector<Cost> costs;                          ///< n
  Cost cost;                                        ///< of all together

  [[nodiscard]] bool operator==(const ClosestHitBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return lower.size(); }

  /// The answer for a ray.
  [[nodiscard]] ClosestHit at(std::size_t ray) const;
};

template <>
struct Fields<ClosestHit> {
  static constexpr const char* kName = "ClosestHit";
  static constexpr const char* kMeaning = "Answer of closest_hit for a ray.";
  static constexpr const char* kBatchName = "ClosestHitBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest_hit for n rays.";
  static constexpr const char* kRows = "rays";
  using Batch = ClosestHitBatch;
  static constexpr std::array kCounted{Counted<ClosestHit>{
      [](const ClosestHit& answer) { return answer.triangle.has_value(); }, "hit", "hits"}};
  static constexpr auto kList = std::tuple(
      field("t", &ClosestHit::t, BracketColumns<Batch>{&Batch::lower, &Batch::upper},
            "The least t, infinity where nothing is hit,"),
      field("triangle", &ClosestHit::triangle, &Batch::triangle,
            "The least triangle met at this t."),
      field("point", &ClosestHit::point, &Batch::point, "Where, in world.").where_named(),
      field("front", &ClosestHit::front, &Batch::front, "The ray meets the front of the triangle.")
          .where_named(),
      coverage_field(&ClosestHit::coverage, &Batch::coverage),
      cost_field(&ClosestHit::cost, &Batch::costs));
};

/// `closest_hit` of each of `rays`: the answers of single queries.
///
/// \shape   `rays`: n.
/// \errors  As `closest_hit`; a ray at fault is named by its index. Also ErrorKind::cancelled.
/// \threads As many as `limits` says share the rays.
[[nodiscard]] ClosestHitBatch closest_hit(const Body& body, std::span<const Ray> rays,
                                          const RayOptions& options = {},
                                          const Limits& limits = {});

/// Whether a ray hits anything at all.
struct AnyHit {
  /// Where coverage is `cut`, false means that it is not known.
  bool hit = false;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const AnyHit&) const = default;
};

/// True where `closest_hit` has a triangle; ends at the first one found. \errors As `closest_hit`.
[[nodiscard]] AnyHit any_hit(const Body& body, const Ray& ray, const RayOptions& options = {},
                             const Limits& limits = {});

/// Answers for a batch: columns, one entry a ray, as those of `AnyHit`.
struct AnyHitBatch {
  std::vector<std::uint8_t> hit;   ///< n flags, 0 or 1
  std::vector<Coverage> coverage;  ///< n
  std::vector<Cost> costs;         ///< n
  Cost cost;                       ///< of all together

  [[nodiscard]] bool operator==(const AnyHitBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return hit.size(); }

  /// The answer for a ray.
  [[nodiscard]] AnyHit at(std::size_t ray) const;
};

template <>
struct Fields<AnyHit> {
  static constexpr const char* kName = "AnyHit";
  static constexpr const char* kMeaning = "Answer of any_hit for a ray.";
  static constexpr const char* kBatchName = "AnyHitBatch";
  static constexpr const char* kBatchMeaning = "Answers of any_hit for n rays.";
  static constexpr const char* kRows = "rays";
  using Batch = AnyHitBatch;
  static constexpr std::array kCounted{
      Counted<AnyHit>{[](const AnyHit& answer) { return answer.hit; }, "hit", "hits"}};
  static constexpr auto kTruth = &AnyHit::hit;
  static constexpr auto kList =
      std::tuple(field("hit", &AnyHit::hit, &Batch::hit, "The ray hits something."),
                 coverage_field(&AnyHit::coverage, &Batch::coverage),
                 cost_field(&AnyHit::cost, &Batch::costs));
};

/// `any_hit` of each of `rays`. \shape `rays`: n. \errors As the batch of `closest_hit`.
[[nodiscard]] AnyHitBatch any_hit(const Body& body, std::span<const Ray> rays,
                                  const RayOptions& options = {}, const Limits& limits = {});

/// True if nothing of the surface is on the segment from `a` to `b`, ends included: a line of sight
/// between two points that are not on the surface.
/// \errors As `any_hit`.
[[nodiscard]] bool sees(const Body& body, const Vec3& a, const Vec3& b);

/// How a ray passes a place of the surface.
enum class CrossingKind : unsigned char {
  enter,  ///< through, by more front sides than back sides: into what faces outward
  leave,  ///< through, by more back sides
  graze,  ///< touches, and stays on its side; or passes an even number of sheets in one place
};

template <>
inline constexpr auto kWords<CrossingKind> = words("CrossingKind",
                                                   "How a ray passes a place of the surface.",
                                                   "enter", "leave", "graze");

/// All places where rays meet a surface: rows of any length, one a ray. Triangles that a ray meets
/// at exactly the same t and that are connected there are one crossing: the two on an edge, the fan
/// around a corner. They are connected by the corner, edge or face that holds the point, if it has
/// the same moved corners in both, by position; and by what connects others.
struct AllHits {
  std::vector<std::uint64_t> offsets = {0};  ///< n + 1: row i is [offsets[i], offsets[i + 1])
  std::vector<double> lower;                 ///< m, of t, as in ClosestHit; rows sorted by exact t
  std::vector<double> upper;                 ///< m
  std::vector<CrossingKind> kind;            ///< m
  std::vector<std::uint64_t> triangle_offsets = {0};  ///< m + 1
  std::vector<TriangleId> triangle;                   ///< of all crossings, ascending within each
  std::vector<Coverage> coverage;  ///< n. `cut`: the row has what was found so far.
  std::vector<Cost> costs;         ///< n
  Cost cost;                       ///< of all rays together

  [[nodiscard]] bool operator==(const AllHits&) const = default;

  /// The number of rays.
  [[nodiscard]] std::size_t size() const { return coverage.size(); }
};

template <>
struct Fields<AllHits> {
  static constexpr const char* kName = "AllHits";
  static constexpr const char* kMeaning = "All places where n rays meet a surface.";
  static constexpr auto kList = std::tuple(
      list("offsets", &AllHits::offsets, "n + 1",
           "Ray i has the crossings offsets[i] to offsets[i + 1]."),
      list("lower", &AllHits::lower, "m", "The t of each crossing is at least this."),
      list("upper", &AllHits::upper, "m", "The t of each crossing is at most this."),
      list("kind", &AllHits::kind, "m", "How the ray passes there."),
      list("triangle_offsets", &AllHits::triangle_offsets, "m + 1",
           "Crossing j has the triangles triangle_offsets[j] to triangle_offsets[j + 1]."),
      list("triangle", &AllHits::triangle, "k", "Triangles of all crossings."),
      list("coverage", &AllHits::coverage, "n", "How much of the question is decided."),
      list("costs", &AllHits::costs, "n", "Work done."),
      field("cost", &AllHits::cost, "Work done for all rays together."));
};

/// Every triangle that `rays` meet, each at the least t of its points on the ray. Crossings of one
/// ray at the same t are in the order of their least triangles.
///
/// The kind follows from a ray beside the given one, shifted by (e, e^2, e^3) for an infinitesimal
/// e so that it meets no edge and no corner. It is `graze` if that ray crosses an even number of
/// the crossing's triangles, else `enter` or `leave` by the sides that it meets. It is local:
/// neither the surface's being closed nor the ray's length matters. Triangles parallel to the ray
/// do not count for it.
///
/// \shape   `rays`: n.
/// \errors  As the batch of `closest_hit`.
/// \cost    O(k log k) decisions for k triangles found, and their memory.
/// \source  Edelsbrunner and Muecke 1990, Simulation of Simplicity, section 4.
[[nodiscard]] AllHits all_hits(const Body& body, std::span<const Ray> rays,
                               const RayOptions& options = {}, const Limits& limits = {});

}  // namespace soms
