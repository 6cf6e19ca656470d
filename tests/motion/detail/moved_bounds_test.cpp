#include "soms/motion/detail/moved_bounds.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace soms {

namespace {

TEST(MovedBounds, OfTheIdentityAreTheBoxItself) {
  const Box box{{-1.25, 0.1, -0.3}, {7, 0.2, 0x1p299}};
  EXPECT_EQ(detail::moved_bounds(Pose::identity(), box), box);
}

TEST(MovedBounds, OfAnEmptyBoxAreEmpty) {
  EXPECT_TRUE(detail::moved_bounds(Pose::translation(1, 2, 3), Box{}).empty());
}

// The turned corner's rounded coordinates must be inside, however the roundings fall.
TEST(MovedBounds, HoldEveryMovedVertexAsRounded) {
  test::for_each_case("scene/moved-bounds", 3000, [](Rng& rng) {
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(600)) - 300);
    const auto coordinate = [&] { return scale * rng.uniform(-1, 1); };
    Pose pose = test::random_pose(rng, 1);
    for (const std::size_t entry : {3U, 7U, 11U}) {
      pose.m[entry] = coordinate() * std::ldexp(1.0, static_cast<int>(rng.below(60)) - 30);
    }
    Box box;
    std::vector<Vec3> vertices;
    for (int k = 0; k < 20; ++k) {
      vertices.push_back({coordinate(), coordinate(), coordinate()});
      box.grow(vertices.back());
    }
    const Box moved = detail::moved_bounds(pose, box);
    for (const Vec3& vertex : vertices) {
      const Vec3 at = pose.apply(vertex);
      EXPECT_TRUE(moved.contains(Box{at, at}));
    }
  });
}

TEST(MovedBounds, AreTheMovedCornersOfATurnedBoxAndNoMore) {
  const Box box{{-1, -2, -3}, {1, 2, 3}};
  const Pose quarter = Pose::from_quaternion(std::sqrt(0.5), 0, 0, std::sqrt(0.5), {10, 0, 0});
  const Box moved = detail::moved_bounds(quarter, box);
  EXPECT_NEAR(moved.lower.x, 8, 1e-12);
  EXPECT_NEAR(moved.upper.x, 12, 1e-12);
  EXPECT_NEAR(moved.lower.y, -1, 1e-12);
  EXPECT_NEAR(moved.upper.y, 1, 1e-12);
}

}  // namespace

}  // namespace soms
