// Faults that other tree builders had, queried for ours. R numbers are those of docs/regressions.
#include "soms/base/error.h"
#include "soms/query/overlap.h"
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/refit.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"

#include "tests/support/slow_build.h"
#include "tests/support/small_stack.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <limits>

namespace soms {
namespace {

/// Debug and sanitizer builds take a tenth of the largest cases, release builds all.
constexpr int kCut = test::kSlowBuild ? 10 : 1;

void add(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
  mesh.triangles.push_back({v, v + 1, v + 2});
}

BuildOptions product(const RuleEntry& rule) {
  BuildOptions options;
  options.rule = rule.rule;
  return options;
}

/// Builds by every rule with the product's options: whole, small leaves, shallow, linear memory.
void expect_sound(const Mesh& mesh) {
  for (const RuleEntry& rule : rules()) {
    SCOPED_TRACE(rule.name);
    const Tree tree = build(mesh, product(rule));
    ASSERT_EQ(find_fault(tree, mesh), "");
    const TreeStatistics s = statistics(tree, product(rule));
    EXPECT_LT(s.depth, 64U);
    EXPECT_LE(s.largest_leaf, 8U);
    EXPECT_LE(s.nodes, 2 * mesh.triangles.size());
  }
}

// R71: a body was stretched, and its outer boxes stayed as they were.
TEST(TreeRegressions, R71AStretchedBoxIsFoundWhereItNowReaches) {
  const auto cube = [](double size) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
      mesh.vertices.push_back({i & 1 ? size : 0, i & 2 ? 1.0 : 0, i & 4 ? 1.0 : 0});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
  };
  for (const RuleEntry& rule : rules()) {
    SCOPED_TRACE(rule.name);
    ShapeOptions options{product(rule), true};
    options.build.per_leaf = 1;
    const Shape shape(cube(1), options);
    const Body other{Shape(cube(1)), Pose::translation(8, 0.5, 0.5)};
    ASSERT_FALSE(overlap(Body{shape}, other).any);
    const Body stretched{refit(shape, cube(10).vertices)};
    EXPECT_TRUE(overlap(stretched, other).any);
    EXPECT_EQ(overlap(stretched, other).pairs, overlap(Body{Shape(cube(10))}, other).pairs);
    EXPECT_EQ(find_fault(*stretched.shape.tree(), stretched.shape.mesh()), "");
    EXPECT_EQ(stretched.shape.bounds().upper.x, 10);
  }
}

// R75: equal centroids ended in endless recursion, or in leaves that overflowed their count.
TEST(TreeRegressions, R75MillionCopiesOfOneTriangle) {
  Mesh mesh;
  mesh.vertices = {{1, 2, 3}, {4, 2, 3}, {1, 5, 3}};
  mesh.triangles.assign(1000000 / kCut, {0, 1, 2});
  expect_sound(mesh);
}

TEST(TreeRegressions, R75HundredThousandConcentricTriangles) {
  Mesh mesh;
  for (int i = 1; i <= 100000 / kCut; ++i) {
    const double r = i;
    add(mesh, {-r, -r, 0}, {r, -r, 0}, {0, r, 0});
  }
  expect_sound(mesh);
}

// R76: one triangle is split off at each level; stacks as deep as the tree ran over.
TEST(TreeRegressions, R76TrianglesAtPowersOfTwoBuildOnASmallStack) {
  Mesh mesh;
  for (int k = 0; k <= 1000; ++k) {
    const double s = std::ldexp(1.0, -k);
    add(mesh, {s, 0, 0}, {s, s, 0}, {s, 0, s});
  }
  test::on_small_stack([&] {
    expect_sound(mesh);
    for (const RuleEntry& rule : rules()) {
      SCOPED_TRACE(rule.name);
      // Without a limit of levels or depth: the deepest trees there are.
      const Tree tree = build(mesh, thesis_options(rule.rule, 0));
      EXPECT_EQ(find_fault(tree, mesh), "");
      const std::uint64_t depth = statistics(tree, thesis_options(rule.rule, 0)).depth;
      EXPECT_TRUE(rule.rule != Rule::soms || depth > 500) << depth;
    }
  });
}

// Many triangles at each power of two: a builder that splits off one level at a time would look
// at each triangle a thousand times.
TEST(TreeRegressions, R76TwoHundredThousandTrianglesAtPowersOfTwoStayShallow) {
  Mesh mesh;
  for (int i = 0; i < 200000 / kCut; ++i) {
    const double s = std::ldexp(1.0, -(i % 1001));
    add(mesh, {s, 0, 0}, {s, s, 0}, {s, 0, s});
  }
  expect_sound(mesh);
}

// R77: a NaN or an infinity ended in an endless loop, a crash or a wild tree.
TEST(TreeRegressions, R77NotFiniteCornersAreNamedBeforeATreeIsBuilt) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Mesh mesh;
      for (int i = 0; i < 20; ++i) {
        add(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      }
      mesh.vertices[3 * 17 + 1][axis] = bad;
      try {
        check(mesh);
        ADD_FAILURE() << "accepted";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::not_finite);
        EXPECT_NE(error.place().find("triangle 17"), std::string::npos) << error.what();
      }
    }
  }
}

// R79: empty and tiny meshes crashed builders or made them loop.
TEST(TreeRegressions, R79ZeroToEightTrianglesAndVerticesWithoutFaces) {
  Mesh mesh;
  mesh.vertices = {{1, 1, 1}, {9, 9, 9}};
  for (int i = 0; i <= 8; ++i) {
    SCOPED_TRACE(i);
    expect_sound(mesh);
    const Tree tree = build(mesh);
    EXPECT_EQ(tree.nodes.empty(), i == 0);
    for (const Node& node : tree.nodes) {
      EXPECT_LT(node.bounds.upper.x, 9);  // the unused vertex does not count
    }
    add(mesh, {0.1 * i, 0, 0}, {0.1 * i + 1, 0, 0}, {0.1 * i, 1, 0});
  }
}

// R80: duplicate or wrapped codes of positions lost nodes or their order.
TEST(TreeRegressions, R80MillionPointsAndCoordinatesAtTheFarEnd) {
  Rng rng(80);
  Mesh mesh;
  for (int i = 0; i < 1000000 / kCut; ++i) {
    const Vec3 p{std::floor(rng.uniform(0, 64)), std::floor(rng.uniform(0, 64)),
                 std::floor(rng.uniform(0, 64))};
    mesh.vertices.push_back(p);
    const auto v = static_cast<std::uint32_t>(i);
    mesh.triangles.push_back({v, v, v});
  }
  const Tree tree = build(mesh);
  EXPECT_EQ(find_fault(tree, mesh), "");
  Mesh far;
  for (int i = 0; i < 5000; ++i) {
    const double s = rng.below(2) == 0 ? 0x1p300 : -0x1p300;
    add(far, {s, s, s}, {s, rng.uniform(-1, 1), s}, {s, s, std::nextafter(s, 0)});
  }
  check(far);
  expect_sound(far);
}

}  // namespace
}  // namespace soms
