// Steps with a clearance: who is near without touching.
#include "soms/base/error.h"
#include "soms/query/distance.h"
#include "soms/scene/reference/gaps.h"
#include "soms/scene/scene.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Shape unit_cube() {
  return Shape(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
}

reference::Gaps gaps_of(const StepReport& report) {
  return {report.environment_gaps, report.mover_gaps};
}

reference::ComparedPairs compared_of(const test::Exclusions& exclusions) {
  return {.environment =
              [&exclusions](MoverId mover, EnvironmentId part) {
                return exclusions.parts.count({mover, part}) == 0;
              },
          .movers = [&exclusions](MoverId a, MoverId b) { return !exclusions.excludes(a, b); }};
}

/// Ignores a few pairs and puts a few movers into groups.
test::Exclusions exclude_some(Scene& scene, Rng& rng) {
  test::Exclusions exclusions;
  const std::vector<MoverId> movers = scene.movers();
  const std::vector<EnvironmentId> parts = scene.environments();
  for (const MoverId id : movers) {
    exclusions.groups[id] = static_cast<std::uint32_t>(rng.below(8));
    scene.set_group(id, exclusions.groups[id]);
    const MoverId other = movers[rng.below(movers.size())];
    if (other > id) {
      exclusions.movers.insert({id, other});
      scene.ignore(id, other);
    }
    if (!parts.empty() && rng.below(3) == 0) {
      const EnvironmentId part = parts[rng.below(parts.size())];
      exclusions.parts.insert({id, part});
      scene.ignore_environment(id, part);
    }
  }
  return exclusions;
}

/// The answer of a step, the same with and without coherence and for any threads.
StepReport step_in_all_modes(Scene& scene, double clearance) {
  const StepReport report = scene.step({.clearance = clearance});
  for (const bool coherent : {true, false}) {
    for (const int threads : {1, 2}) {
      const StepReport again =
          scene.step({.coherent = coherent, .clearance = clearance}, Limits{.threads = threads});
      EXPECT_EQ(again, report) << "coherent " << coherent << ", threads " << threads;
    }
  }
  return report;
}

TEST(Clearance, ReportsWhatAScanOfAllPairsReports) {
  std::size_t gaps = 0;
  std::size_t left_out = 0;
  test::for_each_case("scene/clearance", 40, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, rng.uniform(4, 16), 4 + rng.below(10), rng.below(8));
    const test::Exclusions exclusions = exclude_some(scene, rng);
    for (int step = 0; step < 3; ++step) {
      const double clearance = std::pow(2.0, static_cast<double>(rng.below(5)) - 1);
      const StepReport report = step_in_all_modes(scene, clearance);
      ASSERT_EQ(gaps_of(report), reference::gaps(scene, clearance, compared_of(exclusions)));
      gaps += report.environment_gaps.size() + report.mover_gaps.size();
      left_out += reference::gaps(scene, clearance).movers.size() - report.mover_gaps.size();
      for (const MoverId id : scene.movers()) {
        if (rng.below(3) != 0) {
          scene.set_pose(id, test::random_pose(rng, 10));
        }
      }
    }
  });
  EXPECT_GT(gaps, 500U);
  EXPECT_GT(left_out, 50U);
}

TEST(Clearance, FollowsBodiesThatMoveComeAndGo) {
  test::for_each_case("scene/clearance-changes", 12, [](Rng& rng) {
    Scene scene = test::random_scene(rng, 8, 8, 4);
    std::vector<Vec3> ways(200);
    for (Vec3& way : ways) {
      way = {rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)};
    }
    for (int step = 0; step < 12; ++step) {
      const double clearance = step % 4 == 3 ? 0.25 : 1.5;
      const StepReport report = scene.step({.clearance = clearance});
      ASSERT_EQ(gaps_of(report), reference::gaps(scene, clearance));
      for (const MoverId id : scene.movers()) {
        Pose pose = scene.mover(id).pose;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          pose.m[4 * axis + 3] += ways[id][axis];
        }
        scene.set_pose(id, pose);
      }
      const std::vector<MoverId> movers = scene.movers();
      if (rng.below(2) == 0) {
        scene.remove_mover(movers[rng.below(movers.size())]);
      }
      scene.add_mover(Body(Shape(test::random_mesh(rng)), test::random_pose(rng, 8)));
      if (rng.below(3) == 0) {
        const std::vector<EnvironmentId> parts = scene.environments();
        scene.remove_environment(parts[rng.below(parts.size())]);
        scene.add_environment(Body(Shape(test::random_mesh(rng)), test::random_pose(rng, 8)));
      }
    }
  });
}

TEST(Clearance, LeavesContactsAsTheyAreAndCostsNothingWhereThereIsNone) {
  Rng rng(31);
  Scene scene = test::random_scene(rng, 10, 40, 12);
  const StepReport plain = scene.step();
  ASSERT_GT(plain.environment.size() + plain.movers.size(), 100U);
  EXPECT_EQ(plain.gap_queries, 0U);
  for (const OverlapMode mode : {OverlapMode::all, OverlapMode::first}) {
    const StepReport without = scene.step({.mode = mode});
    StepReport with = scene.step({.mode = mode, .clearance = 2});
    EXPECT_GT(with.environment_gaps.size(), 0U);
    EXPECT_GT(with.mover_gaps.size(), 0U);
    EXPECT_GE(with.gap_queries, with.environment_gaps.size() + with.mover_gaps.size());
    EXPECT_EQ(with.hash(), without.hash());
    with.clearance = 0;
    with.environment_gaps.clear();
    with.mover_gaps.clear();
    with.gap_queries = 0;
    with.cost = without.cost;
    EXPECT_EQ(with, without);
  }
  EXPECT_EQ(scene.step(), plain);
}

