// Meshes that no builder likes, by every rule: answers are those of brute force.
#include "soms/base/error.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <limits>
#include <vector>

namespace soms {
namespace {

/// Asks for the overlap of two meshes whose trees are built by each rule, with and without a limit
/// of levels, and compares with brute force.
void expect_right_by_every_rule(const Mesh& a, const Mesh& b, const Pose& pose) {
  const Overlap truth = reference::overlap(a, pose, b, {});
  ASSERT_TRUE(truth.any);
  for (const RuleEntry& rule : rules()) {
    for (const int level : {0, 3}) {
      const BuildOptions build{.rule = rule.rule, .level = level};
      const Overlap answer =
          overlap(Body(Shape(a, {.build = build}), pose), Body(Shape(b, {.build = build})));
      ASSERT_EQ(answer.pairs, truth.pairs) << rule.name << ", level " << level;
    }
  }
}

Triangle sized(Rng& rng, const Vec3& middle, double size) {
  const auto corner = [&] {
    return middle + size * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  };
  const Vec3 a = corner();
  const Vec3 b = corner();
  return {a, b, corner()};
}

TEST(OverlapBadInput, OneTriangleTouchesOneTriangle) {
  const Mesh one = test::soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  expect_right_by_every_rule(one, one, Pose::translation(1, 0, 0));
}

TEST(OverlapBadInput, AllMidpointsAreEqual) {
  std::vector<Triangle> nested;
  for (int i = 1; i <= 1000; ++i) {
    const double r = std::ldexp(i, -10);
    nested.push_back({{-r, -r, 0}, {r, -r, 0}, {-r, r, 0}});
  }
  std::vector<Triangle> same_box;
  for (int i = 0; i < 1000; ++i) {
    same_box.push_back(i % 2 == 0 ? Triangle{{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}
                                  : Triangle{{1, 1, 1}, {0, 1, 0}, {1, 0, 0}});
  }
  expect_right_by_every_rule(test::soup_body({{{0, 0, -1}, {-0.5, -0.3, 1}, {-0.3, -0.5, 1}}}),
                             test::soup_body(nested), {});
  expect_right_by_every_rule(test::soup_body({{{0, 0, -1}, {0.5, 0.1, 1}, {0.1, 0.5, 1}}}),
                             test::soup_body(same_box), {});
}

TEST(OverlapBadInput, OneTriangleIsAsLargeAsTheCity) {
  Rng rng(7);
  std::vector<Triangle> city = {{{-500, -500, 0}, {1500, -500, 0}, {-500, 1500, 10}}};
  for (int i = 0; i < 2000; ++i) {
    city.push_back(sized(rng, {rng.uniform(0, 900), rng.uniform(0, 900), rng.uniform(0, 30)}, 2));
  }
  const Mesh car = test::box_body({-2, -1, 0}, {2, 1, 1.5}, 3);
  expect_right_by_every_rule(car, test::soup_body(city), Pose::translation(300, 300, 3));
}

TEST(OverlapBadInput, SizesInOneMeshSpan24Decades) {
  Rng rng(11);
  std::vector<Triangle> mesh;
  for (int i = 0; i < 250; ++i) {
    const double size = std::pow(10.0, rng.uniform(-12, 12));
    mesh.push_back(sized(rng, size * Vec3{rng.uniform(-3, 3), rng.uniform(-3, 3), 0}, size));
  }
  const Mesh body = test::soup_body(mesh);
  for (const double step : {1e-12, 1e-6, 1.0, 1e6, 1e10}) {
    expect_right_by_every_rule(body, body, Pose::translation(step, -0.5 * step, 0.25 * step));
  }
}

TEST(OverlapBadInput, NumbersThatAreNoneAreRefusedByEveryRule) {
  Mesh mesh = test::box_body({0, 0, 0}, {1, 1, 1}, 2);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    mesh.vertices[mesh.triangles[5][1]].y = bad;
    for (const RuleEntry& rule : rules()) {
      try {
        const Shape shape(mesh, {.build = {.rule = rule.rule}});
        FAIL() << rule.name;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::not_finite) << rule.name;
      }
    }
  }
}

}  // namespace
}  // namespace soms
