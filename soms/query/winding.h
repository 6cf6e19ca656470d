/// \file
/// Is a point inside a body that may be open? By its winding number, as a proved bracket.
///
/// \code
/// soms::Mesh mesh = soms::generate_sphere(320);  // of radius 1
/// mesh.triangles.resize(mesh.triangles.size() - 20);  // a hole at one of the poles
/// mesh.parts.clear();
/// const soms::WindingIndex open{soms::Body{mesh}};
/// std::cout << open.boundary_edges() << " edges of holes\n";
/// for (const double z : {-0.5, 0.0, 1.5}) {
///   const soms::Winding answer = soms::winding(open, {0, 0, z});
///   std::cout << "z = " << z << ": " << answer.side << ", " << answer.number.lower << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// 22 edges of holes
/// z = -0.5: inside, 0.979953
/// z = 0: inside, 0.957014
/// z = 1.5: outside, 0.0251191
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

class WindingIndex;

namespace detail {
class WindingTree;
[[nodiscard]] const WindingTree& tree_of(const WindingIndex& index);
}  // namespace detail

/// A body, and what its winding numbers are made of: the boundary of its triangles, and their
/// moments where that is long. Made once, queried often: a value; copies share what was made.
class WindingIndex {
 public:
  /// \errors  ErrorKind::not_rigid, not_finite, out_of_range for the pose; cancelled.
  /// \cost    O(n log n). Keeps 4 bytes a vertex and 60 an edge of the boundary. If that is longer
  ///          than 64 + 4 sqrt(n) edges, O(n log^2 n) and up to about 150 bytes a triangle.
  explicit WindingIndex(Body body, const Limits& limits = {});

  [[nodiscard]] const Body& body() const { return body_; }

  /// Edges of the boundary: directed edges that no neighbor uses the other way, each as often as
  /// that is so. 0 if the surface is closed and all its triangles face the same way: then each
  /// winding number is an integer.
  [[nodiscard]] std::uint64_t boundary_edges() const;

  /// Bytes held beside the body.
  [[nodiscard]] std::size_t memory() const;

  [[nodiscard]] bool operator==(const WindingIndex& other) const { return body_ == other.body_; }

 private:
  friend const detail::WindingTree& detail::tree_of(const WindingIndex& index);

  Body body_;
  std::shared_ptr<const detail::WindingTree> tree_;
};

/// Options of `winding`.
struct WindingOptions {
  /// By how much triangles that are far may widen the bracket, as they are taken together; 0: not
  /// at all.
  double width = 1e-9;

  [[nodiscard]] bool operator==(const WindingOptions&) const = default;
};

template <>
struct Fields<WindingOptions> {
  static constexpr const char* kName = "WindingOptions";
  static constexpr const char* kMeaning = "Options of winding.";
  static constexpr auto kList =
      std::tuple(field("width", &WindingOptions::width,
                       "By how much triangles that are far may widen the bracket."));
};

/// Answer of `winding` for a point.
struct Winding {
  /// `on`, decided exactly, if the point is a point of a triangle. Else `inside` if the number is
  /// surely above 1/2, `outside` if surely below. `undecided` if the bracket holds 1/2, or the
  /// deadline passed.
  Side side = Side::undecided;
  /// Holds the winding number. For a point of the surface, where the number jumps, it holds the
  /// numbers on both sides: each triangle that the point is on counts for -1/2 to 1/2. All numbers
  /// if the deadline passed.
  Bracket number = {};
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Winding&) const = default;
};

/// The generalized winding number of a point: the solid angles under which it sees the body's moved
/// triangles (Pose::apply), over 4 pi. They are positive for triangles that turn their backs to it.
/// Any triangles have one. For closed surfaces that face outward it is how many of them the point
/// is in. Where surfaces have holes, it changes gradually from 1 inside to 0 outside. Triangles
/// must face the same way, unlike for `contains`.
///
/// The bracket is proved, rounding included. Beside `width`, it is some 1e-14 for each boundary
/// edge near the point, and 1e-12 for those next to it. More and more is left open nearer to an
/// edge than 1e-17 of its length. If there is no boundary, it is the integer. The answer does not
/// depend on the shape's tree and layout, on threads or instruction sets, but for `cost`.
///
/// \errors  ErrorKind::not_finite, out_of_range unless the point is finite and within 2^300; usage
///          unless `width` is 0 to 1.
/// \cost    As `contains`, and a few square roots for each boundary edge; if the boundary is long,
/// only
///          for those near the point. `cost.triangle_tests` counts boundary edges, too, and
///          `node_tests` nodes that might be far.
/// \threads Any number of callers.
/// \source  Jacobson, Kavan and Sorkine-Hornung 2013; Van Oosterom and Strackee 1983; Barill et al.
///          2018 for far triangles.
[[nodiscard]] Winding winding(const WindingIndex& index, const Vec3& point,
                              const WindingOptions& options = {}, const Limits& limits = {});

/// Answers for a batch of points: columns, one entry a point, as those of `Winding`.
struct WindingBatch {
  std::vector<Side> side;          ///< n
  std::vector<double> lower;       ///< n, of the number
  std::vector<double> upper;       ///< n, of the number
  std::vector<Coverage> coverage;  ///< n
  std::vector<Cost> costs;         ///< n
  Cost cost;                       ///< of all points together

  [[nodiscard]] bool operator==(const WindingBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return side.size(); }

  /// The answer for a point.
  [[nodiscard]] Winding at(std::size_t point) const;
};

template <>
struct Fields<Winding> {
  static constexpr const char* kName = "Winding";
  static constexpr const char* kMeaning = "Answer of winding for a point.";
  static constexpr const char* kBatchName = "WindingBatch";
  static constexpr const char* kBatchMeaning = "Answers of winding for n points.";
  static constexpr const char* kRows = "points";
  using Batch = WindingBatch;
  static constexpr std::array kCounted{
      Counted<Winding>{[](const Winding& answer) { return answer.side == Side::inside; }, "inside"},
      Counted<Winding>{[](const Winding& answer) { return answer.side == Side::undecided; },
                       "undecided"}};
  static constexpr auto kCoverage = &Batch::coverage;
  static constexpr auto kList = std::tuple(
      field("side", &Winding::side, &Batch::side, "Where the point lies, by the number."),
      field("number", &Winding::number, BracketColumns<Batch>{&Batch::lower, &Batch::upper},
            "The winding number"),
      coverage_field(&Winding::coverage, &Batch::coverage),
      cost_field(&Winding::cost, &Batch::costs));
};

/// `winding` for each of `points`: the answers of single queries, sooner.
///
/// \shape   `points`: n.
/// \errors  As `winding`; a point at fault is named by its index, before any is answered. Also
///          ErrorKind::cancelled.
[[nodiscard]] WindingBatch winding(const WindingIndex& index, std::span<const Vec3> points,
                                   const WindingOptions& options = {}, const Limits& limits = {});

}  // namespace soms
