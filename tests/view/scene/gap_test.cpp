#include "apps/view/scene/gap.h"

#include "soms/generate/shapes.h"

#include "apps/view/scene/draw_scene.h"
#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace soms::view {
namespace {

Body cube_at(const Vec3& lower, double side) {
  return Body(test::box_body(lower, lower + Vec3{side, side, side}, 2));
}

ViewScene knot_and_ball(const Pose& pose) {
  return ViewScene(two_bodies(Body(generate_knot(600)), Body(generate_sphere(400), pose)));
}

TEST(Gap, TheDrawnEndsAreTheNearestPointsOfTheLibrary) {
  test::for_each_case("gap/ends", 20, [](Rng& rng) {
    ViewScene scene = knot_and_ball(
        Pose::about_z(rng.uniform(0, 6), {rng.uniform(-6, 6), rng.uniform(-6, 6), 1.5}));
    const Distance truth = distance(scene.body(city_part(0)), scene.body(mover(0)));
    const DrawList list = make_draw_list(scene, {});
    if (truth.distance.upper == 0) {
      EXPECT_TRUE(list.labels.empty());
      return;
    }
    ASSERT_EQ(list.lines.size(), 8U);  // two outlines of triangles, and the segment twice
    for (std::size_t k = 6; k < 8; ++k) {
      EXPECT_EQ(list.lines[k].a, truth.point_a);
      EXPECT_EQ(list.lines[k].b, truth.point_b);
      EXPECT_EQ(with_alpha(list.lines[k].color, 255), ViewColors{}.gap);
    }
    ASSERT_EQ(list.points.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(list.points[k].at, k % 2 == 0 ? truth.point_a : truth.point_b);
    }
    ASSERT_EQ(list.marks.size(), 2U);
    EXPECT_EQ(list.marks[0].corners, scene.triangle(city_part(0), truth.triangles->a));
    EXPECT_EQ(list.marks[1].corners, scene.triangle(mover(0), truth.triangles->b));
    ASSERT_EQ(list.labels.size(), 1U);
    EXPECT_NEAR(std::stod(list.labels[0].text), truth.distance.lower, 6e-4 * truth.distance.lower);
  });
}

TEST(Gap, IsNotDrawnWhereBodiesTouchNorWhereItIsNotShown) {
  ViewScene scene(two_bodies(cube_at({0, 0, 0}, 2), cube_at({0, 0, 0}, 2)));
  ViewOptions options;
  for (const double x : {0.5, 2.0}) {  // they cross, and share a face
    scene.set_pose(0, Pose::translation(x, 0, 0));
    EXPECT_FALSE(scene.gap().has_value()) << x;
    EXPECT_TRUE(make_draw_list(scene, options).labels.empty()) << x;
  }
  EXPECT_EQ(scene.gap_queries(), 0U) << "contacts are known, so nothing was queried";
  scene.set_pose(0, Pose::translation(5, 0, 0));
  EXPECT_EQ(make_draw_list(scene, options).labels.size(), 1U);
  options.movers = false;
  EXPECT_TRUE(make_draw_list(scene, options).labels.empty()) << "one of the two is not drawn";
  options.movers = true;
  options.gap = false;
  const DrawList without = make_draw_list(scene, options);
  EXPECT_TRUE(without.labels.empty());
  EXPECT_TRUE(without.lines.empty());
  EXPECT_TRUE(without.points.empty());
  EXPECT_TRUE(without.marks.empty());
}

TEST(Gap, IsQueriedOnceAPoseAndNeverWhereItIsNotShown) {
  ViewScene scene(two_bodies(cube_at({0, 0, 0}, 2), cube_at({0, 0, 0}, 2)));
  scene.set_pose(0, Pose::translation(5, 0, 0));
  ViewOptions off;
  off.gap = false;
  (void)make_draw_list(scene, off);
  EXPECT_EQ(scene.gap_queries(), 0U);
  for (int frame = 0; frame < 5; ++frame) {
    (void)make_draw_list(scene, {});
    EXPECT_EQ(scene.gap()->distance.distance, (Bracket{3, 3}));
  }
  EXPECT_EQ(scene.gap_queries(), 1U);
  scene.set_pose(0, Pose::translation(6, 0, 0));
  EXPECT_EQ(scene.gap()->distance.distance, (Bracket{4, 4}));
  scene.set_pose(0, Pose::translation(6, 0, 0));
  EXPECT_EQ(scene.gap()->distance.distance, (Bracket{4, 4}));
  EXPECT_EQ(scene.gap_queries(), 2U);
  scene.set_pose(0, Pose::translation(1, 0, 0));
  EXPECT_FALSE(scene.gap().has_value());
  scene.set_pose(0, Pose::translation(6, 0, 0));
  EXPECT_EQ(scene.gap()->distance.distance, (Bracket{4, 4}));
}

TEST(Gap, IsThatOfTheNearestPartOfTheCity) {
  SceneContent content;
  for (const double x : {0.0, 20.0, 30.0}) {
    content.city.push_back(cube_at({x, 0, 0}, 2));
  }
  content.movers.push_back({cube_at({0, 0, 0}, 1), {}});
  ViewScene scene(std::move(content));
  for (const auto& [x, part, length] :
       {std::tuple(9.0, 0U, 7.0), std::tuple(12.0, 1U, 7.0), std::tuple(25.5, 1U, 3.5),
        std::tuple(26.0, 2U, 3.0), std::tuple(40.0, 2U, 8.0)}) {
    scene.set_pose(0, Pose::translation(x, 0, 0.5));
    ASSERT_TRUE(scene.gap().has_value()) << x;
    EXPECT_EQ(scene.gap()->a, city_part(part)) << x;
    EXPECT_EQ(scene.gap()->b, mover(0)) << x;
    EXPECT_EQ(scene.gap()->distance.distance, (Bracket{length, length})) << x;
  }
  scene.set_pose(0, Pose::translation(31, 0, 0.5));
  EXPECT_FALSE(scene.gap().has_value()) << "it touches a part";
}

TEST(Gap, OfTwoModelsThatStandStillOrOfTwoMovers) {
  SceneContent still;
  still.city = {cube_at({0, 0, 0}, 2), cube_at({5, 0, 0}, 2)};
  ViewScene two(std::move(still));
  ASSERT_TRUE(two.gap().has_value());
  EXPECT_EQ(two.gap()->b, city_part(1));
  EXPECT_EQ(two.gap()->distance.distance, (Bracket{3, 3}));
  EXPECT_EQ(make_draw_list(two, {}).labels.size(), 1U);
  (void)two.add_city(cube_at({9, 9, 9}, 1));
  EXPECT_FALSE(two.gap().has_value()) << "of three, nothing says which";

  SceneContent moving;
  moving.movers = {{cube_at({0, 0, 0}, 2), {}}, {cube_at({0, 0, 0}, 2), {}}};
  ViewScene pair(std::move(moving));
  EXPECT_FALSE(pair.gap().has_value());
  pair.set_pose(0, Pose::translation(0, 0, 7));
  ASSERT_TRUE(pair.gap().has_value());
  EXPECT_EQ(pair.gap()->a, mover(0));
  EXPECT_EQ(pair.gap()->distance.distance, (Bracket{5, 5}));
}

TEST(Gap, AsSmallAsItMayBeIsDrawn) {
  ViewScene scene(two_bodies(cube_at({0, 0, 0}, 2), cube_at({0, 0, 0}, 2)));
  scene.set_pose(0, Pose::translation(std::nextafter(2.0, 3.0), 0, 0));
  const DrawList list = make_draw_list(scene, {});
  ASSERT_EQ(list.labels.size(), 1U);
  EXPECT_EQ(list.labels[0].text, "4.441e-16");
}

TEST(Gap, IsNotDrawnWhereTimeRanOut) {
  // Concentric: all of either ball is equally near to the other, so the search is long.
  const Mesh inner = generate_sphere(20'000);
  Mesh outer = inner;
  for (Vec3& v : outer.vertices) {
    v = v * 2;
  }
  ViewScene scene(two_bodies(Body(outer), Body(inner)));
  scene.set_gap_patience(std::chrono::nanoseconds(0));
  const std::optional<Gap> cut = scene.gap();
  EXPECT_TRUE(make_draw_list(scene, {}).labels.empty());
  if (cut) {
    EXPECT_FALSE(cut->known());
  }
  scene.set_gap_patience(std::nullopt);
  scene.set_pose(0, Pose::translation(0, 0, 0.25));
  ASSERT_TRUE(scene.gap().has_value());
  EXPECT_TRUE(scene.gap()->known());
  EXPECT_EQ(make_draw_list(scene, {}).labels.size(), 1U);
}

TEST(Gap, WithoutTrianglesThereIsNone) {
  ViewScene scene(two_bodies(cube_at({0, 0, 0}, 2), Body(Mesh{})));
  EXPECT_FALSE(scene.gap().has_value());
  EXPECT_TRUE(make_draw_list(scene, {}).labels.empty());
}

TEST(Gap, SurroundingsHoldItsSegmentAndMoreOfTheBodies) {
  for (const double x : {2.0001, 2.5, 5.0, 200.0}) {
    ViewScene scene(two_bodies(cube_at({0, 0, 0}, 2), cube_at({0, 0, 0}, 2)));
    scene.set_pose(0, Pose::translation(x, 0, 0));
    const Gap& gap = *scene.gap();
    Box all = scene.bounds(gap.a);
    all.grow(scene.bounds(gap.b));
    const Box box = surroundings(gap, scene.bounds(gap.a), scene.bounds(gap.b), all);
    Box segment;
    segment.grow(gap.distance.point_a);
    segment.grow(gap.distance.point_b);
    EXPECT_TRUE(box.contains(segment)) << x;
    EXPECT_GT(box.extent().x, 1.5 * (x - 2)) << x;
    EXPECT_GT(box.extent().x, 0.2) << x;
  }
}

}  // namespace
}  // namespace soms::view
