/// \file
/// The distance of a point from a triangle, known as well as was needed so far: from bounds in
/// plain doubles to whole numbers.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/packed_distance.h"
#include "soms/geometry/detail/point_feature.h"
#include "soms/geometry/detail/refined_order.h"
#include "soms/geometry/point_distance.h"

#include <array>
#include <compare>
#include <cstdint>

namespace soms::detail {

/// A point and a triangle whose distance is bounded at once, and decided where somebody asks. Three
/// stages: doubles, numbers of twice their precision (both point_feature.h; where no feature is
/// proved, distance_ends.h and no second stage), whole numbers (exact_point.h). What is decided is
/// the same at each.
///
/// \pre    Coordinates are finite and of magnitude at most 2^300; no limit for tiny ones.
/// \errors None but memory.
class PointToTriangle {
 public:
  /// A point at a triangle that is the same point.
  PointToTriangle() = default;

  /// \cost About 60 ns.
  PointToTriangle(const Vec3& point, const Triangle& triangle);

  /// Proven bounds, `lower` not negative; nearer to each other after a comparison that needed it.
  [[nodiscard]] Bracket bounds() const;

  /// The order of the two distances, decided exactly. \pre Both points are the same.
  [[nodiscard]] std::strong_ordering compare(PointToTriangle& other);

  /// How the distance stands to `distance`, which is not negative, but may be infinite.
  [[nodiscard]] std::strong_ordering compare(double distance);

  /// The doubles next to the distance.
  [[nodiscard]] Bracket distance();

  /// The nearest point of the triangle and where it lies, as `point_distance` gives them.
  [[nodiscard]] Vec3 nearest();
  [[nodiscard]] TriangleFeature feature();

  /// How often whole numbers were needed.
  [[nodiscard]] std::uint64_t exact_tests() const { return exact_.known() ? 1 : 0; }

 private:
  enum class Stage : std::uint8_t { doubles, double_doubles, exact };

  friend struct RefinedOrder<PointToTriangle>;

  /// The distance is `lower_`, and so is `upper_`.
  [[nodiscard]] bool is_number() const { return lower_ == upper_; }

  [[nodiscard]] bool is_exact() const { return stage_ == Stage::exact; }

  /// This one is to be refined before the other.
  [[nodiscard]] bool less_refined(const PointToTriangle& other) const {
    return stage_ < other.stage_;
  }

  /// \pre Both are exact.
  [[nodiscard]] std::strong_ordering compare_exactly(PointToTriangle& other);
  [[nodiscard]] std::strong_ordering compare_exactly(double distance);

  /// Goes on to the next stage. \pre There is one.
  void refine();
  void refine_way();

  /// Decides in whole numbers. Only the distance is kept of them.
  ExactPoint decide();
  [[nodiscard]] SquaredDistance squared();

  /// Both nearest features are certain, and the same.
  [[nodiscard]] bool has_features_of(const PointToTriangle& other) const;

  /// The nearest points, if twice the precision is enough to round them.
  [[nodiscard]] bool round_nearest(Vec3& rounded);

  Vec3 point_;
  Triangle triangle_;
  DoubleDouble lower_;
  DoubleDouble upper_;
  PackedDistance exact_;
  std::array<DoubleDouble, 3> way_;  // of stage `double_doubles`
  PointFeature found_ = {1};
  Stage stage_ = Stage::double_doubles;
};

}  // namespace soms::detail
