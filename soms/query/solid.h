/// \file
/// How do two closed bodies stand to each other: apart, touching, one in the other? Decided
/// exactly.
///
/// \code
/// const soms::Body large{soms::generate_sphere(320)};  // of radius 1, about the origin
/// soms::Mesh mesh = soms::generate_sphere(320);
/// for (soms::Vec3& vertex : mesh.vertices) {
///   vertex = vertex * 0.25;
/// }
/// for (const double z : {0.0, 1.0, 2.0}) {
///   const soms::Body small(soms::Shape(mesh), soms::Pose::translation(0, 0, z));
///   std::cout << "at " << z << ": " << soms::solid(small, large).relation << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// at 0: a_in_b
/// at 1: crossing
/// at 2: clear
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// The relation of the bodies a and b: of the sets of points that their surfaces bound.
enum class Relation : unsigned char {
  clear,      ///< nothing is shared
  touching,   ///< surfaces meet, and no interior is shared
  crossing,   ///< interior is shared, and each has interior outside the other
  a_in_b,     ///< the interior of a lies in that of b, which has more
  b_in_a,     ///< the interior of b lies in that of a, which has more
  same,       ///< the interiors are equal
  undecided,  ///< see Undecided
};

template <>
inline constexpr auto kWords<Relation> = words("Relation",
                                               "How two closed bodies stand to each other.",
                                               "clear", "touching", "crossing", "a_in_b", "b_in_a",
                                               "same", "undecided");

/// Why a relation is undecided.
enum class Undecided : unsigned char {
  none,      ///< it is decided
  deadline,  ///< the deadline passed first
  open,      ///< a T-junction of the mover opens where this pose rounds it
};

template <>
inline constexpr auto kWords<Undecided> = words("Undecided", "Why a relation is undecided.", "none",
                                                "deadline", "open");

/// Answer of `solid`.
struct Solid {
  Relation relation = Relation::undecided;
  /// Triangles of the two overlap, as `overlap` says: those of touching and same bodies always do,
  /// of clear ones never. Crossing ones of several parts may not, and a body in the other may.
  /// False where the deadline passed before it was known.
  bool surfaces_meet = false;
  Undecided why = Undecided::none;
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Solid&) const = default;
};

/// The relation of two closed bodies, by exact decisions on the moved vertices (Pose::apply). A
/// point is inside a body where a ray in general position from it crosses an odd number of
/// triangles, as `contains` says. So orientation plays no part, voids are outside, and the interior
/// is all that is not within a surface. A triangle that bounds nothing, as a doubled one, is still
/// a part of the surface: bodies may touch with it. A body without interior is in no other: `clear`
/// or `touching`; so is an empty mesh.
///
/// solid(b, a) is the same with a_in_b and b_in_a exchanged. The answer but for `cost` does not
/// depend on trees, layouts, threads or instruction sets, nor on how a surface is cut into
/// triangles.
///
/// \errors  ErrorKind::cancelled.
/// \cost    Where surfaces do not meet or cross plainly, that of `overlap` with mode `any` and of
///          one `contains` for each connected part. Where they touch or have faces in a plane, of
///          the order of 0.1 ms for each triangle that takes part, also where thousands meet one.
///          More where they cross each other in it. `cost.exact_tests` counts triangles that exact
///          arithmetic looked at.
/// \threads Any number of callers.
/// \source  Edelsbrunner and Muecke 1990, Simulation of Simplicity, section 4, for points on lines.
[[nodiscard]] Solid solid(const ClosedBody& a, const ClosedBody& b, const Limits& limits = {});

/// The same of bodies that are checked first, each time. \errors As `ClosedBody`, too.
[[nodiscard]] Solid solid(const Body& a, const Body& b, const Limits& limits = {});

/// Answers for a batch of poses: columns, one entry a pose, as those of `Solid`.
struct SolidBatch {
  std::vector<Relation> relation;           ///< n
  std::vector<std::uint8_t> surfaces_meet;  ///< n flags, 0 or 1
  std::vector<Undecided> why;               ///< n
  std::vector<Coverage> coverage;           ///< n
  std::vector<Cost> costs;                  ///< n
  Cost cost;                                ///< of all poses together

  [[nodiscard]] bool operator==(const SolidBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return relation.size(); }

  /// The answer for a pose.
  [[nodiscard]] Solid at(std::size_t pose) const;
};

template <>
struct Fields<Solid> {
  static constexpr const char* kName = "Solid";
  static constexpr const char* kMeaning = "Answer of solid.";
  static constexpr const char* kBatchName = "SolidBatch";
  static constexpr const char* kBatchMeaning = "Answers of solid for n poses.";
  static constexpr const char* kRows = "poses";
  using Batch = SolidBatch;
  static constexpr std::array kCounted{Counted<Solid>{
      [](const Solid& answer) { return answer.relation == Relation::clear; }, "clear"}};
  static constexpr auto kList = std::tuple(
      field("relation", &Solid::relation, &Batch::relation, "How the bodies stand to each other."),
      field("surfaces_meet", &Solid::surfaces_meet, &Batch::surfaces_meet,
            "Triangles of the two overlap."),
      field("why", &Solid::why, &Batch::why, "Why the relation is undecided."),
      coverage_field(&Solid::coverage, &Batch::coverage), cost_field(&Solid::cost, &Batch::costs));
};

/// `solid` of `mover` at each of `poses`, in place of its own, and `fixed`: the answers of single
/// queries. But a pose at which the mover is not closed (`ClosedBody::at`) is `undecided`.
///
/// \shape   `poses`: n.
/// \errors  As `overlap`; a pose at fault is named by its index.
[[nodiscard]] SolidBatch solid(const ClosedBody& mover, std::span<const Pose> poses,
                               const ClosedBody& fixed, const Limits& limits = {});

/// The same of bodies that are checked first, the mover where it was built.
/// \errors As `ClosedBody`, too.
[[nodiscard]] SolidBatch solid(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                               const Limits& limits = {});

}  // namespace soms
