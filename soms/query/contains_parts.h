/// \file
/// Which parts of a body is a point inside? Each part is a body of its own, decided exactly.
///
/// \code
/// const soms::DividedBody car(soms::Body{soms::generate_mover(soms::MoverKind::car)});
/// const soms::MeshView& mesh = car.body().shape.mesh();
/// std::cout << car.parts().size() << " parts; these hold the point:\n";
/// for (const soms::PartSide& found : soms::contains(car, {0, 0, 0.6}).parts) {
///   const soms::DividedPart& part = car.parts()[found.part];
///   std::cout << mesh.parts[part.named].name << ": " << found.side << '\n';
/// }
/// \endcode
/// It prints:
/// \verbatim
/// 12 parts; these hold the point:
/// hull: inside
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/geometry/mesh.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace soms {

/// How the triangles of a mesh are divided: each belongs to one part.
enum class Partition : unsigned char {
  /// By the innermost of Mesh::parts; triangles without one are a part, too. Parts that close each
  /// other, as `bodies_of` decides it, are one.
  named,
  connected,  ///< by vertices in one place: triangles that share one belong together
};

template <>
inline constexpr auto kWords<Partition> =
    words("Partition",
          "How triangles are divided: by the parts of the file, or by vertices in one place.",
          "named", "connected");

/// A part of a body, and whether points can be inside it.
struct DividedPart {
  /// Index in Mesh::parts; none for a connected part. The first of several that are one body.
  std::uint32_t named = Part::kNoParent;
  std::vector<std::uint32_t> joined = {};  ///< the others, Part::kNoParent last
  TriangleId first = 0;                    ///< its first triangle
  std::uint64_t triangles = 0;
  bool closed = true;           ///< by itself, at the body's pose, as `closedness` decides it
  std::uint64_t odd_edges = 0;  ///< edges that an odd number of its triangles use

  [[nodiscard]] bool operator==(const DividedPart&) const = default;
};

/// A body whose parts were found and checked, each by itself. A value; copies share what was
/// found.
class DividedBody {
 public:
  /// \errors  ErrorKind::not_rigid, not_finite, out_of_range for the pose; cancelled. Open parts
  ///          are no error.
  /// \cost    As `closedness`, once for the whole and once for the parts, and a copy of the mesh
  ///          for as long as it takes. Where named parts are open, as `bodies_of` and twice that.
  ///          Keeps 4 bytes a triangle.
  explicit DividedBody(Body body, Partition partition = Partition::named,
                       const Limits& limits = {});

  [[nodiscard]] const Body& body() const { return body_; }

  [[nodiscard]] Partition partition() const { return partition_; }

  /// Named parts in the order of Mesh::parts, triangles without one last; connected ones by first
  /// triangle.
  [[nodiscard]] std::span<const DividedPart> parts() const { return found_->parts; }

  /// How many of them are open.
  [[nodiscard]] std::size_t open_parts() const { return found_->open; }

  /// The part of a triangle: an index of `parts`.
  [[nodiscard]] std::uint32_t part_of(TriangleId triangle) const {
    return found_->part_of[triangle];
  }

  [[nodiscard]] bool operator==(const DividedBody& other) const {
    return body_ == other.body_ && partition_ == other.partition_;
  }

 private:
  struct Found {
    std::vector<DividedPart> parts;
    std::vector<std::uint32_t> part_of;
    std::size_t open = 0;
  };

  [[nodiscard]] static Found divide(const Body& body, Partition partition,
                                    const std::vector<std::uint32_t>& number, const Limits& limits);
  [[nodiscard]] static Found find(const Body& body, Partition partition, const Limits& limits);

  Body body_;
  Partition partition_;
  std::shared_ptr<const Found> found_;
};

/// A part that holds a point.
struct PartSide {
  std::uint32_t part = 0;    ///< index of DividedBody::parts
  Side side = Side::inside;  ///< `inside` or `on`

  [[nodiscard]] bool operator==(const PartSide&) const = default;
};

template <>
struct Fields<PartSide> {
  static constexpr const char* kName = "PartSide";
  static constexpr const char* kMeaning = "A part that holds a point.";
  static constexpr auto kList =
      std::tuple(field("part", &PartSide::part, "An index of DividedBody.parts."),
                 field("side", &PartSide::side, "Inside or on."));
};

/// Answer of `contains` for a point and the parts of a body.
struct ContainsParts {
  std::vector<PartSide> parts;  ///< by `part`; empty if the deadline passed
  Coverage coverage = Coverage::complete;
  Cost cost = {};

  [[nodiscard]] bool operator==(const ContainsParts&) const = default;
};

template <>
struct Fields<ContainsParts> {
  static constexpr const char* kName = "ContainsParts";
  static constexpr const char* kMeaning = "The parts that hold a point.";
  static constexpr auto kList =
      std::tuple(list("parts", &ContainsParts::parts, "k", "Those that the point is inside or on."),
                 coverage_field(&ContainsParts::coverage, NoColumn()),
                 field("cost", &ContainsParts::cost, "Work done."));
};

/// The parts that a point is inside, or on the surface of, each as `contains` decides it for the
/// part alone. An open part is listed where a point is on it, and never as one that the point is
/// inside: DividedBody::parts tells which ones are open.
///
/// \errors  ErrorKind::not_finite, out_of_range unless the point is finite and within 2^300.
/// \cost    As `contains`: one ray for all parts.
/// \threads Any number of callers.
[[nodiscard]] ContainsParts contains(const DividedBody& body, const Vec3& point,
                                     const Limits& limits = {});

/// Answers for a batch of points: those of point k are rows [offsets[k], offsets[k + 1]) of
/// `parts`.
struct ContainsPartsBatch {
  std::vector<std::uint64_t> offsets;  ///< n + 1
  std::vector<PartSide> parts;         ///< by point, then by part
  std::vector<Coverage> coverage;      ///< n
  std::vector<Cost> costs;             ///< n
  Cost cost;                           ///< of all points together

  [[nodiscard]] bool operator==(const ContainsPartsBatch&) const = default;

  [[nodiscard]] std::size_t size() const { return coverage.size(); }

  /// The parts of a point.
  [[nodiscard]] std::span<const PartSide> parts_of(std::size_t point) const;

  /// The answer for a point.
  [[nodiscard]] ContainsParts at(std::size_t point) const;
};

template <>
struct Fields<ContainsPartsBatch> {
  static constexpr const char* kName = "ContainsPartsBatch";
  static constexpr const char* kMeaning = "The parts that hold each of n points.";
  static constexpr auto kOffsets = &ContainsPartsBatch::offsets;
  static constexpr auto kValues = &ContainsPartsBatch::parts;
  static constexpr auto kList = std::tuple(
      list("offsets", &ContainsPartsBatch::offsets, "n + 1",
           "Point i has the parts offsets[i] to offsets[i + 1]."),
      list("parts", &ContainsPartsBatch::parts, "k", "The parts of all points."),
      list("coverage", &ContainsPartsBatch::coverage, "n", "How much of the question is decided."),
      list("costs", &ContainsPartsBatch::costs, "n", "Work done."),
      field("cost", &ContainsPartsBatch::cost, "Work done for all points together."));
};

/// The same for each of `points`.
///
/// \shape   `points`: n.
/// \errors  As for one point; a point at fault is named by its index, before any is answered. Also
///          ErrorKind::cancelled.
[[nodiscard]] ContainsPartsBatch contains(const DividedBody& body, std::span<const Vec3> points,
                                          const Limits& limits = {});

}  // namespace soms
