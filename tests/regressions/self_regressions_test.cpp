// Faults that users of other libraries reported, as far as they speak of a mesh and itself.
#include "soms/query/reference/self_overlap.h"
#include "soms/query/self_overlap.h"

#include "tests/regressions/cube.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// Each triangle cut into four at the midpoints of its edges, as they are rounded.
Mesh quartered(const Mesh& mesh) {
  Mesh cut;
  cut.vertices = mesh.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(cut.vertices.size());
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) {
      cut.vertices.push_back(0.5 * (cut.vertices[a] + cut.vertices[b]));
    }
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    cut.triangles.insert(cut.triangles.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return cut;
}

// A triangle of floats, cut twice into 16 by its midpoints, and the same at other scales.
TEST(Regression, R83ACutTriangleDoesNotCrossItselfAtAnyScale) {
  test::for_each_case("regressions/R83", 81, [](Rng& rng) {
    const auto point = [&] {
      const auto part = [&] { return static_cast<double>(static_cast<float>(rng.uniform(-1, 1))); };
      return Vec3{part(), part(), part()};
    };
    const Mesh cut = quartered(quartered(test::soup_body({{point(), point(), point()}})));
    ASSERT_EQ(cut.triangles.size(), 16U);
    for (const double scale : {1.0, 10.0, 0.1, std::exp2(rng.uniform(-200, 200))}) {
      const Mesh mesh = test::mapped(cut, [&](const Vec3& v) { return scale * v; });
      const SelfOverlap answer = self_overlap(Shape(mesh));
      ASSERT_EQ(answer.pairs, reference::self_overlap(mesh).pairs);
      ASSERT_FALSE(answer.any) << scale;
    }
  });
}

/// Triangles of a fan around vertex 0, next to each other or not.
Mesh fan() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}};
  constexpr std::uint32_t kRim = 8;
  for (std::uint32_t k = 0; k < kRim; ++k) {
    const double angle = 0.75 * k;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0.1 * k});
  }
  for (std::uint32_t k = 1; k < kRim; ++k) {
    mesh.triangles.push_back({0, k, k + 1});
  }
  return mesh;
}

// A fan has none; a bow tie, whose triangles share a corner and pierce each other elsewhere, one;
// the cube as a soup has its 48 touches by index, and none by position.
TEST(Regression, R84NeighborsAreNeitherReportedNorSkipped) {
  EXPECT_FALSE(self_overlap(Shape(fan())).any);
  Mesh tie;
  tie.vertices = {{0, 0, 0}, {4, 1, 0}, {4, -1, 0}, {3, 0, 1}, {3, 0, -1}};
  tie.triangles = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(self_overlap(Shape(tie)).pairs, (std::vector<TrianglePair>{{0, 1}}));
  const Mesh cube = test::cube();
  EXPECT_FALSE(self_overlap(Shape(cube)).any);
  std::vector<Triangle> triangles;
  for (TriangleId i = 0; i < cube.triangles.size(); ++i) {
    triangles.push_back(cube.triangle(i));
  }
  const Shape soup(test::soup_body(triangles));
  EXPECT_EQ(self_overlap(soup).pairs.size(), 48U);
  EXPECT_FALSE(self_overlap(soup, {.by = CommonCorners::position}).any);
}

}  // namespace
}  // namespace soms
