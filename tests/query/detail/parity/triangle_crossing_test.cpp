#include "soms/query/detail/parity/triangle_crossing.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace soms::detail {
namespace {

/// The point with its coordinates turned so that x becomes `axis`.
Vec3 turned(const Vec3& p, std::size_t axis) {
  Vec3 q;
  for (std::size_t k = 0; k < 3; ++k) {
    q[(k + axis) % 3] = p[k];
  }
  return q;
}

/// The hit of a ray along x, which must be that along y and z of what is turned alike, and of all
/// orders of the corners.
RayHit hit(const Triangle& t, const Vec3& p, bool forward) {
  bool exact = false;
  const RayHit first = triangle_crossing(t, p, 0, forward, exact);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Triangle s{turned(t.a, axis), turned(t.b, axis), turned(t.c, axis)};
    for (const Triangle& order : {s, Triangle{s.b, s.c, s.a}, Triangle{s.c, s.a, s.b},
                                  Triangle{s.b, s.a, s.c}, Triangle{s.a, s.c, s.b}}) {
      EXPECT_EQ(triangle_crossing(order, turned(p, axis), axis, forward, exact), first);
    }
  }
  return first;
}

const Triangle kWall{{1, 0, 0}, {1, 4, 0}, {1, 0, 4}};

TEST(TriangleCrossing, TellsAheadFromBehind) {
  EXPECT_EQ(hit(kWall, {0, 1, 1}, true), RayHit::cross);
  EXPECT_EQ(hit(kWall, {0, 1, 1}, false), RayHit::miss);
  EXPECT_EQ(hit(kWall, {2, 1, 1}, true), RayHit::miss);
  EXPECT_EQ(hit(kWall, {2, 1, 1}, false), RayHit::cross);
  EXPECT_EQ(hit(kWall, {0, 3, 3}, true), RayHit::miss);
}

TEST(TriangleCrossing, KnowsPointsOfTheTriangle) {
  for (const Vec3& p : {Vec3{1, 1, 1}, Vec3{1, 0, 0}, Vec3{1, 2, 2}, Vec3{1, 0, 4}}) {
    EXPECT_EQ(hit(kWall, p, true), RayHit::on);
    EXPECT_EQ(hit(kWall, p, false), RayHit::on);
  }
  EXPECT_EQ(hit(kWall, {1, 3, 3}, true), RayHit::miss);
  const Triangle along{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}};  // parallel to x
  EXPECT_EQ(hit(along, {1, 0, 1}, true), RayHit::on);
  EXPECT_EQ(hit(along, {3, 0, 3}, true), RayHit::miss);
  EXPECT_EQ(hit(along, {-1, 0, 1}, true), RayHit::miss);
  const Triangle segment{{0, 0, 0}, {4, 2, 6}, {2, 1, 3}};
  EXPECT_EQ(hit(segment, {2, 1, 3}, true), RayHit::on);
  EXPECT_EQ(hit(segment, {4, 2, 6}, true), RayHit::on);
  EXPECT_EQ(hit(segment, {6, 3, 9}, true), RayHit::miss);
  EXPECT_EQ(hit(segment, {0, 1, 3}, true), RayHit::miss);
  const Triangle point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(hit(point, {1, 2, 3}, true), RayHit::on);
  EXPECT_EQ(hit(point, {0, 2, 3}, true), RayHit::miss);
}

/// Triangles around (1, 0, 0) in the plane x = 1, between neighbors of `rim`.
template <std::size_t N>
int crossings_of_fan(const std::array<Vec3, N>& rim) {
  int crossings = 0;
  for (std::size_t i = 0; i < N; ++i) {
    bool exact = false;
    const Triangle t{{1, 0, 0}, rim[i], rim[(i + 1) % N]};
    crossings += triangle_crossing(t, {0, 0, 0}, 0, true, exact) == RayHit::cross ? 1 : 0;
  }
  return crossings;
}

// A ray through a corner crosses one of the triangles around it, and each edge belongs to one side.
TEST(TriangleCrossing, CrossesAFanOnceThroughItsMiddle) {
  EXPECT_EQ(
      crossings_of_fan(std::array{Vec3{1, 1, 0}, Vec3{1, 0, 1}, Vec3{1, -1, 0}, Vec3{1, 0, -1}}),
      1);
  EXPECT_EQ(crossings_of_fan(std::array{Vec3{1, 3, 1}, Vec3{2, -1, 2}, Vec3{0, -1, -5}}), 1);
  EXPECT_EQ(crossings_of_fan(std::array{Vec3{0, 5, 0}, Vec3{3, 5, 1}, Vec3{1, 0, 7}, Vec3{1, -3, 0},
                                        Vec3{9, -3, -1}}),
            1);
}

// Two triangles fold at an edge through the ray: both are crossed, or none.
TEST(TriangleCrossing, CrossesAFoldEvenly) {
  for (const Vec3& edge : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 1}, Vec3{0, -1, 2}}) {
    for (const Vec3& apex : {Vec3{1, 2, 0}, Vec3{1, -2, 0}, Vec3{1, 0, 2}, Vec3{1, 0, -2}}) {
      const Vec3 from = Vec3{1, 0, 0} - edge;
      const Vec3 to = Vec3{1, 0, 0} + edge;
      bool exact = false;
      const auto hits = [&](const Vec3& p) {
        return triangle_crossing({from, to, p}, {0, 0, 0}, 0, true, exact);
      };
      EXPECT_EQ(hits(apex), hits(apex + Vec3{1, 0, 0}));
    }
  }
}

}  // namespace
}  // namespace soms::detail
