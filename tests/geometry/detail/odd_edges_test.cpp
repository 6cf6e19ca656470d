#include "soms/geometry/detail/parts/odd_edges.h"

#include "soms/base/random.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace soms::detail {
namespace {

/// A place on a line through the origin and (5, -3, 7) times a power of two, or on another one.
Vec3 at(double t, double aside = 0) {
  return {5 * t + 1, -3 * t + aside, 7 * t};
}

TEST(CoversEvenly, HoldsWhereSegmentsCancel) {
  EXPECT_TRUE(covers_evenly({}));
  const std::vector<Segment> one{{at(0), at(3)}};
  EXPECT_FALSE(covers_evenly(one));
  EXPECT_TRUE(covers_evenly(std::vector<Segment>{{at(0), at(3)}, {at(3), at(0)}}));
  EXPECT_TRUE(covers_evenly(std::vector<Segment>{{at(0), at(3)}, {at(3), at(1)}, {at(0), at(1)}}));
  EXPECT_TRUE(covers_evenly(std::vector<Segment>{{at(2), at(2)}}));
  EXPECT_FALSE(covers_evenly(std::vector<Segment>{{at(0), at(3)}, {at(0), at(2)}}));
  EXPECT_FALSE(covers_evenly(std::vector<Segment>{{at(0), at(3)}, {at(4), at(7)}}));
  // The same extent on a line beside it.
  EXPECT_FALSE(covers_evenly(std::vector<Segment>{{at(0), at(3)}, {at(0, 0x1p-60), at(3)}}));
}

TEST(CoversEvenly, TakesZerosOfBothSignsAsOne) {
  EXPECT_TRUE(covers_evenly(std::vector<Segment>{{Vec3{0.0, 1, -0.0}, Vec3{2, 1, 0.0}},
                                                 {Vec3{2, 1, -0.0}, Vec3{-0.0, 1, 0.0}}}));
}

/// Whether segments on a few lines cover each interval between neighboring ends evenly: counted.
bool counted_evenly(const std::vector<std::array<int, 3>>& intervals) {
  std::map<std::array<int, 2>, int> cover;
  for (const auto& [line, from, to] : intervals) {
    for (int t = std::min(from, to); t < std::max(from, to); ++t) {
      ++cover[{line, t}];
    }
  }
  return std::all_of(cover.begin(), cover.end(), [](const auto& c) { return c.second % 2 == 0; });
}

// Lines through one point in all directions, some along an axis, and their intervals cut again.
TEST(CoversEvenly, AgreesWithCounting) {
  const std::vector<Vec3> directions{{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {0, 3, -5},
                                     {7, 0, 2}, {1, -1, 0}, {5, 3, 7}, {-5, 3, 7}};
  std::size_t even = 0;
  test::for_each_case("covers-evenly", 2000, [&](Rng& rng) {
    std::vector<std::array<int, 3>> intervals;
    const auto any = [&](int n) {
      return static_cast<int>(rng.below(static_cast<std::uint64_t>(n)));
    };
    const int loops = 1 + any(4);
    for (int k = 0; k < loops; ++k) {
      const int line = any(8);
      const int first = any(9) - 4;
      int from = first;
      for (int cuts = 1 + any(3); cuts > 0; --cuts) {
        const int to = any(9) - 4;
        intervals.push_back({line, from, to});
        from = to;
      }
      intervals.push_back({line, from, first});
    }
    if (any(2) == 0) {
      intervals.pop_back();
    }
    std::vector<Segment> segments;
    for (const auto& [line, from, to] : intervals) {
      const Vec3& d = directions[static_cast<std::size_t>(line)];
      segments.push_back({d * (0.375 * from), d * (0.375 * to)});
    }
    ASSERT_EQ(covers_evenly(segments), counted_evenly(intervals));
    even += counted_evenly(intervals) ? 1U : 0U;
  });
  EXPECT_GT(even, 500U);
}

}  // namespace
}  // namespace soms::detail
