/// \file
/// Which of many bodies is nearest to a point, and which does a ray hit first?
///
/// \code
/// const soms::Shape ball{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const std::vector<soms::Body> bodies{soms::Body(ball, soms::Pose::translation(5, 0, 0)),
///                                      soms::Body(ball, soms::Pose::translation(0, 0, 3))};
/// const soms::BodyIndex index(bodies);
/// const soms::BodyClosest near = index.closest({0, 0, 0});
/// std::cout << "body " << *near.body << " is nearest, " << near.distance.lower << " away\n";
/// const soms::BodyHit hit = index.closest_hit(soms::Ray{{0, 0, 0}, {1, 0, 0}});
/// std::cout << "body " << *hit.body << " is hit first, at t = " << hit.t.lower << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// body 1 is nearest, 2 away
/// body 0 is hit first, at t = 4.01519
/// \endverbatim
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/query/body.h"
#include "soms/query/closest.h"
#include "soms/query/ray.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// The nearest point of many bodies: the answer of `closest` for the nearest one. It is `farther`
/// where all of them are, and the bracket is [infinity, infinity] where none has a triangle.
struct BodyClosest : Closest {
  /// Which body: the least number among the bodies at exactly this distance. Nothing where no
  /// triangle is named.
  std::optional<std::uint32_t> body = std::nullopt;

  [[nodiscard]] bool operator==(const BodyClosest&) const = default;
};

/// Answers for a batch of points: the columns of ClosestBatch, and the bodies.
struct BodyClosestBatch : ClosestBatch {
  std::vector<std::optional<std::uint32_t>> body;  ///< n

  [[nodiscard]] bool operator==(const BodyClosestBatch&) const = default;

  /// The answer for a point.
  [[nodiscard]] BodyClosest at(std::size_t point) const;
};

template <>
struct Fields<BodyClosest> {
  static constexpr const char* kName = "BodyClosest";
  static constexpr const char* kMeaning = "Answer of closest about a BodyIndex.";
  static constexpr const char* kBatchName = "BodyClosestBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest about a BodyIndex.";
  static constexpr const char* kRows = "points";
  using Base = Closest;
  using Batch = BodyClosestBatch;
  static constexpr auto kList =
      std::tuple(field("body", &BodyClosest::body, &Batch::body, "Which body it is."));
};

/// The first hit of a ray on many bodies: the answer of `closest_hit` for the body that is hit
/// first.
struct BodyHit : ClosestHit {
  /// Which body: the least number among the bodies hit at exactly this t. Nothing where nothing is
  /// hit.
  std::optional<std::uint32_t> body = std::nullopt;

  [[nodiscard]] bool operator==(const BodyHit&) const = default;
};

/// Answers for a batch of rays: the columns of ClosestHitBatch, and the bodies.
struct BodyHitBatch : ClosestHitBatch {
  std::vector<std::optional<std::uint32_t>> body;  ///< n

  [[nodiscard]] bool operator==(const BodyHitBatch&) const = default;

  /// The answer for a ray.
  [[nodiscard]] BodyHit at(std::size_t ray) const;
};

template <>
struct Fields<BodyHit> {
  static constexpr const char* kName = "BodyHit";
  static constexpr const char* kMeaning = "Answer of closest_hit about a BodyIndex.";
  static constexpr const char* kBatchName = "BodyHitBatch";
  static constexpr const char* kBatchMeaning = "Answers of closest_hit about a BodyIndex.";
  static constexpr const char* kRows = "rays";
  using Base = ClosestHit;
  using Batch = BodyHitBatch;
  static constexpr auto kList =
      std::tuple(field("body", &BodyHit::body, &Batch::body, "Which body it is."));
};

/// All places where rays meet many bodies: the columns of AllHits, and the bodies. A crossing is of
/// one body.
struct BodyAllHits : AllHits {
  std::vector<std::uint32_t> body = {};  ///< m

  [[nodiscard]] bool operator==(const BodyAllHits&) const = default;
};

template <>
struct Fields<BodyAllHits> {
  static constexpr const char* kName = "BodyAllHits";
  static constexpr const char* kMeaning = "All places where n rays meet many bodies.";
  using Base = AllHits;
  static constexpr auto kList =
      std::tuple(list("body", &BodyAllHits::body, "m", "The body of each crossing."));
};

