#include "soms/tree/layout/detail/node_axes.h"

#include "tests/support/support.h"

#include <cmath>
#include <vector>

namespace soms::layout {
namespace {

double gram_error(const Axes& q) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += static_cast<double>(q[3 * k + i]) * static_cast<double>(q[3 * k + j]);
      }
      most = std::max(most, std::abs(sum - (i == j ? 1 : 0)));
    }
  }
  return most;
}

TEST(PrincipalAxes, AreOrthonormalToTheBoundThatMarginsUse) {
  test::for_each_case("orientation/orthonormal", 2000, [](Rng& rng) {
    const double scale = std::exp2(rng.uniform(-130, 20));
    const Vec3 stretch{std::exp2(-rng.uniform(0, 40)), 1, std::exp2(-rng.uniform(0, 5))};
    const double shear = rng.uniform(-1, 1);
    std::vector<Vec3> points(1 + rng.below(24));
    for (Vec3& p : points) {
      p = {stretch.x * rng.uniform(-1, 1), rng.uniform(-1, 1), stretch.z * rng.uniform(-1, 1)};
      p.z += shear * p.y;
      p = p * scale;
    }
    ASSERT_LE(gram_error(principal_axes(points)), 0x1p-23);
  });
}

TEST(PrincipalAxes, FlattenAPlane) {
  test::for_each_case("orientation/plane", 200, [](Rng& rng) {
    const double a = rng.uniform(-2, 2);
    const double b = rng.uniform(-2, 2);
    std::vector<Vec3> points(12);
    for (Vec3& p : points) {
      p = {rng.uniform(-1, 1), rng.uniform(-1, 1), 0};
      p.z = a * p.x + b * p.y;
    }
    const Axes axes = principal_axes(points);
    double flattest = 100;
    for (std::size_t k = 0; k < 3; ++k) {
      double lower = 100;
      double upper = -100;
      for (const Vec3& p : points) {
        lower = std::min(lower, along(axes, p)[k]);
        upper = std::max(upper, along(axes, p)[k]);
      }
      flattest = std::min(flattest, upper - lower);
    }
    ASSERT_LT(flattest, 1e-6);
  });
}

TEST(PrincipalAxes, OfOnePointAreTheMeshs) {
  const std::vector<Vec3> points(3, Vec3{1, 2, 3});
  EXPECT_EQ(principal_axes(points), kMeshAxes);
}

}  // namespace
}  // namespace soms::layout
