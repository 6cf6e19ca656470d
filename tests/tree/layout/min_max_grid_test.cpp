#include "soms/tree/layout/detail/min_max_grid.h"

#include "soms/base/box.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/shape.h"

#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace soms::layout {
namespace {

bool is_clear(const MinMaxGrid& grid, const std::array<double, 3>& center,
              const std::array<double, 3>& half) {
  PlanBox box;
  grid.plan().place(center, half, box);
  return grid.clear(box);
}

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

/// A box about the tree's origin.
struct LocalBox {
  std::array<double, 3> center = {};
  std::array<double, 3> half = {};
};

/// What lies of a polygon within a box, its sides moved inward by what clipping may round.
std::vector<Vec3> clipped(std::vector<Vec3> polygon, const LocalBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const double end = sign * box.center[k] + box.half[k] - 1e-9;
      std::vector<Vec3> left;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& p = polygon[i];
        const Vec3& q = polygon[(i + 1) % polygon.size()];
        const double in_p = end - sign * p[k];
        const double in_q = end - sign * q[k];
        if (in_p >= 0) {
          left.push_back(p);
        }
        if ((in_p >= 0) != (in_q >= 0)) {
          left.push_back(p + (in_p / (in_p - in_q)) * (q - p));
        }
      }
      polygon = left;
    }
  }
  return polygon;
}

/// The twin: a corner of a triangle is in the box, or surely some of its inside is.
bool reaches(const MeshView& mesh, const Vec3& origin, const LocalBox& box) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
    std::vector<Vec3> corners;
    for (const std::uint32_t v : triangle) {
      const Vec3 p = mesh.vertices[v] - origin;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        inside =
            inside && p[k] <= box.center[k] + box.half[k] && p[k] >= box.center[k] - box.half[k];
      }
      if (inside) {
        return true;
      }
      corners.push_back(p);
    }
    return !clipped(corners, box).empty();
  });
}

/// Beside a corner of the mesh, so that they just touch, about a point of a triangle, or anywhere.
LocalBox random_box(Rng& rng, const MeshView& mesh, const Vec3& origin, std::size_t flat) {
  const Box bounds = soms::bounds(mesh);
  LocalBox box;
  const auto& triangle = mesh.triangles[rng.below(mesh.triangles.size())];
  const double u = rng.unit();
  const double v = rng.unit() * (1 - u);
  const Vec3 point = u * mesh.vertices[triangle[0]] + v * mesh.vertices[triangle[1]] +
                     (1 - u - v) * mesh.vertices[triangle[2]];
  const Vec3& corner = mesh.vertices[rng.below(mesh.vertices.size())];
  const std::size_t kind = rng.below(3);
  for (std::size_t k = 0; k < 3; ++k) {
    box.half[k] = 0.3 * std::exp2(-rng.uniform(0, 12)) * (k == flat ? bounds.extent()[k] : 1);
    const double sign = rng.below(2) ? 1 : -1;
    box.center[k] = kind == 0   ? (corner[k] - origin[k]) + sign * box.half[k]
                    : kind == 1 ? (point[k] - origin[k]) + rng.uniform(-1.05, 1.05) * box.half[k]
                                : rng.uniform(bounds.lower[k], bounds.upper[k]) - origin[k];
  }
  return box;
}

