#include "soms/query/overlap.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/overlap.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace soms {
namespace {

using test::likely_to_meet;
using test::Two;

Overlap twin(const Two& two) {
  return reference::overlap(two.a.shape.mesh(), two.a.pose, two.b.shape.mesh(), two.b.pose);
}

void expect_right_overlap_of(const Two& two) {
  ASSERT_EQ(test::first_fault_of_overlap(two.a, two.b), "");
}

/// The corner of `mesh`, turned by `pose`, that lies farthest along `n`.
Vec3 farthest(const Mesh& mesh, const Pose& pose, const Vec3& n) {
  Vec3 best = mesh.vertices[mesh.triangles.front()[0]];
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Vec3& v = mesh.vertices[corner];
      best = dot(n, pose.apply(v)) > dot(n, pose.apply(best)) ? v : best;
    }
  }
  return best;
}

/// Triangles that share the origin, each of its own size, beside some that are `large`.
Mesh tiny_among_large(Rng& rng, double large) {
  Mesh mesh;
  const auto direction = [&rng] {
    const Vec3 any{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    return rng.below(2) == 0 ? any : axes[rng.below(4)];
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::uint64_t k = rng.below(2) == 0 ? 1 : 1 + rng.below(6); k > 0; --k) {
    // Often where a float hardly holds the product of two sides.
    const double size = std::exp2(-(rng.below(2) == 0 ? rng.uniform(0, 160) : rng.uniform(73, 76)));
    add({0, 0, 0}, direction() * size, direction() * (size * std::exp2(-rng.uniform(0, 1))));
  }
  for (std::uint64_t k = rng.below(8); k > 0; --k) {
    const Vec3 away = direction() * large;
    add(away, away + direction(), away + direction());
    if (rng.below(2) == 0) {  // mirrored, so that the middle stays at the origin
      const Vec3 other = away * -1;
      add(other, other + direction(), other + direction());
    }
  }
  return mesh;
}

Mesh rectangle(double half_x, double half_y) {
  Mesh mesh;
  mesh.vertices = {
      {-half_x, -half_y, 0}, {half_x, -half_y, 0}, {half_x, half_y, 0}, {-half_x, half_y, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Floats hold a tiny triangle's normal barely or not at all, while what it meets is large.
TEST(Overlap, EqualsItsTwinOfTinyTrianglesAmongLargeOnes) {
  test::for_each_case("overlap/tiny-among-large", 1500, [](Rng& rng) {
    const Mesh tiny = tiny_among_large(rng, std::exp2(rng.uniform(0, 22)));
    const double side = std::exp2(rng.uniform(0, 18));
    const Mesh large = rectangle(side * rng.uniform(0, 1), side * rng.uniform(0, 1));
    const Pose rotation = test::awkward_rotation(rng);
    const Triangle t = tiny.triangle(0);
    const Vec3 corner = farthest(large, rotation, cross(t.b * 0x1p70, t.c * 0x1p70));
    const Pose pose = test::moving(rotation, corner, {0, 0, 0});
    const Layout layout = rng.below(2) == 0 ? Layout::wide : Layout::compact;
    expect_right_overlap_of(
        {Body(Shape(large, {.build = test::awkward_options(rng), .layout = layout}), pose),
         Body(Shape(tiny, {.build = test::awkward_options(rng), .layout = layout}))});
  });
}

// Without the margin for moved vertices one of 16 such cases loses pairs, without the relative
// margin one of 5, and with R^T for the inverse one of 70.
TEST(Overlap, KeepsBodiesThatTouchAtOneCorner) {
  test::for_each_case("overlap/corner", 1000, [](Rng& rng) {
    const double scale = rng.below(2) ? 1 : std::exp2(rng.uniform(-1000, 290));
    const double other =
        rng.below(2) ? scale : std::max(scale * std::exp2(-rng.uniform(0, 60)), 0x1p-1040);
    const double far = rng.below(2) ? 0 : scale * std::exp2(rng.uniform(-8, 8));
    const Vec3 place{far, -0.5 * far, 0.25 * far};
    const Mesh a = test::placed(test::awkward_mesh(rng, 40), scale, rng.below(2) ? place : Vec3{});
    const Mesh b = test::placed(test::awkward_mesh(rng, 40), other, rng.below(2) ? place : Vec3{});
    const Pose turn = test::awkward_rotation(rng);
    Pose pose_b = test::awkward_rotation(rng);
    pose_b.m[7] = far * rng.unit();
    // Along an axis of a box, where boxes touch too, or along any direction.
    const Pose& seen = rng.below(2) ? turn : pose_b;
    const std::size_t k = rng.below(3);
    const Vec3 n = rng.below(3) ? Vec3{seen.m[k], seen.m[4 + k], seen.m[8 + k]}
                                : Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Vec3 meet = pose_b.apply(farthest(b, pose_b, -n));
    const Pose pose_a = test::moving(turn, farthest(a, turn, n), meet);
    expect_right_overlap_of({Body(Shape(a, {test::awkward_options(rng)}), pose_a),
                             Body(Shape(b, {test::awkward_options(rng)}), pose_b)});
  });
}

TEST(Overlap, GivesTheFirstPairsOfALimit) {
  test::for_each_case("overlap/limit", 200, [](Rng& rng) {
    const Two two = likely_to_meet(rng, 60, 1, 1, 0);
    const Overlap all = twin(two);
    const std::uint64_t limit = rng.below(all.pairs.size() + 2);
    const Overlap some = overlap(two.a, two.b, {.limit = limit});
    ASSERT_EQ(some.pairs.size(), std::min<std::uint64_t>(limit, all.pairs.size()));
    ASSERT_EQ(some.coverage, limit < all.pairs.size() ? Coverage::cut : Coverage::complete);
    ASSERT_EQ(some.any, all.any);
    ASSERT_TRUE(
        std::includes(all.pairs.begin(), all.pairs.end(), some.pairs.begin(), some.pairs.end()));
    const Overlap two_threads = overlap(two.a, two.b, {.limit = limit}, {.threads = 2});
    ASSERT_EQ(two_threads.pairs, some.pairs);
  });
}

TEST(Overlap, TraversesAMillionIdenticalTrianglesInOneLeaf) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.resize(1000000, {0, 1, 2});
  const Body many{Shape(mesh, {thesis_options(Rule::soms)})};
  EXPECT_TRUE(overlap(many, many, {.mode = OverlapMode::any}).any);
  const Overlap some = overlap(many, many, {.limit = 1000});
  EXPECT_EQ(some.pairs.size(), 1000U);
  EXPECT_EQ(some.coverage, Coverage::cut);
  mesh.triangles.resize(1);
  const Body one{mesh};
  const Overlap all = overlap(many, one);
  ASSERT_EQ(all.pairs.size(), 1000000U);
  EXPECT_EQ(all.pairs.back(), (TrianglePair{999999, 0}));
  EXPECT_EQ(overlap(one, many, {}, {.threads = 2}).pairs.size(), 1000000U);
  const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
  EXPECT_EQ(overlap(many, many, {}, {.deadline = soon}).coverage, Coverage::cut);
}

// The normal of the tiny triangle is nearly nothing as floats, and the other body is large.
TEST(Overlap, MeetsATinyTriangleAtTheCornerOfALargeRectangle) {
  const double s = 513802 / 0x1p20;
  const double c = 914067 / 0x1p20;
  const Vec3 corner{5000 * c, 5000 * s, 0};
  const Mesh large = rectangle(corner.x, corner.y);
  Pose pose;
  pose.m = {c, -s, 0, -5000 * (c * c + s * s), s, c, 0, 0, 0, 0, 1, 0};
  ASSERT_EQ(pose.apply(large.vertices[1]).x, 0);
  ASSERT_EQ(pose.apply(large.vertices[1]).y, 0);
  Mesh tiny;
  tiny.vertices = {{0, 0, 0},     {0, 0x1p-74, 0}, {0, 0, 0x1p-75}, {0, 20000, -5}, {0, 20000, 5},
                   {0, 19990, 0}, {0, -20000, -5}, {0, -20000, 5},  {0, -19990, 0}};
  tiny.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const ShapeOptions options{.layout = layout};
    const Body a(Shape(large, options), pose);
    const Body b(Shape(tiny, options));
    const std::vector<TrianglePair> expected = reference::overlap(large, pose, tiny, Pose()).pairs;
    ASSERT_EQ(expected, (std::vector<TrianglePair>{{0, 0}}));
    EXPECT_EQ(overlap(a, b).pairs, expected);
    EXPECT_EQ(overlap(b, a).pairs, expected);
  }
}

TEST(Overlap, EndsInTimeInsideALargeLeafOfACompactShape) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.resize(200000, {0, 1, 2});
  const Body many{Shape(mesh, {.build = thesis_options(Rule::soms), .layout = Layout::compact})};
  Overlap some;
  // All of it takes minutes; on a slow machine a deadline may pass before the first pair.
  for (auto time = std::chrono::milliseconds(20); !some.any; time *= 2) {
    some = overlap(many, many, {}, {.deadline = std::chrono::steady_clock::now() + time});
    ASSERT_EQ(some.coverage, Coverage::cut);
  }
}

TEST(Overlap, R119ALimitThatTheModeIgnoresIsRefused) {
  const Body body{generate_sphere(80)};
  for (const OverlapMode mode : {OverlapMode::any, OverlapMode::first}) {
    try {
      static_cast<void>(overlap(body, body, {.mode = mode, .limit = 5}));
      ADD_FAILURE() << "a limit without effect was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_STREQ(error.what(),
                   "overlap options: limit has no effect: modes any and first return one pair at "
                   "most; leave it at its default, or set mode to all");
    }
    EXPECT_TRUE(overlap(body, body, {.mode = mode}).any);
  }
  EXPECT_EQ(overlap(body, body, {.limit = 5}).pairs.size(), 5U);
}

}  // namespace
}  // namespace soms
