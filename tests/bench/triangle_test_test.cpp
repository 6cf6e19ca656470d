#include "bench/peers/libraries/triangle_test.h"

#include "soms/geometry/triangle_overlap.h"

#include "tests/support/support.h"

namespace soms::bench {
namespace {

int borrowed = 0;

constexpr Loan kCounting{[](const Triangle& s, const Triangle& t) {
  ++borrowed;
  return triangles_overlap(s, t);
}};

Vec3 point(Rng& rng, double l1_norm) {
  const double x = rng.uniform(-l1_norm, l1_norm);
  const double y = rng.uniform(-l1_norm, l1_norm);
  return {x, y, rng.uniform(-l1_norm, l1_norm)};
}

/// On a coarse grid, where triangles often touch, lie in one plane or have no area.
Vec3 grid_point(Rng& rng) {
  const auto coordinate = [&] { return static_cast<double>(rng.below(4)); };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

TEST(TrianglesTouch, AgreesWithTheExactTestAndRarelyBorrowsIt) {
  borrowed = 0;
  int touching = 0;
  test::for_each_case("bench/triangles", 4000, [&](Rng& rng) {
    const Triangle s{point(rng, 1), point(rng, 1), point(rng, 1)};
    const Triangle t{point(rng, 1), point(rng, 1), point(rng, 1)};
    const bool truth = triangles_overlap(s, t);
    EXPECT_EQ(triangles_touch(s, t, kCounting), truth);
    EXPECT_EQ(triangles_touch(t, s, kCounting), truth);
    EXPECT_EQ(triangles_touch({s.c, s.b, s.a}, {t.b, t.c, t.a}, kCounting), truth);
    touching += truth ? 1 : 0;
  });
  EXPECT_GT(touching, 400);
  EXPECT_LT(borrowed, 20);
}

TEST(TrianglesTouch, BorrowsTheExactTestWhereSignsAreNotSure) {
  borrowed = 0;
  test::for_each_case("bench/triangles-on-a-grid", 4000, [&](Rng& rng) {
    const Triangle s{grid_point(rng), grid_point(rng), grid_point(rng)};
    const Triangle t{grid_point(rng), grid_point(rng), grid_point(rng)};
    EXPECT_EQ(triangles_touch(s, t, kCounting), triangles_overlap(s, t));
  });
  EXPECT_GT(borrowed, 1000);
}

TEST(TrianglesTouch, MovesVerticesAsPosesDo) {
  test::for_each_case("bench/moved", 200, [&](Rng& rng) {
    const Pose pose = Pose::about_z(rng.uniform(0, 6), point(rng, 1000));
    const Vec3 v = point(rng, 10);
    EXPECT_EQ(moved(pose, v), pose.apply(v));
  });
}

}  // namespace
}  // namespace soms::bench
