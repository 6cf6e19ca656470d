#include "soms/geometry/triangle_overlap.h"

#include "soms/base/error.h"
#include "soms/geometry/mesh.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

namespace soms {
namespace {

constexpr std::array<std::array<std::size_t, 3>, 6> kPermutations{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

Triangle permuted(const Triangle& t, const std::array<std::size_t, 3>& order) {
  const std::array corners{t.a, t.b, t.c};
  return {corners[order[0]], corners[order[1]], corners[order[2]]};
}

/// Checks an answer in all 72 orders of arguments and corners.
void expect_in_all_orders(const Triangle& s, const Triangle& t, bool expected) {
  for (const auto& first : kPermutations) {
    for (const auto& second : kPermutations) {
      const Triangle p = permuted(s, first);
      const Triangle q = permuted(t, second);
      ASSERT_EQ(triangles_overlap(p, q), expected);
      ASSERT_EQ(triangles_overlap(q, p), expected);
    }
  }
}

constexpr Triangle kGround{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleOverlap, SeesACrossing) {
  expect_in_all_orders(kGround, {{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}, true);
  expect_in_all_orders(kGround, {{3, 3, -1}, {3, 3, 1}, {4, 4, 1}}, false);
}

TEST(TriangleOverlap, CountsTouchingAtCornerEdgeAndFace) {
  expect_in_all_orders(kGround, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, true);
  expect_in_all_orders(kGround, {{4, 0, 0}, {5, 0, 1}, {5, 1, 1}}, true);
  expect_in_all_orders(kGround, {{2, -1, -1}, {2, 1, 1}, {9, -8, 8}}, true);
  expect_in_all_orders(kGround, {{1, 0, 0}, {3, 0, 0}, {2, -1, 5}}, true);
  expect_in_all_orders(kGround, {{1, 1, 0x1p-60}, {1, 1, 1}, {2, 1, 1}}, false);
}

TEST(TriangleOverlap, SeesCoplanarTriangles) {
  expect_in_all_orders(kGround, kGround, true);
  expect_in_all_orders(kGround, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, true);
  expect_in_all_orders(kGround, {{2, 2, 0}, {4, 4, 0}, {4, 3, 0}}, true);
  expect_in_all_orders(kGround, {{2, std::nextafter(2, 3), 0}, {4, 4, 0}, {4, 3, 0}}, false);
  expect_in_all_orders(kGround, {{-1, -1, 0}, {5, -1, 0}, {2, 9, 0}}, true);
  expect_in_all_orders(kGround, {{-1, -1, 1}, {5, -1, 1}, {2, 9, 1}}, false);
}

TEST(TriangleOverlap, TakesTrianglesWithoutAreaAsSegmentsAndPoints) {
  const Triangle segment{{1, 1, -1}, {1, 1, 1}, {1, 1, 0}};
  const Triangle inside{{0, 0, 0}, {3, 0, 0}, {1, 0, 0}};
  const Triangle point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  expect_in_all_orders(kGround, segment, true);
  expect_in_all_orders(kGround, inside, true);
  expect_in_all_orders(kGround, point, true);
  expect_in_all_orders(segment, point, true);
  expect_in_all_orders(point, point, true);
  expect_in_all_orders(segment, {{0, 1, 0.5}, {0, 1, 0.5}, {2, 1, 0.5}}, true);
  expect_in_all_orders(segment, {{1, 1, 1}, {1, 1, 2}, {1, 1, 5}}, true);
  expect_in_all_orders(segment, {{1, 1, 1.5}, {1, 1, 2}, {1, 1, 5}}, false);
  expect_in_all_orders(segment, {{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}, false);
  expect_in_all_orders(kGround, {{3, 3, 0}, {3, 3, 0}, {3, 3, 0}}, false);
  expect_in_all_orders(kGround, {{3, 3, 0}, {5, 5, 0}, {4, 4, 0}}, false);
  expect_in_all_orders(inside, {{2, -1, 0.5}, {2, 1, 0.5}, {2, 0, 0.5}}, false);
}

TEST(TriangleOverlap, ReportsExactTestsOnlyWhenAFilterLeftASignOpen) {
  std::uint64_t exact = 0;
  EXPECT_TRUE(triangles_overlap(kGround, {{1, 1, -1}, {1, 1, 1}, {2, 1, 2}}, &exact));
  EXPECT_FALSE(triangles_overlap(kGround, {{1, 1, 1}, {1, 1, 2}, {2, 1, 2}}, &exact));
  EXPECT_EQ(exact, 0U);
  EXPECT_TRUE(triangles_overlap(kGround, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, &exact));
  EXPECT_EQ(exact, 1U);
  EXPECT_TRUE(triangles_overlap(kGround, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, &exact));
  EXPECT_EQ(exact, 2U);
}

// 27,900 single pairs decided by four exact methods; those beyond 2^300 stop at the door.
TEST(TriangleOverlap, AgreesWithTheTruthSetInAllOrders) {
  std::map<std::string, int> seen;
  for (const test::TruthTriangles& pair : test::truth_triangles()) {
    ++seen[pair.kind];
    SCOPED_TRACE(pair.kind + ", number " + std::to_string(seen[pair.kind]));
    if (pair.kind == "huge") {
      Mesh mesh;
      mesh.vertices = {pair.s.a, pair.s.b, pair.s.c, pair.t.a, pair.t.b, pair.t.c};
      mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
      try {
        check(mesh);
        FAIL() << "a coordinate beyond 2^300 was let in";
      } catch (const Error& error) {
        ASSERT_EQ(error.kind(), ErrorKind::out_of_range);
      }
    } else {
      expect_in_all_orders(pair.s, pair.t, pair.overlap);
    }
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_EQ(seen.size(), 10U);
  EXPECT_EQ(test::truth_triangles().size(), 27900U);
}

}  // namespace
}  // namespace soms
