/// \file
/// Is a point inside a closed body? Decided exactly, whatever way the triangles face.
///
/// \code
/// const soms::ClosedBody ball{soms::Body{soms::generate_sphere(320)}};  // of radius 1
/// for (const double z : {0.5, 1.0, 1.5}) {
///   std::cout << "z = " << z << ": " << soms::contains(ball, {0, 0, z}).side << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// z = 0.5: inside
/// z = 1: on
/// z = 1.5: outside
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

class ClosedBody;

namespace detail {
struct ClosedSurface;
[[nodiscard]] const ClosedSurface& surface_of(const ClosedBody& body);
[[nodiscard]] ClosedBody closed_body(Body body, std::shared_ptr<const ClosedSurface> surface);
}  // namespace detail

/// Where a point lies.
enum class Side : unsigned char {
  outside,
  inside,
  on,         ///< a point of the surface: of a closed triangle, without area too
  undecided,  ///< the deadline passed before it was decided
};

template <>
inline constexpr auto kWords<Side> = words("Side", "Where a point lies.", "outside", "inside", "on",
                                           "undecided");

/// A body whose surface was found to be closed where its pose moves it. Checked once, queried
/// often: a value; copies share what was found.
class ClosedBody {
 public:
  /// Checks that the moved, rounded surface is closed, as `closedness` decides it.
  /// \errors  ErrorKind::not_closed, which counts the odd edges and names the first; not_rigid,
  ///          not_finite, out_of_range for the pose; cancelled.
  /// \cost    O(n) time, as `closedness` of the whole mesh. Keeps the odd edges, of which most
  ///          closed meshes have none, and for each triangle its connected part, if there are
  ///          several.
  explicit ClosedBody(Body body, const Limits& limits = {});

  [[nodiscard]] const Body& body() const { return body_; }

  /// The same body at another pose.
  /// \errors  As the constructor: a body with a T-junction may be closed at one pose and, by the
  ///          rounding of its vertices, open at another.
  /// \cost    O(k log k) for k odd edges.
  [[nodiscard]] ClosedBody at(const Pose& pose) const;

  [[nodiscard]] bool operator==(const ClosedBody& other) const { return body_ == other.body_; }

 private:
  friend const detail::ClosedSurface& detail::surface_of(const ClosedBody& body);
  friend ClosedBody detail::closed_body(Body body,
                                        std::shared_ptr<const detail::ClosedSurface> surface);

  ClosedBody(Body body, std::shared_ptr<const detail::ClosedSurface> surface);

  void check_closed() const;

  Body body_;
  std::shared_ptr<const detail::ClosedSurface> surface_;
};

/// Answer of `contains` for a point.
struct Contains {
  Side side = Side::undecided;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Contains&) const = default;
};

/// On which side of a closed surface a point lies, by exact decisions on the moved vertices
/// (Pose::apply). It is `on` if it is a point of a triangle, else `inside` where a ray in general
/// position from it crosses an odd number of triangles. Orientation plays no part; where closed
/// surfaces are nested or overlap, each crossing changes sides, so a void in a solid is outside,
/// and doubled triangles cancel. The answer but for `cost` does not depend on trees, layouts,
/// threads or instruction sets.
///
/// \errors  ErrorKind::not_finite, out_of_range unless the point is finite and within 2^300.
/// \cost    Typically a microsecond and less: a ray through the tree. `cost.triangle_tests` counts
///          triangles of the leaves that it meets, `exact_tests` those that needed exact
///          arithmetic.
/// \threads Any number of callers.
/// \source  Edelsbrunner and Muecke 1990, Simulation of Simplicity, section 4.
[[nodiscard]] Contains contains(const ClosedBody& body, const Vec3& point,
                                const Limits& limits = {});

/// Answers for a batch of points: columns, one entry a point, as those of `Contains`.
struct ContainsBatch {
  std::vector<Side> side;          ///< n; `undecided` where the deadline passed first
  std::vector<Coverage> coverage;  ///< n; `cut` where it did
  std::vector<Cost> costs;         ///< n
  Cost cost;                       ///< of all points together

  [[nodiscard]] bool operator==(const ContainsBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return side.size(); }

  /// The answer for a point.
  [[nodiscard]] Contains at(std::size_t point) const;
};

template <>
struct Fields<Contains> {
  static constexpr const char* kName = "Contains";
  static constexpr const char* kMeaning = "Answer of contains for a point.";
  static constexpr const char* kBatchName = "ContainsBatch";
  static constexpr const char* kBatchMeaning = "Answers of contains for n points.";
  static constexpr const char* kRows = "points";
  using Batch = ContainsBatch;
  static constexpr std::array kCounted{
      Counted<Contains>{[](const Contains& answer) { return answer.side == Side::inside; },
                        "inside"},
      Counted<Contains>{[](const Contains& answer) { return answer.side == Side::on; },
                        "on the surface"}};
  static constexpr auto kCoverage = &Batch::coverage;
  static constexpr auto kList =
      std::tuple(field("side", &Contains::side, &Batch::side, "Where the point lies."),
                 coverage_field(&Contains::coverage, &Batch::coverage),
                 cost_field(&Contains::cost, &Batch::costs));
};

/// `contains` for each of `points`: the answers of single queries; with the wide layout
/// about four times as fast.
///
/// \shape   `points`: n.
/// \errors  As `contains`; a point at fault is named by its index, before any is answered. Also
///          ErrorKind::cancelled.
[[nodiscard]] ContainsBatch contains(const ClosedBody& body, std::span<const Vec3> points,
                                     const Limits& limits = {});

/// The same of a body that is checked first. \errors As `ClosedBody` and `contains`.
[[nodiscard]] ContainsBatch contains(const Body& body, std::span<const Vec3> points,
                                     const Limits& limits = {});

}  // namespace soms