/// Long, thin triangles that stand, as walls do, at any angle.
Mesh walls(Rng& rng, std::size_t triangles, std::size_t flat) {
  Mesh mesh;
  const std::size_t a = (flat + 1) % 3;
  const std::size_t b = (flat + 2) % 3;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    Vec3 from;
    from[a] = rng.uniform(-1, 1);
    from[b] = rng.uniform(-1, 1);
    const double angle = rng.below(4) == 0 ? 0 : rng.uniform(0, 3.2);
    const double length = 0.5 * std::exp2(-rng.uniform(0, 8));
    Vec3 to = from;
    to[a] += length * std::cos(angle);
    to[b] += length * std::sin(angle);
    Vec3 top = rng.below(2) ? from : to;
    top[flat] = 0.1 * rng.unit();
    mesh.vertices.insert(mesh.vertices.end(), {from, to, top});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(MinMaxGrid, AreNeverClearWhereATriangleReaches) {
  std::size_t clear = 0;
  std::size_t free = 0;
  std::size_t reached = 0;
  test::for_each_case("columns", 90, [&](Rng& rng) {
    const std::size_t flat = rng.below(3);
    const Shape shape(rng.below(3) == 0 ? walls(rng, 1 + rng.below(300), flat)
                                        : landscape(rng, 1 + rng.below(400), flat,
                                                    0.2 * std::exp2(-rng.uniform(0, 30))));
    const MinMaxGrid& grid = shape.layout().min_max_grid();
    if (grid.empty()) {
      return;
    }
    for (int i = 0; i < 200; ++i) {
      const LocalBox box = random_box(rng, shape.mesh(), shape.layout().origin(), flat);
      const bool meets = reaches(shape.mesh(), shape.layout().origin(), box);
      const bool said = is_clear(grid, box.center, box.half);
      ASSERT_FALSE(meets && said);
      clear += said ? 1U : 0U;
      free += meets ? 0U : 1U;
      reached += meets ? 1U : 0U;
    }
  });
  EXPECT_GT(4 * clear, free) << "of " << free << " boxes that nothing reaches";
  EXPECT_GT(reached, 3000U);
}

// They go into a coarse grid, and from there into all finer ones.
TEST(MinMaxGrid, AreNotClearOfTrianglesOfMoreCellsThanTheyAreEnteredInto) {
  test::for_each_case("columns/wide", 20, [](Rng& rng) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 5000; ++i) {
      const double size = i < 3 ? 1 : 0.01;
      const Vec3 at{rng.uniform(-1, 1), rng.uniform(-1, 1), 0};
      for (int corner = 0; corner < 3; ++corner) {
        mesh.vertices.push_back((i < 3 ? Vec3{} : at) +
                                Vec3{size * rng.uniform(-1, 1), size * rng.uniform(-1, 1),
                                     i < 3 ? 0.2 * rng.unit() : 0.01 * rng.unit()});
      }
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const Shape shape(mesh);
    const MinMaxGrid& grid = shape.layout().min_max_grid();
    ASSERT_FALSE(grid.empty());
    for (int i = 0; i < 500; ++i) {
      const auto& [a, b, c] = mesh.triangles[rng.below(3)];
      const double u = rng.unit();
      const double v = rng.unit() * (1 - u);
      const Vec3 at = u * mesh.vertices[a] + v * mesh.vertices[b] + (1 - u - v) * mesh.vertices[c] -
                      shape.layout().origin();
      const double half = 0.001 + 0.05 * rng.unit();
      ASSERT_FALSE(is_clear(grid, {at.x, at.y, at.z}, {half, half, half}));
    }
  });
}

// A street between two rows of walls: without slices and columns its air is full of their height.
TEST(MinMaxGrid, AreClearInAStreetBetweenWalls) {
  Mesh mesh;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      const Vec3 at{2.0 * i, 2.0 * j, 0};
      add(at, at + Vec3{2, 0, 0}, at + Vec3{2, 2, 0});
      add(at, at + Vec3{2, 2, 0}, at + Vec3{0, 2, 0});
    }
  }
  for (const double y : {90.0, 110.0}) {
    add({0, y, 0}, {200, y, 0}, {200, y, 20});
    add({0, y, 0}, {200, y, 20}, {0, y, 20});
  }
  const Shape shape(mesh);
  const MinMaxGrid& grid = shape.layout().min_max_grid();
  ASSERT_FALSE(grid.empty());
  const Vec3 origin = shape.layout().origin();
  const auto clear = [&](double y, double z) {
    std::size_t count = 0;
    for (int i = 0; i < 100; ++i) {
      const Vec3 at = Vec3{50.0 + i, y, z} - origin;
      count += is_clear(grid, {at.x, at.y, at.z}, {0.5, 0.5, 0.5}) ? 1U : 0U;
    }
    return count;
  };
  EXPECT_EQ(clear(100, 8), 100U) << "in the middle of the street";
  EXPECT_EQ(clear(95, 8), 100U) << "four meters off a wall";
  EXPECT_EQ(clear(90.4, 8), 0U) << "in the wall";
  EXPECT_EQ(clear(100, 0.4), 0U) << "in the ground";
}

TEST(MinMaxGrid, AreTheSameForAnyNumberOfThreads) {
  Rng rng(2);
  const Mesh mesh = landscape(rng, 40'000, 2, 0.05);
  const Shape one(mesh);
  const Shape four(mesh, {}, Limits{.threads = 4});
  ASSERT_FALSE(one.layout().min_max_grid().empty());
  EXPECT_EQ(one.layout().min_max_grid(), four.layout().min_max_grid());
}

TEST(MinMaxGrid, TakeFourBytesATriangle) {
  Rng rng(3);
  const Shape shape(landscape(rng, 40'000, 2, 0.05));
  EXPECT_LT(shape.layout().min_max_grid().memory(), 5 * shape.mesh().triangles.size());
}

}  // namespace
}  // namespace soms::layout
