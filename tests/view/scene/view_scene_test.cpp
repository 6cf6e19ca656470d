#include "apps/view/scene/view_scene.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"

#include "apps/view/scene/load.h"
#include "apps/view/scene/orientation_menu.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::view {
namespace {

/// A wall and blocks that drive at it, a unit a frame, and past it.
ViewScene traffic(std::size_t blocks) {
  SceneContent content;
  content.title = "wall";
  content.city.emplace_back(test::box_body({10, -5, 0}, {11, 50, 5}));
  const Shape block(test::box_body({0, 0, 0}, {1, 1, 1}));
  for (std::size_t k = 0; k < blocks; ++k) {
    const double lane = 3 * static_cast<double>(k);
    content.movers.push_back({Body(block), [lane](std::uint64_t frame) {
                                return Pose::translation(static_cast<double>(frame), lane, 1);
                              }});
  }
  return ViewScene(std::move(content));
}

/// Contacts of a pair of bodies by the plain query.
std::vector<TrianglePair> requested(const ViewScene& scene, BodyRef a, BodyRef b) {
  return overlap(scene.body(a), scene.body(b)).pairs;
}

void expect_contacts_as_requested(const ViewScene& scene) {
  std::vector<Touch> expected;
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    for (std::uint32_t c = 0; c < scene.city_parts(); ++c) {
      for (const auto& [i, j] : requested(scene, mover(k), city_part(c))) {
        expected.push_back({mover(k), city_part(c), i, j});
      }
    }
    for (std::uint32_t m = k + 1; m < scene.movers(); ++m) {
      for (const auto& [i, j] : requested(scene, mover(k), mover(m))) {
        expected.push_back({mover(k), mover(m), i, j});
      }
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(scene.contacts(), expected);
}

TEST(ViewScene, FindsTheContactsOfEveryFrame) {
  ViewScene scene = traffic(3);
  std::size_t touching_frames = 0;
  for (int frame = 0; frame < 14; ++frame) {
    EXPECT_EQ(scene.frame(), static_cast<std::uint64_t>(frame));
    expect_contacts_as_requested(scene);
    touching_frames += scene.contacts().empty() ? 0U : 1U;
    EXPECT_EQ(scene.statistics().touching_movers, scene.contacts().empty() ? 0U : 3U);
    scene.step();
  }
  EXPECT_EQ(touching_frames, 3U);  // faces meet, inside, faces meet
  scene.go_to(10);
  EXPECT_FALSE(scene.contacts().empty());
  scene.go_to(0);
  EXPECT_TRUE(scene.contacts().empty());
}

TEST(ViewScene, AsksAgainWhateverTheHandMoves) {
  ViewScene scene = traffic(2);
  scene.set_pose(1, Pose::translation(0.5, 0, 1));
  EXPECT_TRUE(scene.held(1));
  EXPECT_FALSE(scene.contacts().empty());
  expect_contacts_as_requested(scene);
  scene.step();
  EXPECT_EQ(scene.body(mover(1)).pose, Pose::translation(0.5, 0, 1));
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(1, 0, 1));
  scene.release(1);
  scene.step();
  EXPECT_EQ(scene.body(mover(1)).pose, Pose::translation(2, 3, 1));
}

TEST(ViewScene, KeepsTheOldPoseWhereTheNewOneIsRefused) {
  ViewScene scene = traffic(1);
  Pose bad;
  bad.m[0] = 2;
  EXPECT_THROW(scene.set_pose(0, bad), Error);
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(0, 0, 1));
  EXPECT_FALSE(scene.held(0));
  EXPECT_THROW(scene.set_pose(9, {}), Error);
}

TEST(ViewScene, ShowsBodiesThatAreAdded) {
  ViewScene scene{SceneContent{}};
  EXPECT_FALSE(scene.pair().has_value());
  EXPECT_TRUE(scene.bounds().empty());
  EXPECT_EQ(scene.add_city(Body(test::box_body({0, 0, 0}, {2, 2, 2}))), city_part(0));
  EXPECT_EQ(scene.add_mover({Body(test::box_body({1, 1, 1}, {3, 3, 3})), {}}), mover(0));
  expect_contacts_as_requested(scene);
  EXPECT_FALSE(scene.contacts().empty());
  ASSERT_TRUE(scene.pair().has_value());
  EXPECT_EQ(scene.pair()->first, city_part(0));
  EXPECT_EQ(scene.statistics().bodies, 2U);
  EXPECT_EQ(scene.bounds().upper, (Vec3{2, 2, 2}));
}

