// What an answer that a deadline cut says of the distance must hold, wherever it was cut.
#include "soms/query/distance.h"
#include "soms/query/within.h"

#include "tests/support/bodies.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms {
namespace {

/// Asks with deadlines of 10 us and more, each a tenth later, until nothing is cut. Returns how
/// many answers were.
template <class Ask>
int ask_until_complete(const Ask& ask) {
  int cut = 0;
  double wait = 10;
  for (bool complete = false; !complete; wait *= 1.1) {
    const auto deadline = std::chrono::steady_clock::now() +
                          std::chrono::microseconds(static_cast<std::int64_t>(wait));
    complete = ask(deadline) == Coverage::complete;
    cut += complete ? 0 : 1;
  }
  return cut;
}

constexpr std::size_t kInLeaf = 4000;

/// Tiny triangles along the edges of a strip, none in its middle.
Mesh strip() {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < kInLeaf; ++i) {
    const double x = 30.0 * static_cast<double>(i) / kInLeaf;
    const double y = i % 2 == 0 ? 0 : 1;
    triangles.push_back({{x, y, 0}, {x + 0.001, y, 0}, {x, y, 0}});
  }
  return test::soup_body(triangles);
}

/// As many at a height of 2, and one point lower.
void add_cluster(double x, const Vec3& low, std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i < kInLeaf; ++i) {
    const Vec3 p{x + static_cast<double>(i) / kInLeaf, 0.5, 2};
    triangles.push_back({p, p, p});
  }
  triangles.push_back({low, low, low});
}

Body in_large_leaves(const Mesh& mesh, std::size_t most = kInLeaf) {
  ShapeOptions options;
  options.build.rule = Rule::spatial_median;
  options.build.per_leaf = static_cast<int>(most);
  return Body(Shape(mesh, options));
}

// Three leaves over a strip, by the distances of their boxes: one of a triangle that is not as
// near, which gives a first distance; the one with the nearest triangle; one with nothing near,
// again. The last two are looked at together, and the nearest triangle waits in a queue until both
// were.
TEST(DistanceCut, BoundsHoldAmongLeaves) {
  const Body a = in_large_leaves(strip());
  std::vector<Triangle> triangles{{{1.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}};
  add_cluster(14, {14.49, 0, 0.55}, triangles);
  add_cluster(28, {28.5, 0.5, 0.6}, triangles);
  const Body b = in_large_leaves(test::soup_body(triangles));
  const Distance whole = distance(a, b);
  EXPECT_EQ(whole.distance, (Bracket{0.55, 0.55}));
  const int cut = ask_until_complete([&](const auto& deadline) {
    const Distance d = distance(a, b, {}, {.deadline = deadline});
    EXPECT_LE(d.distance.lower, 0.55);
    EXPECT_GE(d.distance.upper, 0.55);
    return d.coverage;
  });
  EXPECT_GT(cut, 0);
}

// The nearest triangle is one of three that are equally near in floats. Another is decided first;
// the nearest waits while all of a large leaf, nearly as near as a box, is looked at in vain.
TEST(DistanceCut, BoundsHoldAmongCandidates) {
  constexpr std::size_t kMany = 16000;
  std::vector<Triangle> below;
  for (std::size_t i = 0; i <= 240; ++i) {
    for (const double y : {0.0, 1.0}) {
      const Vec3 p{static_cast<double>(i) / 240, y, 0};
      below.push_back({p, p, p});
    }
  }
  const auto point = [](double x, double y, double z) {
    return Triangle{{x, y, z}, {x, y, z}, {x, y, z}};
  };
  std::vector<Triangle> above{point(0.45, 0, 20 + 1e-8), point(0.5, 0, 20),
                              point(0.55, 0, 20 + 1e-8)};
  for (std::size_t i = 0; i < kMany; ++i) {
    above.push_back(point(0.45 + 0.1 * static_cast<double>(i) / kMany, 0.5, 20.00024));
  }
  const Body a = in_large_leaves(test::soup_body(below), kMany);
  const Body b = in_large_leaves(test::soup_body(above), kMany);
  EXPECT_EQ(distance(a, b).distance, (Bracket{20, 20}));
  const int cut = ask_until_complete([&](const auto& deadline) {
    const Distance d = distance(a, b, {}, {.deadline = deadline});
    EXPECT_LE(d.distance.lower, 20);
    EXPECT_GE(d.distance.upper, 20);
    return d.coverage;
  });
  EXPECT_GT(cut, 0);
}

}  // namespace
}  // namespace soms
