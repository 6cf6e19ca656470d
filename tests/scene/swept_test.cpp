// Swept steps: who touches whom between two frames.
#include "soms/base/error.h"
#include "soms/base/stop_token.h"
#include "soms/scene/scene.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/scene/swept_scenes.h"
#include "tests/support/support.h"

#include <numbers>
#include <string>
#include <utility>

namespace soms {

namespace {

Shape brick(const Box& box) {
  return Shape(test::box_mesh(box));
}

/// About its own origin.
Shape small_cube() {
  return brick({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
}

Shape thin_wall() {
  return brick({{0, -5, -5}, {0.001, 5, 5}});
}

TEST(Swept, FindsAThinWallBetweenTwoFrames) {
  Scene scene;
  const EnvironmentId wall = scene.add_environment(Body(thin_wall()));
  const MoverId mover = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  EXPECT_TRUE(scene.step({.swept = true}).environment_passages.empty());
  scene.set_pose(mover, Pose::translation(5, 0, 0));
  const StepReport report = scene.step({.swept = true});
  EXPECT_TRUE(report.environment.empty());
  ASSERT_EQ(report.environment_passages.size(), 1U);
  const EnvironmentPassage& passage = report.environment_passages[0];
  EXPECT_EQ(passage.mover, mover);
  EXPECT_EQ(passage.part, wall);
  EXPECT_EQ(passage.verdict, ContactVerdict::contact);
  EXPECT_LE(passage.t.lower, 0.45);
  EXPECT_NEAR(passage.t.lower, 0.45, 1e-9);
  EXPECT_NEAR(passage.t.upper, 0.45, 1e-9);
  EXPECT_EQ(passage.point.x, 0);
  // It rests: there is no way any more.
  EXPECT_TRUE(scene.step({.swept = true}).environment_passages.empty());
}

TEST(Swept, ReportsNothingAtTheFirstStep) {
  Scene scene;
  scene.add_environment(Body(thin_wall()));
  const MoverId mover = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  scene.set_pose(mover, Pose::translation(5, 0, 0));
  const StepReport report = scene.step({.swept = true});
  EXPECT_TRUE(report.environment_passages.empty());
  EXPECT_EQ(report.passage_queries, 0U);
  EXPECT_TRUE(report.swept);
}

TEST(Swept, CountsStepsThatAreNotSwept) {
  Scene scene;
  scene.add_environment(Body(thin_wall()));
  const MoverId mover = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  static_cast<void>(scene.step());
  scene.set_pose(mover, Pose::translation(0, 40, 0));  // never stepped: no place on the way
  scene.set_pose(mover, Pose::translation(5, 0, 0));
  EXPECT_EQ(scene.step({.swept = true}).environment_passages.size(), 1U);
  scene.set_pose(mover, Pose::translation(-5, 0, 0));
  EXPECT_TRUE(scene.step().environment_passages.empty());
  scene.set_pose(mover, Pose::translation(-6, 0, 0));
  EXPECT_TRUE(scene.step({.swept = true}).environment_passages.empty());
}

// At both frames the blade is clear of the post; its tip passes it in between.
TEST(Swept, FindsAPostBesideABladeThatTurns) {
  Scene scene;
  const Shape blade = brick({{-4, -0.05, -0.1}, {4, 0.05, 0.1}});
  scene.add_environment(Body(brick({{-0.02, 3.95, -3}, {0.02, 3.98, 3}})));
  const double third = std::numbers::pi / 3;
  const MoverId mover = scene.add_mover(Body(blade, Pose::about_z(third, {0, 0, 0})));
  static_cast<void>(scene.step());
  scene.set_pose(mover, Pose::about_z(2 * third, {0, 0, 0}));
  const StepReport report = scene.step({.swept = true});
  EXPECT_TRUE(report.environment.empty());
  ASSERT_EQ(report.environment_passages.size(), 1U);
  EXPECT_EQ(report.environment_passages[0].verdict, ContactVerdict::contact);
  EXPECT_LT(report.environment_passages[0].t.upper, 0.5);
}

TEST(Swept, FindsTwoMoversThatSwapPlaces) {
  Scene scene;
  const MoverId a = scene.add_mover(Body(small_cube(), Pose::translation(-3, 0, 0)));
  const MoverId b = scene.add_mover(Body(small_cube(), Pose::translation(3, 0, 0)));
  const MoverId c = scene.add_mover(Body(small_cube(), Pose::translation(-3, 8, 0)));
  static_cast<void>(scene.step());
  scene.set_pose(a, Pose::translation(3, 0, 0));
  scene.set_pose(b, Pose::translation(-3, 0, 0));
  scene.set_pose(c, Pose::translation(3, 8, 0));
  const StepReport report = scene.step({.swept = true});
  EXPECT_TRUE(report.movers.empty());
  ASSERT_EQ(report.mover_passages.size(), 1U);
  EXPECT_EQ(report.mover_passages[0].a, a);
  EXPECT_EQ(report.mover_passages[0].b, b);
  EXPECT_NEAR(report.mover_passages[0].t.upper, 2.5 / 6, 1e-9);
  EXPECT_TRUE(scene.step({.mover_mover = false, .swept = true}).mover_passages.empty());
}

// The first triangle is that of the lesser number, whichever moves.
TEST(Swept, NamesTrianglesOfAMoverThatRests) {
  Scene scene;
  Mesh two = test::box_mesh({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
  two.triangles.erase(two.triangles.begin(), two.triangles.begin() + 11);
  const MoverId rests = scene.add_mover(Body(small_cube()));
  const MoverId moves =
      scene.add_mover(Body(Shape(std::move(two)), Pose::translation(-3, 0.01, 0.02)));
  static_cast<void>(scene.step());
  scene.set_pose(moves, Pose::translation(3, 0.01, 0.02));
  const StepReport report = scene.step({.swept = true});
  ASSERT_EQ(report.mover_passages.size(), 1U);
  EXPECT_EQ(report.mover_passages[0].a, rests);
  EXPECT_EQ(report.mover_passages[0].j, 0U);
  EXPECT_GT(report.mover_passages[0].i, 0U);
}

TEST(Swept, SaysWhoParts) {
  Scene scene;
  scene.add_environment(Body(thin_wall()));
  const MoverId mover = scene.add_mover(Body(small_cube()));
  static_cast<void>(scene.step());
  scene.set_pose(mover, Pose::translation(0.1, 0, 0));
  EXPECT_TRUE(scene.step({.swept = true}).environment_passages.empty());
  scene.set_pose(mover, Pose::translation(3, 0, 0));
  const StepReport report = scene.step({.swept = true});
  ASSERT_EQ(report.environment_passages.size(), 1U);
  EXPECT_EQ(report.environment_passages[0].verdict, ContactVerdict::started);
  EXPECT_EQ(report.environment_passages[0].t, (Bracket{0, 0}));
  scene.set_pose(mover, Pose::translation(0, 0, 0));
  const StepReport arrived = scene.step({.swept = true});
  EXPECT_FALSE(arrived.environment.empty());
  ASSERT_EQ(arrived.environment_passages.size(), 1U);
  EXPECT_EQ(arrived.environment_passages[0].verdict, ContactVerdict::contact);
}

TEST(Swept, GivesNoWayToNewMoversAndShapes) {
  test::Scenes scenes;
  MoverId first = 0;
  scenes.change([&](Scene& scene) {
    scene.add_environment(Body(thin_wall()));
    first = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  });
  static_cast<void>(scenes.step());
  MoverId second = 0;
  scenes.change([&](Scene& scene) {
    second = scene.add_mover(Body(small_cube(), Pose::translation(-5, 3, 0)));
    scene.set_pose(second, Pose::translation(5, 3, 0));
    scene.set_pose(first, Pose::translation(5, 0, 0));
    scene.set_shape(first, small_cube());
    scene.set_pose(first, Pose::translation(6, 0, 0));
  });
  EXPECT_EQ(test::passages_of(scenes.step()), test::Passages());
  scenes.change([&](Scene& scene) {
    scene.set_pose(first, Pose::translation(-5, 0, 0));
    scene.set_pose(second, Pose::translation(-5, 3, 0));
  });
  EXPECT_EQ(scenes.step().environment_passages.size(), 2U);
  // Numbers and places of those that remain stay theirs.
  scenes.change([&](Scene& scene) {
    scene.remove_mover(first);
    scene.set_pose(second, Pose::translation(5, 3, 0));
  });
  const StepReport report = scenes.step();
  ASSERT_EQ(report.environment_passages.size(), 1U);
  EXPECT_EQ(report.environment_passages[0].mover, second);
}

TEST(Swept, TakesTheEnvironmentAsItIsNow) {
  test::Scenes scenes;
  EnvironmentId wall = 0;
  MoverId mover = 0;
  scenes.change([&](Scene& scene) {
    wall = scene.add_environment(Body(thin_wall()));
    mover = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  });
  static_cast<void>(scenes.step());
  scenes.change([&](Scene& scene) {
    scene.remove_environment(wall);
    scene.set_pose(mover, Pose::translation(5, 0, 0));
  });
  EXPECT_TRUE(scenes.step().environment_passages.empty());
  scenes.change([&](Scene& scene) {
    wall = scene.add_environment(Body(small_cube(), Pose::translation(0, 5, 0)));
    scene.set_environment_shape(wall, brick({{0, -6, -1}, {1, -4, 1}}));
    scene.set_pose(mover, Pose::translation(-5, 0, 0));
  });
  EXPECT_EQ(scenes.step().environment_passages.size(), 1U);
}

TEST(Swept, LeavesOutGroupsAndIgnoredPairs) {
  Scene scene;
  const EnvironmentId wall = scene.add_environment(Body(thin_wall()));
  const MoverId a = scene.add_mover(Body(small_cube(), Pose::translation(-3, 0, 0)), 1);
  const MoverId b = scene.add_mover(Body(small_cube(), Pose::translation(3, 0, 0)), 1);
  scene.ignore_environment(a, wall);
  static_cast<void>(scene.step());
  const auto swap = [&](double x) {
    scene.set_pose(a, Pose::translation(x, 0, 0));
    scene.set_pose(b, Pose::translation(-x, 0, 0));
    return scene.step({.swept = true});
  };
  const StepReport grouped = swap(3);
  EXPECT_TRUE(grouped.mover_passages.empty());
  ASSERT_EQ(grouped.environment_passages.size(), 1U);
  EXPECT_EQ(grouped.environment_passages[0].mover, b);
  scene.set_group(b, 0);
  EXPECT_EQ(swap(-3).mover_passages.size(), 1U);
  scene.ignore(a, b);
  EXPECT_TRUE(swap(3).mover_passages.empty());
}

TEST(Swept, ChangesNothingElse) {
  test::for_each_case("scene/swept-else", 10, [](Rng& rng) {
    Scene plain = test::random_scene(rng, 8, 8, 4);
    Scene swept;
    for (const EnvironmentId id : plain.environments()) {
      swept.add_environment(plain.environment(id));
    }
    for (const MoverId id : plain.movers()) {
      swept.add_mover(plain.mover(id));
    }
    for (int step = 0; step < 3; ++step) {
      const double clearance = step == 1 ? 1.5 : 0;
      const StepReport expected = plain.step({.clearance = clearance});
      StepReport found = swept.step({.clearance = clearance, .swept = true});
      EXPECT_EQ(found.hash(), expected.hash());
      found.swept = false;
      found.environment_passages.clear();
      found.mover_passages.clear();
      found.passage_queries = 0;
      found.cost = expected.cost;
      ASSERT_EQ(found, expected);
      for (const MoverId id : plain.movers()) {
        const Pose pose = test::random_pose(rng, 8);
        plain.set_pose(id, pose);
        swept.set_pose(id, pose);
      }
    }
  });
}

TEST(Swept, RefusesScopesThatLeavePairsOut) {
  Scene scene;
  try {
    static_cast<void>(scene.step({.scope = StepScope::first_contact, .swept = true}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("swept"), std::string::npos);
  }
}

TEST(Swept, KeepsTheWayWhenAStepIsStopped) {
  Scene scene;
  scene.add_environment(Body(thin_wall()));
  const MoverId mover = scene.add_mover(Body(small_cube(), Pose::translation(-5, 0, 0)));
  static_cast<void>(scene.step());
  scene.set_pose(mover, Pose::translation(5, 0, 0));
  StopSource stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(scene.step({.swept = true}, {.stop = stop.get_token()})), Error);
  EXPECT_EQ(scene.step({.swept = true}).environment_passages.size(), 1U);
}

}  // namespace

}  // namespace soms
