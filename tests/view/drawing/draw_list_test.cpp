#include "apps/view/drawing/draw_list.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

namespace soms::view {
namespace {

std::shared_ptr<const Mesh> one_triangle() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {50, 50, 50}};
  mesh.triangles = {{0, 1, 2}};
  return std::make_shared<const Mesh>(std::move(mesh));
}

TEST(DrawList, BoundsHoldEverythingInIt) {
  DrawList list;
  EXPECT_TRUE(bounds(list).empty());
  list.meshes.push_back({1, 0, one_triangle(), nullptr});
  EXPECT_TRUE(bounds(list).empty()) << "a mesh without instances is not seen";
  list.instances.push_back({.mesh = 0, .pose = Pose::translation(10, 0, 0)});
  EXPECT_EQ(bounds(list), (Box{{10, 0, 0}, {11, 1, 0}})) << "unused vertices do not count";
  list.marks.push_back({{{0, 0, 9}, {1, 0, 9}, {0, 1, 9}}});
  list.lines.push_back({.a = {0, -7, 0}, .b = {0, 0, 0}});
  list.points.push_back({.at = {-3, 0, 0}});
  BoxGroup group;
  group.pose = Pose::translation(0, 20, 0);
  group.boxes.push_back({{{0, 0, 0}, {1, 1, 1}}});
  list.box_groups.push_back(group);
  EXPECT_EQ(bounds(list), (Box{{-3, -7, 0}, {11, 21, 9}}));
}

TEST(DrawList, MovedBoxHoldsTheMovedCorners) {
  test::for_each_case("draw_list/moved", 300, [](Rng& rng) {
    const auto point = [&] {
      return Vec3{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-5, 5)};
    };
    Box box;
    box.grow(point());
    box.grow(point());
    const Pose pose = Pose::about_z(rng.uniform(0, 6), point());
    Box grown = moved(pose, box);
    grown.lower += Vec3{-1e-9, -1e-9, -1e-9};
    grown.upper += Vec3{1e-9, 1e-9, 1e-9};
    const Vec3 inside{rng.uniform(box.lower.x, box.upper.x), rng.uniform(box.lower.y, box.upper.y),
                      rng.uniform(box.lower.z, box.upper.z)};
    const Vec3 p = pose.apply(inside);
    EXPECT_TRUE(grown.contains(Box{p, p}));
  });
  EXPECT_TRUE(moved(Pose::identity(), Box{}).empty());
}

TEST(DrawList, FaultsAreNamed) {
  DrawList list;
  list.meshes.push_back({1, 0, nullptr, nullptr});
  EXPECT_THROW(check(list), Error);
  list.meshes[0].mesh = one_triangle();
  list.meshes[0].colors = std::make_shared<const std::vector<Color>>(2);
  EXPECT_THROW(check(list), Error);
  list.meshes[0].colors = std::make_shared<const std::vector<Color>>(1);
  EXPECT_NO_THROW(check(list));
  list.instances.push_back({.mesh = 1});
  EXPECT_THROW(check(list), Error);
}

}  // namespace
}  // namespace soms::view
