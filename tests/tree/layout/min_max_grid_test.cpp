#include "soms/tree/layout/min_max_grid.h"

#include "soms/base/box.h"
#include "soms/tree/layout/wide_tree.h"
#include "soms/tree/shape.h"

#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace soms::layout {
namespace {

/// Triangles of all sizes over a flat box, its least axis `flat`.
Mesh landscape(Rng& rng, std::size_t triangles, std::size_t flat, double height) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Vec3 at;
    const double size = std::exp2(-rng.uniform(0, 10));
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = rng.uniform(-1, 1);
    }
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 v;
      for (std::size_t k = 0; k < 3; ++k) {
        v[k] = (at[k] + size * rng.uniform(-1, 1)) * (k == flat ? height : 1);
      }
      mesh.vertices.push_back(v);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(MinMaxGrid, AreMadeForFlatMeshesOnly) {
  Rng rng(1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_FALSE(Shape(landscape(rng, 100, axis, 0.1)).layout().min_max_grid().empty());
    EXPECT_TRUE(Shape(landscape(rng, 100, axis, 1)).layout().min_max_grid().empty());
    EXPECT_FALSE(Shape(landscape(rng, 100, axis, 0)).layout().min_max_grid().empty());
  }
  EXPECT_TRUE(Shape(Mesh{}).layout().min_max_grid().empty());
  Mesh line = landscape(rng, 100, 0, 0);
  for (Vec3& v : line.vertices) {
    v.y = 0;
  }
  EXPECT_TRUE(Shape(line).layout().min_max_grid().empty()) << "a line has no ground plan";
}

TEST(MinMaxGrid, AreNeverClearWhereATriangleReaches) {
  std::size_t clear = 0;
  std::size_t free = 0;
  test::for_each_case("columns", 60, [&](Rng& rng) {
    const std::size_t flat = rng.below(3);
    const Shape shape(
        landscape(rng, 1 + rng.below(400), flat, 0.2 * std::exp2(-rng.uniform(0, 30))));
    const MinMaxGrid& min_max_grid = shape.layout().min_max_grid();
    if (min_max_grid.empty()) {
      return;
    }
    const Mesh& mesh = shape.mesh();
    const Vec3 origin = shape.layout().origin();
    const Box bounds = shape.bounds();
    for (int i = 0; i < 200; ++i) {
      std::array<double, 3> center = {};
      std::array<double, 3> half = {};
      // Beside a corner of the mesh, so that boxes just touch, or anywhere.
      const Vec3& corner = mesh.vertices[rng.below(mesh.vertices.size())];
      const bool beside = rng.below(2) == 0;
      for (std::size_t k = 0; k < 3; ++k) {
        half[k] = 0.3 * std::exp2(-rng.uniform(0, 12)) * (k == flat ? bounds.extent()[k] : 1);
        const double sign = rng.below(2) ? 1 : -1;
        center[k] = beside ? (corner[k] - origin[k]) + sign * half[k]
                           : rng.uniform(bounds.lower[k], bounds.upper[k]) - origin[k];
      }
      bool meets = false;
      for (const auto& triangle : mesh.triangles) {
        bool meet = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [least, most] =
              std::minmax({mesh.vertices[triangle[0]][k], mesh.vertices[triangle[1]][k],
                           mesh.vertices[triangle[2]][k]});
          meet = meet && least - origin[k] <= center[k] + half[k] &&
                 most - origin[k] >= center[k] - half[k];
        }
        meets = meets || meet;
      }
      const bool said = min_max_grid.clear(center, half);
      ASSERT_FALSE(meets && said);
      clear += said ? 1U : 0U;
      free += meets ? 0U : 1U;
    }
  });
  EXPECT_GT(10 * clear, free) << "of " << free << " boxes that nothing reaches";
}

TEST(MinMaxGrid, AreTheSameForAnyNumberOfThreads) {
  Rng rng(2);
  const Mesh mesh = landscape(rng, 40'000, 2, 0.05);
  const Shape one(mesh);
  const Shape four(mesh, {}, Parallel{4, {}, {}});
  ASSERT_FALSE(one.layout().min_max_grid().empty());
  EXPECT_EQ(one.layout().min_max_grid(), four.layout().min_max_grid());
}

TEST(MinMaxGrid, TakeThreeBytesATriangle) {
  Rng rng(3);
  const Shape shape(landscape(rng, 40'000, 2, 0.05));
  EXPECT_LT(shape.layout().min_max_grid().memory(), 4 * shape.mesh().triangles.size());
}

}  // namespace
}  // namespace soms::layout
