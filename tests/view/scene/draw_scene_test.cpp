#include "apps/view/scene/draw_scene.h"

#include "soms/geometry/triangle_overlap.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace soms::view {
namespace {

Body box_at(const Vec3& lower, const Vec3& upper, const std::string& name, int cuts = 2) {
  Body body(test::box_body(lower, upper, cuts));
  body.name = name;
  return body;
}

/// Two cubes of side 2; the second is moved by hand.
ViewScene cubes() {
  return ViewScene(
      two_bodies(box_at({0, 0, 0}, {2, 2, 2}, "still"), box_at({0, 0, 0}, {2, 2, 2}, "moving")));
}

bool same(const Triangle& a, const Triangle& b) {
  return a == b;
}

std::size_t count(const std::vector<TriangleMark>& marks, const Triangle& t) {
  return static_cast<std::size_t>(std::count_if(
      marks.begin(), marks.end(), [&](const TriangleMark& m) { return same(m.corners, t); }));
}

/// Every triangle of every body is red exactly if it touches one of another body, by brute force.
void expect_red_where_touching(ViewScene& scene) {
  const DrawList list = make_draw_list(scene, {});
  check(list);
  const BodyRef a = city_part(0);
  const BodyRef b = mover(0);
  std::size_t touching = 0;
  for (const auto& [of, other] : {std::pair(a, b), std::pair(b, a)}) {
    for (TriangleId i = 0; i < scene.body(of).shape.mesh().triangles.size(); ++i) {
      const Triangle t = scene.triangle(of, i);
      bool touches = false;
      for (TriangleId j = 0; j < scene.body(other).shape.mesh().triangles.size(); ++j) {
        touches = touches || triangles_overlap(t, scene.triangle(other, j));
      }
      EXPECT_EQ(count(list.marks, t) > 0, touches);
      touching += touches ? 1U : 0U;
    }
  }
  for (const TriangleMark& mark : list.marks) {
    EXPECT_EQ(mark.color, ViewColors{}.contact);
  }
  EXPECT_LE(list.marks.size(), touching);  // triangles that coincide are marked for each body
}

TEST(DrawScene, MarksTouchingTrianglesAndNoOthers) {
  ViewScene scene = cubes();
  for (const double x : {0.0, 0.7, 1.0, 2.0, 2.5}) {
    scene.set_pose(0, Pose::translation(x, 0.3, 0.1));
    expect_red_where_touching(scene);
  }
  scene.set_pose(0, Pose::about_z(0.4, {1.2, 0.5, 0.3}));
  expect_red_where_touching(scene);
}

TEST(DrawScene, DrawsNothingRedWhereNothingTouches) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(5, 0, 0));
  const DrawList list = make_draw_list(scene, {});
  EXPECT_TRUE(list.marks.empty());
  EXPECT_TRUE(list.lines.empty());
  EXPECT_TRUE(list.points.empty());
  EXPECT_EQ(list.instances.size(), 2U);
  EXPECT_EQ(list.instances[1].pose, Pose::translation(5, 0, 0));
}

}  // namespace
}  // namespace soms::view
