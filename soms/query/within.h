/// \file
/// Are two surfaces within a clearance of each other? Decided exactly, and sooner than their
/// distance is known.
///
/// \code
/// const soms::Body a{soms::generate_sphere(320)};  // of radius 1, about the origin
/// const soms::Body b(a.shape, soms::Pose::translation(0, 0, 2.5));
/// for (const double clearance : {0.4, 0.5}) {
///   const soms::Within answer = soms::within(a, b, clearance);
///   std::cout << "within " << clearance << ": " << (answer.within ? "yes" : "no") << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// within 0.4: no
/// within 0.5: yes
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// Answer of a query of clearance.
struct Within {
  bool within = false;
  /// A pair of triangles within the clearance; which one is not promised.
  std::optional<TrianglePair> triangles = std::nullopt;
  Vec3 point_a = {};  ///< of that pair as `Distance` has them
  Vec3 point_b = {};
  /// A lower bound of the distance: the clearance where nothing is within it, and what was proved
  /// so far where coverage is `cut`. Infinity where a mesh is empty; 0 where `within` holds.
  double at_least = 0;
  /// Where it is `cut`, `within` is false and means nothing.
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const Within&) const = default;
};

/// Whether the least distance of two surfaces is at most `clearance`, decided exactly on the moved
/// vertices. Clearance 0 asks for overlap.
///
/// \errors  As `distance`; ErrorKind::usage for a clearance that is negative or not a number.
/// \cost    At most that of `distance`, as a rule far less.
/// \threads As `distance`.
[[nodiscard]] Within within(const Body& a, const Body& b, double clearance,
                            const Limits& limits = {});

/// Answers for a batch of poses: columns, one entry a pose, as those of `Within`.
struct WithinBatch {
  std::vector<std::uint8_t> within;                    ///< n flags, 0 or 1
  std::vector<std::optional<TrianglePair>> triangles;  ///< n
  std::vector<Vec3> point_a;                           ///< n
  std::vector<Vec3> point_b;                           ///< n
  std::vector<double> at_least;                        ///< n
  std::vector<Coverage> coverage;                      ///< n
  std::vector<Cost> costs;                             ///< n
  Cost cost;                                           ///< of all poses together

  [[nodiscard]] bool operator==(const WithinBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return within.size(); }

  /// The answer for a pose.
  [[nodiscard]] Within at(std::size_t pose) const;
};

template <>
struct Fields<Within> {
  static constexpr const char* kName = "Within";
  static constexpr const char* kMeaning = "Answer of within.";
  static constexpr const char* kBatchName = "WithinBatch";
  static constexpr const char* kBatchMeaning = "Answers of within for n poses.";
  static constexpr const char* kRows = "poses";
  using Batch = WithinBatch;
  static constexpr std::array kCounted{
      Counted<Within>{[](const Within& answer) { return answer.within; }, "within the clearance"}};
  static constexpr auto kTruth = &Within::within;
  static constexpr auto kList = std::tuple(
      field("within", &Within::within, &Batch::within, "The distance is at most the clearance."),
      field("at_least", &Within::at_least, &Batch::at_least, "A lower bound of the distance."),
      field("triangles", &Within::triangles, &Batch::triangles, "Some pair within the clearance."),
      field("point_a", &Within::point_a, &Batch::point_a,
            "The end of its shortest segment on a, in world.")
          .where_named(),
      field("point_b", &Within::point_b, &Batch::point_b, "The other end, on b.").where_named(),
      coverage_field(&Within::coverage, &Batch::coverage),
      cost_field(&Within::cost, &Batch::costs));
};

/// `within` of `mover` at each of `poses` and `fixed`: the answers of single queries.
///
/// \shape   `poses`: n.
/// \errors  As `within`; a pose at fault is named by its index.
[[nodiscard]] WithinBatch within(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                                 double clearance, const Limits& limits = {});

}  // namespace soms
