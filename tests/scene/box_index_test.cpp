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
    std::vector<Box> query_options = test::random_boxes(rng);
    query_options.insert(query_options.end(), boxes.begin(), boxes.end());
    for (const Box& box : query_options) {
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

TEST(BoxIndex, SearchesInTheOrderOfKeys) {
  detail::BoxIndex index;
  std::vector<detail::KeyedBounds> heap;
  test::for_each_case("scene/box-index/search", 200, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    index.build(boxes);
    const auto key_of = [](const Box& box) { return std::max(box.lower.x, 3.0); };
    std::vector<std::uint32_t> expected;
    const double most = rng.uniform(0, 40);
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      if (!boxes[k].empty() && key_of(boxes[k]) <= most) {
        expected.push_back(k);
      }
    }
    std::vector<std::uint32_t> found;
    double last = 0;
    const std::uint64_t keyed = index.search(key_of, 1e300, heap, [&](std::uint32_t k, double key) {
      EXPECT_LE(last, key);
      EXPECT_EQ(key, key_of(boxes[k]));
      last = key;
      if (key <= most) {
        found.push_back(k);
      }
      return most;
    });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
    ASSERT_GE(keyed, found.size());
  });
}

TEST(BoxIndex, PassesOverTheBoxesOfAGroup) {
  detail::BoxIndex index;
  test::for_each_case("scene/box-index/groups", 100, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    std::vector<std::uint32_t> groups;
    const std::uint64_t run = 1 + rng.below(30);  // whole nodes of one group, or mixed ones
    for (std::size_t k = 0; k < boxes.size() && rng.below(200) != 0; ++k) {
      groups.push_back(static_cast<std::uint32_t>(k / run % 4));
    }
    index.build(boxes, groups);
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      const std::uint32_t group = k % 5;
      std::vector<std::uint32_t> expected;
      for (std::uint32_t j = 0; j < boxes.size(); ++j) {
        const std::uint32_t other = j < groups.size() ? groups[j] : 0;
        if (overlaps(boxes[k], boxes[j]) && (group == 0 || group != other)) {
          expected.push_back(j);
        }
      }
      std::vector<std::uint32_t> found;
      index.query(boxes[k], group, [&](std::uint32_t j) { found.push_back(j); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
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
