#include "soms/scene/detail/box_index.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace soms {

namespace {

std::vector<std::uint32_t> ask(const detail::BoxIndex& index, const Box& box) {
  std::vector<std::uint32_t> found;
  index.query(box, [&](std::uint32_t k) { found.push_back(k); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(BoxIndex, WithoutBoxesFindsNothing) {
  detail::BoxIndex index;
  EXPECT_TRUE(ask(index, Box{{-1, -1, -1}, {1, 1, 1}}).empty());
  index.build({});
  EXPECT_TRUE(ask(index, Box{{-1, -1, -1}, {1, 1, 1}}).empty());
}

TEST(BoxIndex, CountsTouchingAsMeeting) {
  detail::BoxIndex index;
  const std::vector<Box> boxes{Box{{0, 0, 0}, {1, 1, 1}}, Box{{5, 5, 5}, {6, 6, 6}}};
  index.build(boxes);
  EXPECT_EQ(ask(index, Box{{1, 1, 1}, {5, 5, 5}}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(ask(index, Box{{1.5, 1, 1}, {4, 5, 5}}).empty());
}

TEST(BoxIndex, FindsWhatAScanFinds) {
  detail::BoxIndex index;  // reused: what an earlier build left must not show
  test::for_each_case("scene/box-index", 200, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    index.build(boxes);
    std::vector<Box> asked = test::random_boxes(rng);
    asked.insert(asked.end(), boxes.begin(), boxes.end());
    for (const Box& box : asked) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        if (overlaps(boxes[k], box)) {
          expected.push_back(k);
        }
      }
      ASSERT_EQ(ask(index, box), expected);
    }
  });
}

TEST(BoxIndex, HoldsManyEqualBoxes) {
  const std::vector<Box> boxes(5000, Box{{0, 0, 0}, {1, 1, 1}});
  detail::BoxIndex index;
  index.build(boxes);
  EXPECT_EQ(ask(index, Box{{1, 1, 1}, {2, 2, 2}}).size(), 5000U);
  EXPECT_TRUE(ask(index, Box{{1.5, 1, 1}, {2, 2, 2}}).empty());
}

}  // namespace

}  // namespace soms
