#include "soms/scene/detail/moving_pairs.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace soms {

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs ask(detail::MovingPairs& moving, const std::vector<Box>& boxes) {
  const auto pairs = moving.find(boxes);
  return {pairs.begin(), pairs.end()};
}

Pairs scan(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (overlaps(boxes[a], boxes[b])) {
        pairs.emplace_back(a, b);
      }
    }
  }
  return pairs;
}

TEST(MovingPairs, OfNoneOrOneBoxAreNone) {
  detail::MovingPairs moving;
  EXPECT_TRUE(ask(moving, {}).empty());
  EXPECT_TRUE(ask(moving, {Box{{0, 0, 0}, {1, 1, 1}}}).empty());
  EXPECT_TRUE(ask(moving, {Box{}, Box{}}).empty());
}

TEST(MovingPairs, CountTouchingAsMeeting) {
  detail::MovingPairs moving;
  const std::vector<Box> boxes{Box{{0, 0, 0}, {1, 1, 1}}, Box{{1, 1, 1}, {2, 2, 2}},
                               Box{{2.5, 0, 0}, {3, 1, 1}}};
  EXPECT_EQ(ask(moving, boxes), (Pairs{{0, 1}}));
}

TEST(MovingPairs, AreThoseOfAScan) {
  detail::MovingPairs moving;  // reused: what an earlier call left must not show
  test::for_each_case("scene/moving-pairs", 400, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    ASSERT_EQ(ask(moving, boxes), scan(boxes));
  });
}

TEST(MovingPairs, OfSlabsAmongManySmallBoxesAreThoseOfAScan) {
  Rng rng(7);
  std::vector<Box> boxes;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 at{rng.uniform(0, 1000), rng.uniform(0, 1000), 0};
    boxes.push_back({at, at + Vec3{2, 2, 2}});
  }
  boxes.push_back({{-5000, -5000, -1}, {5000, 5000, 0}});
  boxes.push_back({{500, -5000, -1}, {501, 5000, 1}});
  boxes.push_back({{-5000, 500, -1}, {5000, 501, 1}});
  detail::MovingPairs moving;
  EXPECT_EQ(ask(moving, boxes), scan(boxes));
}

TEST(MovingPairs, OfCoordinatesAtTheLimitAreThoseOfAScan) {
  const double far = 0x1p300;
  const std::vector<Box> boxes{Box{{-far, -far, -far}, {far, far, far}},
                               Box{{0, 0, 0}, {0x1p-1074, 0, 0}}, Box{{0, 0, 0}, {0, 0, 0}},
                               Box{{far, far, far}, {far, far, far}}};
  detail::MovingPairs moving;
  EXPECT_EQ(ask(moving, boxes), scan(boxes));
  const std::vector<Box> tiny{Box{{0, 0, 0}, {0x1p-1074, 0, 0}},
                              Box{{0x1p-1074, 0, 0}, {0x1p-1073, 0, 0}},
                              Box{{0x1p-1072, 0, 0}, {0x1p-1072, 0, 0}}};
  EXPECT_EQ(ask(moving, tiny), scan(tiny));
}

}  // namespace

}  // namespace soms
