/// \file
/// The distance of two triangles, known as well as was needed so far: from bounds in plain doubles
/// to whole numbers.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/distance_ends.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/feature_pair.h"
#include "soms/geometry/detail/refined_order.h"

#include <array>
#include <compare>
#include <cstdint>
#include <memory>

namespace soms::detail {

/// Two triangles whose distance is bounded at once, and decided where somebody asks. Three stages:
/// doubles, numbers of twice their precision (both distance_ends.h), whole numbers
/// (exact_distance.h). What is decided is the same at each.
///
/// \pre    Coordinates are finite and of magnitude at most 2^300; no limit for tiny ones.
/// \errors None but memory.
class PairDistance {
 public:
  /// The distance of two triangles at one point.
  PairDistance() = default;

  /// \cost About 400 ns.
  PairDistance(const Triangle& a, const Triangle& b);

  /// Proven bounds, `lower` not negative; nearer to each other after a comparison that needed it.
  [[nodiscard]] Bracket bounds() const;

  /// The order of the two distances, decided exactly.
  [[nodiscard]] std::strong_ordering compare(PairDistance& other);

  /// How the distance stands to `distance`, which is not negative, but may be infinite.
  [[nodiscard]] std::strong_ordering compare(double distance);

  /// The doubles next to the distance.
  [[nodiscard]] Bracket distance();

  /// The ends of a shortest segment, as `triangle_distance` gives them.
  [[nodiscard]] std::array<Vec3, 2> points() const;

  /// How often whole numbers were needed.
  [[nodiscard]] std::uint64_t exact_tests() const { return exact_tests_; }

  /// Features that a shortest segment joins, as far as is known.
  [[nodiscard]] const FeaturePair& features() const { return features_; }

 private:
  enum class Stage : std::uint8_t { doubles, double_doubles, exact };

  friend struct RefinedOrder<PairDistance>;

  /// The distance is `lower_`, and so is `upper_`.
  [[nodiscard]] bool is_number() const { return lower_ == upper_; }

  /// This one is to be refined before the other.
  [[nodiscard]] bool less_refined(const PairDistance& other) const {
    return stage_ != other.stage_ ? stage_ < other.stage_ : other.is_number();
  }

  [[nodiscard]] bool is_exact() const { return stage_ == Stage::exact; }

  /// \pre Both are exact.
  [[nodiscard]] std::strong_ordering compare_exactly(const PairDistance& other) const;
  [[nodiscard]] std::strong_ordering compare_exactly(double distance) const;

  [[nodiscard]] bool is_zero() const { return stage_ == Stage::exact && exact_ == nullptr; }

  template <class T>
  void take(const AboutCorner<T>& place, const Ends<T>& found);

  /// Goes on to the next stage, if there is one.
  void refine();

  /// Goes on to whole numbers.
  void decide();

  void settle_zero();

  /// The features are the same, or a face and corners that are surely as far from its plane.
  [[nodiscard]] bool are_alike(const PairDistance& other) const;

  /// Whether both distances are above 0, and surely those of features that are alike.
  [[nodiscard]] bool has_features_of(const PairDistance& other) const;

  Triangle a_;
  Triangle b_;
  DoubleDouble lower_;
  DoubleDouble upper_;
  std::shared_ptr<const ExactDistance> exact_;  ///< null before that stage, and for distance 0
  EndPoints<DoubleDouble> points_ = {};         ///< of stage `double_doubles`, about `a_`
  int exponent_ = 0;                            ///< of their coordinates
  bool has_points_ = false;                     ///< `points_` were found
  std::uint64_t exact_tests_ = 0;
  FeaturePair features_ = {1, 1};
  Stage stage_ = Stage::exact;
};

}  // namespace soms::detail
