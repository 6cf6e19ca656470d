#include "soms/motion/detail/exact_sweep.h"

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/grid.h"

#include <array>
#include <cstddef>
#include <utility>

namespace soms::detail {

namespace {

/// A vector as whole multiples of 2^unit.
struct GridVec {
  IntegerVec numbers;
  int unit = 0;

  explicit GridVec(const Vec3& v) {
    std::array<Odd, 3> odds;
    put_odds(v, odds.data());
    unit = unit_of(odds);
    numbers = on_grid(odds.data(), unit);
  }
};

/// Rays at the differences of two triangles' corners.
class SweepRays {
 public:
  SweepRays(const Triangle& moving, const Triangle& resting, const Vec3& by)
      : pair_(moving, resting), by_(by) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) {
        way_[k][l] = pair_.at(1, l) - pair_.at(0, k);
      }
    }
  }

  [[nodiscard]] std::optional<RayTime> first() {
    for (std::size_t k = 0; k < 3; ++k) {
      look_at(way_[k][0], way_[k][1], way_[k][2]);
      look_at(way_[0][k], way_[1][k], way_[2][k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) {
        const std::size_t m = (k + 1) % 3;
        const std::size_t n = (l + 1) % 3;
        look_at(way_[k][l], way_[k][n], way_[m][n]);
        look_at(way_[k][l], way_[m][n], way_[m][l]);
      }
    }
    return std::move(first_);
  }

 private:
  void look_at(const IntegerVec& a, const IntegerVec& b, const IntegerVec& c) {
    const ExactRay ray({a, b, c}, pair_.exponent(), by_.numbers, by_.unit, 1);
    if (ray.hit() && (!first_ || compare(ray.time(), *first_) < 0)) {
      first_ = ray.time();
    }
  }

  ExactPair pair_;
  GridVec by_;
  std::array<std::array<IntegerVec, 3>, 3> way_;  ///< from a corner of the moving one to a resting
  std::optional<RayTime> first_;
};

}  // namespace

std::optional<RayTime> exact_sweep(const Triangle& moving, const Triangle& resting,
                                   const Vec3& by) {
  if (by == Vec3{}) {
    return std::nullopt;
  }
  return SweepRays(moving, resting, by).first();
}

}  // namespace soms::detail
