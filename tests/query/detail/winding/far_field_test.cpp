#include "soms/query/detail/winding/far_field.h"

#include "soms/base/random.h"
#include "soms/query/reference/winding.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soms::detail {
namespace {

std::vector<Triangle> some_triangles(Rng& rng, double unit, double size) {
  std::vector<Triangle> triangles;
  for (std::uint64_t k = 0, count = 1 + rng.below(6); k < count; ++k) {
    const auto point = [&](double reach) {
      return Vec3{rng.uniform(-reach, reach), rng.uniform(-reach, reach),
                  rng.uniform(-reach, reach)};
    };
    const Vec3 a = point(1);
    triangles.push_back({a * unit, (a + point(size)) * unit, (a + point(size)) * unit});
  }
  return triangles;
}

TEST(FarField, IsWithinItsError) {
  Rng rng(17);
  int answered = 0;
  double slack = 1;  // of the error, the least that was left
  for (int run = 0; run < 3000; ++run) {
    const double unit = std::exp2(rng.uniform(-40, 40));
    const double size = std::exp2(rng.uniform(-8, 0));
    const std::vector<Triangle> triangles = some_triangles(rng, unit, size);
    const FarField field(triangles);
    const Body body(test::soup_body(triangles));
    for (int i = 0; i < 10; ++i) {
      const double far = std::exp2(rng.uniform(0.5, 12)) * unit;
      const Vec3 p{rng.uniform(-1, 1) * far, rng.uniform(-1, 1) * far, rng.uniform(-1, 1) * far};
      const auto found = field.at(p, 1);
      if (!found) {
        continue;
      }
      ++answered;
      const Bracket truth = reference::winding_by_brute_force(body, p);
      ASSERT_GE(found->value + found->error, truth.lower);
      ASSERT_LE(found->value - found->error, truth.upper);
      const double off = std::max(truth.lower - found->value, found->value - truth.upper);
      slack = std::min(slack, off > 0 ? 1 - off / found->error : 1);
      EXPECT_FALSE(field.at(p, found->error * 0.99));
    }
  }
  EXPECT_GT(answered, 10'000);
  // The bound is not idle: some answers need a tenth of it.
  EXPECT_LT(slack, 0.9);
}

TEST(FarField, SaysNothingOfPointsThatAreNotFar) {
  const FarField field(std::vector<Triangle>{{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  EXPECT_FALSE(field.at({0, 0.5, 0}, 1));
  EXPECT_FALSE(field.at({0, 0.5, 1.5}, 1));
  EXPECT_TRUE(field.at({0, 0.5, 100}, 1));
  EXPECT_FALSE(field.at({0, 0.5, 100}, 0));
}

TEST(FarField, TakesTheLeastAndTheLargestNumbers) {
  const double least = 0x1p-1074;
  const FarField tiny(std::vector<Triangle>{{{0, 0, 0}, {8 * least, 0, 0}, {0, 8 * least, 0}}});
  const auto near_tiny = tiny.at({0, 0, 4096 * least}, 1);
  ASSERT_TRUE(near_tiny);
  // A triangle of area 32 at a distance of 4096, seen from its front.
  EXPECT_NEAR(near_tiny->value, -32 / (4096.0 * 4096 * 4 * 3.141592653589793), 1e-11);
  EXPECT_LT(tiny.at({0x1p300, 0, 0}, 1)->error, 0x1p-300);
  const double most = 0x1p290;
  const FarField huge(std::vector<Triangle>{{{0, 0, 0}, {most, 0, 0}, {0, most, 0}}});
  EXPECT_TRUE(huge.at({0, 0, 1024 * most}, 1));
}

// However near the point is: the power of its distance would underflow.
TEST(FarField, OfAPointIsNothing) {
  for (const double scale : {1.0, 0x1p-220, 0x1p-540, 0x1p-1074, 0x1p290}) {
    const Vec3 place = Vec3{3, 3, 3} * scale;
    const FarField field(std::vector<Triangle>{{place, place, place}});
    const auto found = field.at(Vec3{4, 3, 3} * scale, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->value, 0);
    EXPECT_EQ(found->error, 0);
    EXPECT_FALSE(field.at(place, 1));
    EXPECT_FALSE(field.at(Vec3{4, 3, 3} * scale, -0x1p-1074));
  }
}

TEST(FarField, IsWithinItsErrorAtEverySize) {
  Rng rng(18);
  int answered = 0;
  for (int exponent = -1070; exponent <= 280; exponent += 5) {
    const double unit = std::ldexp(1.0, exponent);
    for (int run = 0; run < 10; ++run) {
      const std::vector<Triangle> triangles =
          some_triangles(rng, unit, std::exp2(-rng.uniform(0, 60)));
      const FarField field(triangles);
      const Body body(test::soup_body(triangles));
      const double far = std::exp2(rng.uniform(1, 10)) * unit;
      const Vec3 p{rng.uniform(-1, 1) * far, rng.uniform(-1, 1) * far, rng.uniform(-1, 1) * far};
      if (const auto found = field.at(p, 1)) {
        ++answered;
        const Bracket truth = reference::winding_by_brute_force(body, p);
        ASSERT_GE(found->value + found->error, truth.lower) << exponent;
        ASSERT_LE(found->value - found->error, truth.upper) << exponent;
      }
    }
  }
  EXPECT_GT(answered, 1000);
}

}  // namespace
}  // namespace soms::detail