/// Which bodies take part in a query of many.
struct BodyFilter {
  /// This body does not: the one that looks, say. With RayOptions::skip, which is then a triangle
  /// of this body, only that triangle does not: the one that a reflected ray starts on.
  std::optional<std::uint32_t> except = std::nullopt;

  [[nodiscard]] bool operator==(const BodyFilter&) const = default;
};

/// Bodies at rest, and an index of their world boxes. Immutable; copies share everything. Queries
/// see all bodies as one surface whose triangles are named by body and triangle: their answers are
/// the nearest ones of the queries of single bodies, by exact comparison. Equally near ones are
/// decided by the number of the body, then by that of the triangle. Answers but for `cost` do not
/// depend on trees, layouts, threads or instruction sets.
///
/// \errors  As the queries of bodies that have the same names; a point or ray at fault is named by
///          its index. ErrorKind::usage for a body that is not there, and for RayOptions::skip
///          without BodyFilter::except.
/// \cost    Typically logarithmic in the number of bodies, and one query for each body whose box is
///          no farther than what is nearest. `Cost::node_tests` counts boxes of bodies, too.
/// \threads Any number of callers; batches are shared by as many threads as `Limits` says.
/// \source  Roussopoulos, Kelley and Vincent 1995 (nearest neighbors by a tree of boxes).
class BodyIndex {
 public:
  /// No bodies.
  BodyIndex();

  /// Copies the bodies; shapes are shared. Their numbers are their places. A body without triangles
  /// keeps its number and is never met.
  /// \errors  As `overlap` for a pose, with the body named.
  /// \cost    O(n log n), n bodies.
  explicit BodyIndex(std::span<const Body> bodies);

  /// The number of bodies.
  [[nodiscard]] std::size_t size() const;

  /// \errors ErrorKind::usage for a body that is not there.
  [[nodiscard]] const Body& body(std::uint32_t number) const;

  /// Bytes held, shapes and names not counted.
  [[nodiscard]] std::size_t memory() const;

  /// The nearest point of all bodies. Where coverage is `cut`, `triangle` is the nearest so far, if
  /// any, and the bracket's lower end is what was proved of all bodies.
  [[nodiscard]] BodyClosest closest(const Vec3& point, const ClosestOptions& options = {},
                                    const BodyFilter& filter = {}, const Limits& limits = {}) const;
  /// \shape `points`: n.
  [[nodiscard]] BodyClosestBatch closest(std::span<const Vec3> points,
                                         const ClosestOptions& options = {},
                                         const BodyFilter& filter = {},
                                         const Limits& limits = {}) const;

  /// The first point of all bodies on a ray. Where coverage is `cut`, `triangle` is the
  /// first so far, if any, and the bracket's lower end is what was proved of all bodies.
  [[nodiscard]] BodyHit closest_hit(const Ray& ray, const RayOptions& options = {},
                                    const BodyFilter& filter = {}, const Limits& limits = {}) const;
  /// \shape `rays`: n.
  [[nodiscard]] BodyHitBatch closest_hit(std::span<const Ray> rays, const RayOptions& options = {},
                                         const BodyFilter& filter = {},
                                         const Limits& limits = {}) const;

  /// Whether a ray hits any body.
  [[nodiscard]] AnyHit any_hit(const Ray& ray, const RayOptions& options = {},
                               const BodyFilter& filter = {}, const Limits& limits = {}) const;
  /// \shape `rays`: n.
  [[nodiscard]] AnyHitBatch any_hit(std::span<const Ray> rays, const RayOptions& options = {},
                                    const BodyFilter& filter = {}, const Limits& limits = {}) const;

  /// Every triangle of all bodies that rays meet: for each body the crossings that
  /// `all_hits` has. Rows are sorted by exact t, crossings at the same t by body, then by their
  /// least triangles.
  /// \shape `rays`: n.
  /// \cost    One query for each body whose box a ray meets. O(k log k) comparisons for k
  ///          crossings, exact ones where two bodies are met at nearly the same t; their memory.
  [[nodiscard]] BodyAllHits all_hits(std::span<const Ray> rays, const RayOptions& options = {},
                                     const BodyFilter& filter = {},
                                     const Limits& limits = {}) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

}  // namespace soms