TEST(ViewScene, RunsOrientationTests) {
  ViewScene scene(two_bodies(Body(generate_knot(400)), Body(generate_knot(400))));
  for (const OrientationTest& test : orientation_tests()) {
    scene.start_test(test.name);
    EXPECT_EQ(scene.test(), test.name);
    EXPECT_EQ(scene.frame(), 0U);
    ASSERT_TRUE(scene.frames().has_value());
    EXPECT_TRUE(scene.contacts().empty());
    bool touched = false;
    for (std::uint64_t k = 1; k < *scene.frames(); ++k) {
      scene.step();
      touched = touched || !scene.contacts().empty();
    }
    EXPECT_TRUE(touched) << test.name;
    scene.step();
    EXPECT_EQ(scene.frame(), 0U);
    scene.go_to(1000);
    EXPECT_EQ(scene.frame(), *scene.frames() - 1);
  }
  const Pose last = scene.body(mover(0)).pose;
  scene.end_test();
  EXPECT_FALSE(scene.frames().has_value());
  scene.step();
  EXPECT_EQ(scene.body(mover(0)).pose, last);
  EXPECT_THROW(scene.start_test("sideways"), Error);
}

TEST(ViewScene, EndsATestWhenTheHandTakesItsMover) {
  ViewScene scene(two_bodies(Body(generate_knot(400)), Body(generate_knot(400))));
  scene.start_test("left");
  scene.set_pose(0, Pose::translation(0, 0, 0.5));
  EXPECT_FALSE(scene.test().has_value());
  EXPECT_EQ(scene.body(mover(0)).pose, Pose::translation(0, 0, 0.5));
}

TEST(ViewScene, TraversesThePairOnlyAfterAChange) {
  ViewScene scene(two_bodies(Body(generate_knot(400)), Body(generate_knot(400))));
  scene.set_pose(0, Pose::translation(1, 0, 0));
  (void)scene.trace();
  const std::uint64_t version = scene.trace_version();
  (void)scene.trace();
  EXPECT_EQ(scene.trace_version(), version);
  scene.set_pose(0, Pose::translation(1, 0, 0.5));
  EXPECT_GT(scene.trace().counts.box_tests, 1U);
  EXPECT_EQ(scene.trace_version(), version + 1);
  TreeChoice other = scene.trees();
  other.build.rule = Rule::object_median;
  scene.set_trees(other);
  (void)scene.trace();
  EXPECT_EQ(scene.trace_version(), version + 2);
  EXPECT_EQ(scene.statistics().rule, "object_median");
  ASSERT_TRUE(scene.statistics().tree_a.has_value());
  EXPECT_EQ(scene.statistics().tree_a->nodes, scene.tree(city_part(0)).nodes.size());
}

TEST(ViewScene, HasNoTraceOfTheFastTraversal) {
  ViewScene scene(two_bodies(Body(generate_knot(400)), Body(generate_knot(400))));
  TreeChoice fast;
  fast.traversal = {.traversal = Traversal::fast};
  scene.set_trees(fast);
  EXPECT_TRUE(scene.trace().a.empty());
  EXPECT_FALSE(scene.statistics().trace.has_value());
}

TEST(ViewScene, ChecksThePair) {
  ViewScene scene = traffic(2);
  scene.set_pair(mover(0), mover(1));
  EXPECT_EQ(scene.pair()->first, mover(0));
  EXPECT_THROW(scene.set_pair(mover(1), mover(1)), Error);
  EXPECT_THROW(scene.set_pair(mover(1), city_part(0)), Error);
  EXPECT_THROW(scene.set_pair(city_part(3), mover(0)), Error);
  EXPECT_THROW(scene.set_pair(city_part(0), mover(2)), Error);
}

TEST(ViewScene, IsExactFarFromTheOrigin) {
  // Faces that touch, and that miss by the least step that coordinates of 1e6 m have.
  const double step = 0x1p-33;
  const Vec3 at{1'000'000, 2'000'000, 50};
  ViewScene scene(two_bodies(Body(test::box_body(at, at + Vec3{2, 2, 2})),
                             Body(test::box_body({0, 0, 0}, {2, 2, 2}))));
  const auto place = [&](double x) {
    scene.set_pose(0, Pose::translation(at.x + x, at.y, at.z));
    return scene.contacts().size();
  };
  EXPECT_GT(place(2), 0U);
  EXPECT_EQ(place(2 + step), 0U);
  EXPECT_GT(place(2 - step), 0U);
  place(2);
  for (const Touch& touch : scene.contacts()) {
    const Explanation e = scene.explain(touch);
    EXPECT_TRUE(e.touch);
    EXPECT_EQ(scene.common_points(touch).corners[0].x >= at.x, true);
  }
}

TEST(ViewScene, ShowsModelsWithoutTriangles) {
  ViewScene scene(two_bodies(Body(Mesh{}), Body(Mesh{})));
  EXPECT_TRUE(scene.contacts().empty());
  EXPECT_TRUE(scene.bounds().empty());
  EXPECT_TRUE(scene.trace().a.empty());
  EXPECT_EQ(scene.tree(city_part(0)).nodes.size(), 0U);
  EXPECT_FALSE(scene.pick({{0, 0, 0}, {0, 0, 1}}).has_value());
  EXPECT_THROW(scene.start_test("left"), Error);
  scene.step();
}

}  // namespace
}  // namespace soms::view