TEST(Clearance, GivesEachPairTheAnswerOfDistance) {
  Scene scene;
  const EnvironmentId wall = scene.add_environment(Body(unit_cube()));
  const MoverId a = scene.add_mover(Body(unit_cube(), Pose::translation(1.5, 0.25, 0)));
  const MoverId b = scene.add_mover(Body(unit_cube(), Pose::translation(3.5, 0.5, 0)));
  const StepReport report = scene.step({.clearance = 1});
  ASSERT_EQ(report.environment_gaps.size(), 1U);
  const EnvironmentGap& gap = report.environment_gaps[0];
  const Distance answer = distance(scene.mover(a), scene.environment(wall));
  EXPECT_EQ(gap, (EnvironmentGap{a, wall, answer.triangles->a, answer.triangles->b, answer.distance,
                                 answer.point_a, answer.point_b}));
  EXPECT_EQ(gap.distance, (Bracket{0.5, 0.5}));
  EXPECT_EQ(gap.point_a.x, 1.5);
  EXPECT_EQ(gap.point_b.x, 1);
  ASSERT_EQ(report.mover_gaps.size(), 1U);
  EXPECT_EQ(report.mover_gaps[0].a, a);
  EXPECT_EQ(report.mover_gaps[0].b, b);
  EXPECT_EQ(report.mover_gaps[0].distance, (Bracket{1, 1}));
  EXPECT_TRUE(report.environment.empty());
}

Scene two_points(double gap) {
  const auto point = [](double x) {
    Mesh mesh;
    mesh.vertices = {{x, 0, 0}};
    mesh.triangles = {{0, 0, 0}};
    return Body(std::move(mesh));
  };
  Scene scene;
  scene.add_environment(point(0));
  scene.add_mover(point(0), 1);
  scene.add_mover(point(gap), 2);
  return scene;
}

TEST(Clearance, ReachesToTheVeryLastDouble) {
  for (const double gap : {1.0, 0.1, 3e-5, 1e7}) {
    Scene scene = two_points(gap);
    const StepReport at = scene.step({.clearance = gap});
    EXPECT_EQ(at.environment_gaps.size(), 1U) << gap;
    EXPECT_EQ(at.mover_gaps.size(), 1U) << gap;
    const StepReport below = scene.step({.clearance = std::nextafter(gap, 0.0)});
    EXPECT_TRUE(below.environment_gaps.empty()) << gap;
    EXPECT_TRUE(below.mover_gaps.empty()) << gap;
  }
}

// Half of an odd multiple of the smallest number is no double.
TEST(Clearance, ReachesThroughTheSmallestGaps) {
  for (const double gap : {0x1p-1074, 0x1p-1073, 0x3p-1074}) {
    Scene scene = two_points(gap);
    EXPECT_EQ(scene.step({.clearance = gap}).environment_gaps.size(), 1U) << gap;
    EXPECT_EQ(scene.step({.clearance = gap}).mover_gaps.size(), 1U) << gap;
  }
}

TEST(Clearance, OfAnyFiniteLengthReachesAllBodies) {
  Scene scene;
  scene.add_environment(Body(unit_cube(), Pose::translation(-0x1p299, 0, 0)));
  scene.add_mover(Body(unit_cube(), Pose::translation(0x1p299, 0, 0)));
  scene.add_mover(Body(unit_cube(), Pose::translation(0, 1e9, 0)));
  scene.add_mover(Body(Shape()));
  const StepReport report = scene.step({.clearance = std::numeric_limits<double>::max()});
  EXPECT_EQ(report.gap_queries, 3U);
  EXPECT_EQ(report.environment_gaps.size(), 2U);
  EXPECT_EQ(report.mover_gaps.size(), 1U);
}

TEST(Clearance, ThatMeansNothingIsRefused) {
  Scene scene;
  scene.add_mover(Body(unit_cube()));
  const auto refused = [&](const StepOptions& options, const std::string& what) {
    try {
      static_cast<void>(scene.step(options));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
      return true;
    }
    return false;
  };
  for (const double clearance : {-1.0, -0x1p-1074, kInfinity, std::nan("")}) {
    EXPECT_TRUE(refused({.clearance = clearance}, "clearance")) << clearance;
  }
  EXPECT_TRUE(refused({.scope = StepScope::first_contact, .clearance = 1}, "every_pair"));
  EXPECT_FALSE(refused({.scope = StepScope::first_contact, .clearance = -0.0}, ""));
}

TEST(Clearance, GivesBackTheMemoryOfItsPairs) {
  Scene scene;
  const Shape cube = unit_cube();
  for (int k = 0; k < 60; ++k) {
    scene.add_mover(Body(cube, Pose::translation(3 * k, 0, 0)));
  }
  static_cast<void>(scene.step({.clearance = 0.5}));
  const std::size_t few = scene.memory();
  EXPECT_EQ(scene.step({.clearance = 1000}).mover_gaps.size(), 60U * 59 / 2);
  for (int k = 0; k < 3; ++k) {
    static_cast<void>(scene.step({.clearance = 0.5}));
  }
  EXPECT_LT(scene.memory(), few + (std::size_t{1} << 16));
}

}  // namespace

}  // namespace soms
