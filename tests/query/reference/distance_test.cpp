#include "soms/query/reference/distance.h"

#include "soms/base/error.h"
#include "soms/geometry/triangle_distance.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Loose triangles with corners at whole numbers from 0 to `size`, so that many pairs tie.
Mesh loose_triangles(Rng& rng, std::size_t count, std::uint64_t size) {
  Mesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.push_back({static_cast<double>(rng.below(size + 1)),
                               static_cast<double>(rng.below(size + 1)),
                               static_cast<double>(rng.below(size + 1))});
    }
    const auto first = static_cast<std::uint32_t>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Every pair by brackets: the least (i, j) whose bracket is the least. Brackets of distances that
/// differ may be equal, but not those of such short whole numbers.
Distance by_brackets(const Mesh& a, const Mesh& b, const Vec3& offset) {
  Distance best;
  best.distance = {kInfinity, kInfinity};
  for (TriangleId i = 0; i < a.triangles.size(); ++i) {
    for (TriangleId j = 0; j < b.triangles.size(); ++j) {
      const Triangle t = b.triangle(j);
      const Triangle moved{t.a + offset, t.b + offset, t.c + offset};
      const TriangleDistance here = triangle_distance(a.triangle(i), moved);
      if (here.distance.upper < best.distance.upper) {
        best.distance = here.distance;
        best.triangles = {i, j};
        best.point_a = here.point_a;
        best.point_b = here.point_b;
      }
    }
  }
  return best;
}

TEST(ReferenceDistance, IsTheLeastOfAllPairs) {
  int apart = 0;
  test::for_each_case("reference-distance/pairs", 60, [&](Rng& rng) {
    const Mesh a = loose_triangles(rng, 1 + rng.below(20), 6);
    const Mesh b = loose_triangles(rng, 1 + rng.below(40), 6);
    const Vec3 offset{static_cast<double>(rng.below(20)), static_cast<double>(rng.below(3)), 0};
    const Distance expected = by_brackets(a, b, offset);
    const Body first(a);
    const Body second(b, Pose::translation(offset.x, offset.y, offset.z));
    const Distance found = reference::distance_by_brute_force(first, second);
    EXPECT_EQ(found.distance, expected.distance);
    EXPECT_EQ(found.triangles, expected.triangles);
    EXPECT_EQ(found.point_a, expected.point_a);
    EXPECT_EQ(found.point_b, expected.point_b);
    EXPECT_EQ(reference::distance_by_brute_force(second, first).distance, expected.distance);
    EXPECT_EQ(reference::distance_by_brute_force(first, second, {.threads = 3}), found);
    EXPECT_EQ(found.coverage, Coverage::complete);
    const auto within = [&](double clearance) {
      return reference::within_by_brute_force(first, second, clearance);
    };
    EXPECT_TRUE(within(expected.distance.upper));
    EXPECT_TRUE(within(kInfinity));
    EXPECT_EQ(within(0), expected.distance.upper == 0);
    EXPECT_EQ(within(expected.distance.lower), expected.distance.lower == expected.distance.upper);
    apart += expected.distance.upper > 0 ? 1 : 0;
  });
  EXPECT_GT(apart, 20);
}

TEST(ReferenceDistance, LeavesOutOnlyWhatIsFarther) {
  test::for_each_case("reference-distance/skips", 10, [](Rng& rng) {
    const Mesh a = loose_triangles(rng, 40, 60);
    const Mesh b = loose_triangles(rng, 40, 60);
    const Body second(b, Pose::translation(100, 0, 0));
    const Distance found = reference::distance_by_brute_force(Body(a), second);
    EXPECT_EQ(found.distance, by_brackets(a, b, {100, 0, 0}).distance);
    EXPECT_EQ(found.cost.node_tests, 1600U);
    EXPECT_LT(found.cost.triangle_tests, 1600U);
    EXPECT_EQ(found.cost.exact_tests, found.cost.triangle_tests);
  });
}

TEST(ReferenceDistance, OfNothingIsInfinite) {
  const Body nothing;
  Rng rng(1);
  const Body something(loose_triangles(rng, 2, 3));
  const Distance found = reference::distance_by_brute_force(nothing, something);
  EXPECT_EQ(found.distance, (Bracket{kInfinity, kInfinity}));
  EXPECT_FALSE(found.triangles);
  EXPECT_FALSE(reference::within_by_brute_force(something, nothing, kInfinity));
}

TEST(ReferenceDistance, RefusesAClearanceThatIsNone) {
  for (const double clearance : {-1.0, -kInfinity, std::nan("")}) {
    try {
      static_cast<void>(reference::within_by_brute_force({}, {}, clearance));
      FAIL() << clearance;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

Pose pose_of(const std::vector<std::string>& line, std::size_t field) {
  Pose pose;
  for (double& entry : pose.m) {
    entry = std::strtod(line.at(field++).c_str(), nullptr);
  }
  return pose;
}

// Cases of up to 40,000 pairs of triangles, every fifth.
TEST(ReferenceDistance, IsTheTruthOfPosedMeshes) {
  SOMS_NEEDS_OUTSIDE_DATA("the brute-force twin on some 100 posed cases");
  const auto lines = test::read_csv(*test::outside_data("distance/cases.csv"));
  int tried = 0;
  constexpr std::size_t kStride = test::kSlowBuild ? 25 : 5;  // brute force
  for (std::size_t i = 1; i < lines.size(); i += kStride) {
    const std::vector<std::string>& line = lines[i];
    const Mesh* const a = test::truth_mesh(line.at(1));
    const Mesh* const b = test::truth_mesh(line.at(2));
    if (a == nullptr || b == nullptr || a->triangles.size() * b->triangles.size() > 40000) {
      continue;
    }
    SCOPED_TRACE("case " + line.at(0) + ", " + line.at(3));
    const auto number = [&](std::size_t field) {
      return std::strtod(line.at(field).c_str(), nullptr);
    };
    const auto id = [&](std::size_t field) { return static_cast<TriangleId>(number(field)); };
    const Body first(*a, pose_of(line, 4));
    const Body second(*b, pose_of(line, 16));
    const Distance found = reference::distance_by_brute_force(first, second);
    ASSERT_EQ(found.distance, (Bracket{number(28), number(29)}));
    ASSERT_EQ(found.triangles, (TrianglePair{id(31), id(32)}));
    const Distance exchanged = reference::distance_by_brute_force(second, first);
    ASSERT_EQ(exchanged.triangles, (TrianglePair{id(37), id(36)}));
    ASSERT_EQ(reference::within_by_brute_force(first, second, number(28)), line.at(33) == "1");
    ASSERT_TRUE(reference::within_by_brute_force(first, second, number(29)));
    if (!line.at(35).empty()) {
      ASSERT_EQ(reference::within_by_brute_force(first, second, std::nextafter(number(28), 0)),
                line.at(35) == "1");
    }
    ++tried;
  }
  EXPECT_GT(tried, test::kSlowBuild ? 15 : 80);
}

}  // namespace
}  // namespace soms
