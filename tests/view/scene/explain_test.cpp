#include "apps/view/scene/explain.h"

#include "soms/geometry/triangle_overlap.h"

#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace soms::view {
namespace {

constexpr Triangle kGround{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

void expect(const Triangle& t, bool touch, Stage stage, TouchKind kind) {
  const Explanation e = explain(kGround, t);
  EXPECT_EQ(e.touch, touch) << e.text;
  EXPECT_EQ(e.stage, stage) << e.text;
  EXPECT_EQ(e.kind, kind) << e.text;
}

TEST(Explain, NamesTheStageThatDecided) {
  expect({{9, 0, 0}, {10, 0, 0}, {9, 1, 0}}, false, Stage::boxes, TouchKind::none);
  expect({{0, 0, 1}, {4, 0, 1}, {1, 1, -1}}, true, Stage::edges, TouchKind::crossing);
  expect({{1, 1, 1}, {3, 3, 0x1p-40}, {0, 2, 1}}, false, Stage::boxes, TouchKind::none);
  expect({{3, 3, -1}, {3, 3, 1}, {4, 4, 1}}, false, Stage::edges, TouchKind::none);
  expect({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, true, Stage::coplanar, TouchKind::common_area);
  expect({{2, 2, 0}, {4, 4, 0}, {4, 3, 0}}, true, Stage::coplanar, TouchKind::touching);
  expect({{3, 3, 0}, {4, 4, 0}, {4, 3, 0}}, false, Stage::coplanar, TouchKind::none);
  expect({{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, true, Stage::edges, TouchKind::touching);
  expect({{2, -1, -1}, {2, 1, 1}, {9, -8, 8}}, true, Stage::edges, TouchKind::touching);
  expect({{1, 1, -1}, {1, 1, 1}, {1, 1, 0}}, true, Stage::flat, TouchKind::without_area);
  const Triangle tilted{{0, 0, 4}, {4, 0, -0.5}, {4, 4, 4}};
  const Explanation apart = explain(tilted, {{0, 0, -1}, {1, 0, -0.25}, {0, 1, -1}});
  EXPECT_FALSE(apart.touch);
  EXPECT_EQ(apart.stage, Stage::plane_of_a);
  EXPECT_EQ(explain({{0, 0, -1}, {1, 0, -0.25}, {0, 1, -1}}, tilted).stage, Stage::plane_of_b);
}

TEST(Explain, GivesNumbers) {
  const Explanation boxes = explain(kGround, {{7, 0, 0}, {10, 0, 2}, {7, 1, 5}});
  EXPECT_EQ(boxes.axis, 0U);
  EXPECT_EQ(boxes.gap, 3);
  const Explanation crossing = explain(kGround, {{1, 1, -2}, {1, 1, 1}, {2, 1, 0}});
  EXPECT_EQ(crossing.b_above_a[0].height, -2);
  EXPECT_EQ(crossing.b_above_a[0].sign, Sign::negative);
  EXPECT_EQ(crossing.b_above_a[2].sign, Sign::zero);
  EXPECT_TRUE(crossing.exact_arithmetic);
  EXPECT_FALSE(explain(kGround, {{1, 1, -2}, {1, 1, 1}, {2, 1, 3}}).exact_arithmetic);
  EXPECT_NE(crossing.text.find("exactly in it"), std::string::npos);
}

bool strictly_one_sided(const std::array<CornerSide, 3>& sides) {
  return sides[0].sign != Sign::zero && sides[0].sign == sides[1].sign &&
         sides[0].sign == sides[2].sign;
}

/// What an explanation claims, against what can be queried without it.
void expect_true(const Explanation& e, const Triangle& a, const Triangle& b) {
  ASSERT_EQ(e.kind == TouchKind::none, !e.touch);
  ASSERT_EQ(e.common.empty(), !e.touch);
  ASSERT_FALSE(e.text.empty());
  switch (e.stage) {
    case Stage::boxes:
      ASSERT_TRUE(bounds(a).upper[e.axis] < bounds(b).lower[e.axis] ||
                  bounds(b).upper[e.axis] < bounds(a).lower[e.axis]);
      ASSERT_FALSE(e.touch);
      break;
    case Stage::plane_of_b:
      ASSERT_TRUE(strictly_one_sided(e.a_above_b));
      ASSERT_FALSE(e.touch);
      break;
    case Stage::plane_of_a:
      ASSERT_TRUE(strictly_one_sided(e.b_above_a));
      ASSERT_FALSE(e.touch);
      break;
    case Stage::coplanar:
      for (const CornerSide& side : e.a_above_b) {
        ASSERT_EQ(side.sign, Sign::zero);
      }
      break;
    default:
      ASSERT_FALSE(e.stage == Stage::edges && strictly_one_sided(e.a_above_b));
      break;
  }
  // Turning one over changes no verdict.
  const Explanation turned = explain({a.b, a.a, a.c}, b);
  ASSERT_EQ(turned.stage, e.stage);
  ASSERT_EQ(turned.kind, e.kind);
}

TEST(Explain, TellsTheTruthOnTheTruthSet) {
  std::set<Stage> stages;
  std::set<TouchKind> kinds;
  std::size_t number = 0;
  for (const test::TruthTriangles& pair : test::truth_triangles()) {
    if (pair.kind == "huge" || number++ % 5 != 0) {
      continue;
    }
    const Explanation e = explain(pair.s, pair.t);
    ASSERT_EQ(e.touch, pair.overlap) << pair.kind;
    ASSERT_NO_FATAL_FAILURE(expect_true(e, pair.s, pair.t)) << pair.kind << ": " << e.text;
    const Explanation mirrored = explain(pair.t, pair.s);
    ASSERT_EQ(mirrored.kind, e.kind);
    ASSERT_EQ(mirrored.touch, e.touch);
    stages.insert(e.stage);
    kinds.insert(e.kind);
  }
  EXPECT_EQ(stages.size(), 6U);
  EXPECT_EQ(kinds.size(), 5U);
}

TEST(Explain, NamesAreDistinct) {
  std::set<std::string_view> names;
  for (const Stage stage : {Stage::boxes, Stage::plane_of_b, Stage::plane_of_a, Stage::edges,
                            Stage::coplanar, Stage::flat}) {
    names.insert(name(stage));
  }
  for (const TouchKind kind : {TouchKind::none, TouchKind::crossing, TouchKind::touching,
                               TouchKind::common_area, TouchKind::without_area}) {
    names.insert(name(kind));
  }
  EXPECT_EQ(names.size(), 11U);
}

}  // namespace
}  // namespace soms::view
