// What `solid` looks at where many triangles meet one: counted, not timed.
#include "soms/query/detail/solid/solid_regions.h"
#include "soms/query/solid.h"

#include "tests/support/bodies.h"
#include "tests/support/slow_build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

namespace soms {
namespace {

using test::box_body;
using test::joined;

const Mesh kSlab = box_body({-1, -1, 1}, {3, 3, 2});

/// Its faces are n x n squares.
Mesh fine_plate(int n) {
  return box_body({0, 0, 0}, {1, 1, 1}, n);
}

/// n x n columns from 0 to `top`.
Mesh columns(int n, double top) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.01 * ((7 * j) % 11)) / n;
      const double y = (j + 0.01 * ((5 * i) % 11)) / n;
      mesh = joined(std::move(mesh), box_body({x, y, 0}, {x + 0.5 / n, y + 0.5 / n, top}));
    }
  }
  return mesh;
}

/// A prism of n sides whose ends are fans.
Mesh prism(int n, double bottom, double top, double turn) {
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n + turn;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), bottom});
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), top});
  }
  const auto corner = [&](int i, int end) { return static_cast<std::uint32_t>(2 * (i % n) + end); };
  for (int i = 0; i < n; ++i) {
    mesh.triangles.push_back({corner(i, 0), corner(i + 1, 0), corner(i + 1, 1)});
    mesh.triangles.push_back({corner(i, 0), corner(i + 1, 1), corner(i, 1)});
    if (0 < i && i < n - 1) {
      mesh.triangles.push_back({corner(0, 1), corner(i, 1), corner(i + 1, 1)});
      mesh.triangles.push_back({corner(0, 0), corner(i + 1, 0), corner(i, 0)});
    }
  }
  return mesh;
}

/// Triangles in exact arithmetic of two bodies that touch.
std::uint64_t exact_tests(const Mesh& a, const Mesh& b) {
  const Solid answer = solid(Body(a), Body(b));
  EXPECT_EQ(answer.relation, Relation::touching);
  return answer.cost.exact_tests;
}

using MeshOfSize = std::function<Mesh(int)>;

/// Twice the size is so many times the work, and hardly more.
void expect_growth(const MeshOfSize& a, const MeshOfSize& b, int n, double times) {
  const auto small = static_cast<double>(exact_tests(a(n), b(n)));
  const auto large = static_cast<double>(exact_tests(a(2 * n), b(2 * n)));
  EXPECT_LT(large, 1.1 * times * small) << n;
}

Mesh slab(int /*n*/) {
  return kSlab;
}

constexpr int kSquares = test::kSlowBuild ? 8 : 14;

TEST(SolidGrowth, OfAFineFaceOnALargeOneIsItsSize) {
  expect_growth(fine_plate, slab, kSquares, 4);
  expect_growth(slab, fine_plate, kSquares, 4);
}

TEST(SolidGrowth, OfColumnsOnASlabIsTheirNumber) {
  const auto columns_to_slab = [](int n) { return columns(n, 1); };
  expect_growth(columns_to_slab, slab, kSquares, 4);
  expect_growth(slab, columns_to_slab, kSquares, 4);
}

// They pierce the large face of their own body, which the other one touches.
TEST(SolidGrowth, OfColumnsThroughASlabIsTheirNumber) {
  const auto pierced = [](int n) {
    return joined(columns(n, 1.5), box_body({-1, -1, 0.5}, {3, 3, 1}));
  };
  expect_growth(
      pierced,
      [](int) {
        return box_body({2, 2, 1}, {3, 3, 2});
      },
      kSquares, 4);
}

TEST(SolidGrowth, OfAFanOnALargeFaceIsItsSize) {
  expect_growth([](int n) { return prism(n, 0, 1, 0); }, slab, 10 * kSquares, 2);
}

// Each sliver of one fan meets most of the other.
TEST(SolidGrowth, OfAFanOnAFanIsTheNumberOfTheirPairs) {
  expect_growth([](int n) { return prism(n, 0, 1, 0); },
                [](int n) { return prism(n, 1, 2, 0.001); }, 4 * kSquares, 4);
}

/// How often a search of all triangles of the slab asks whether to stop: at each cell, mostly.
std::uint64_t questions_of_slab(const Mesh& mesh) {
  const Body a(mesh);
  const Body b(kSlab);
  std::uint64_t questions = 0;
  detail::RegionSearch search(a, b, [&] {
    ++questions;
    return false;
  });
  detail::SolidRegions regions;
  for (TriangleId id = 0; id < kSlab.triangles.size(); ++id) {
    search.look_at(1, id, regions);
  }
  return questions;
}

// Of 2 n^2 triangles in the face of the slab only the rim cuts it.
TEST(SolidGrowth, InnerEdgesOfAFineFaceCutNothing) {
  for (const int n : {10, 20, 40}) {
    EXPECT_LT(questions_of_slab(fine_plate(n)), static_cast<std::uint64_t>(4 * n + 20));
  }
}

TEST(SolidGrowth, ASearchStopsWithinATriangle) {
  const Body a(columns(kSquares, 1));
  const Body b(kSlab);
  for (const int most : {1, 5, 20}) {
    int questions = 0;
    detail::RegionSearch search(a, b, [&] { return ++questions > most; });
    detail::SolidRegions regions;
    for (TriangleId id = 0; id < kSlab.triangles.size() && questions <= most; ++id) {
      search.look_at(1, id, regions);
    }
    EXPECT_GT(questions, most);
    EXPECT_LE(questions, most + 4);
    EXPECT_LT(search.cost().exact_tests, static_cast<std::uint64_t>(300 * (most + 1)));
  }
}

}  // namespace
}  // namespace soms
