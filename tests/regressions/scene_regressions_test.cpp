// Faults that users of other libraries reported of scenes, tried on ours; ids as in the design's
// list of regressions.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/overlap.h"
#include "soms/scene/scene.h"

#include "tests/support/allocation.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace soms {

namespace {

Mesh triangle_mesh(const Triangle& t) {
  Mesh mesh;
  mesh.vertices = {t.a, t.b, t.c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

Mesh scaled_sphere(std::uint64_t triangles, double radius) {
  return transformed(generate_sphere(triangles), radius, UpAxis::z);
}

Pose random_turn(Rng& rng, double reach) {
  const double angle = rng.uniform(0, 6.28);
  const double w = std::cos(angle / 2);
  const double x = std::sin(angle / 2) * 0.6;
  const double z = std::sin(angle / 2) * 0.8;
  return Pose::from_quaternion(
      w, x, 0, z,
      {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)});
}

// R70: a pose set after creation left the box where it was, and pairs were missed.
TEST(SceneRegressions, R70FindsABodyWhereItsPoseWasSetLater) {
  Scene scene;
  scene.add_environment(Body(Shape(scaled_sphere(80, 1)), Pose::translation(10, 0, 0)));
  const MoverId mover = scene.add_mover(Body(Shape(scaled_sphere(60, 1))));
  EXPECT_TRUE(scene.step().environment.empty());
  scene.set_pose(mover, Pose::translation(9, 0, 0));
  EXPECT_FALSE(scene.step().environment.empty());
  scene.set_pose(mover, Pose::identity());
  EXPECT_TRUE(scene.step().environment.empty());
}

// R70, among movers, the other one moved.
TEST(SceneRegressions, R70FindsAMoverThatCameToAnother) {
  Scene scene;
  const Shape sphere(scaled_sphere(60, 1));
  scene.add_mover(Body(sphere));
  const MoverId other = scene.add_mover(Body(sphere, Pose::translation(100, 0, 0)));
  EXPECT_TRUE(scene.step().movers.empty());
  scene.set_pose(other, Pose::translation(1, 0, 0));
  EXPECT_FALSE(scene.step().movers.empty());
}

// R72: pruning dropped pairs of meshes. 1000 bodies, each pair by brute force.
TEST(SceneRegressions, R72FindsEveryPairOfAThousandBodies) {
  Rng rng(72);
  std::vector<Shape> shapes;
  for (const double radius : {0.3, 1.0, 2.5}) {
    shapes.emplace_back(scaled_sphere(8, radius));
  }
  Scene scene;
  for (int k = 0; k < 1000; ++k) {
    scene.add_mover(Body(shapes[rng.below(3)], random_turn(rng, 16)));
  }
  std::vector<MoverContact> expected;
  for (MoverId a = 0; a < 1000; ++a) {
    const Body& first = scene.mover(a);
    for (MoverId b = a + 1; b < 1000; ++b) {
      const Body& second = scene.mover(b);
      for (const auto& [i, j] :
           reference::overlap(first.shape.mesh(), first.pose, second.shape.mesh(), second.pose)
               .pairs) {
        expected.push_back({a, b, i, j});
      }
    }
  }
  ASSERT_GT(expected.size(), 1000U);
  EXPECT_EQ(scene.step().movers, expected);
}

// R73: moving one body rebuilt or copied everything. Here it costs what its boxes cost: the shape
// and its layout stay the very same, memory stays, and no node is tested for what is far away.
TEST(SceneRegressions, R73MovesALargeBodyWithoutWorkOnItsTree) {
  const Shape body(scaled_sphere(48'000, 1));
  Scene scene;
  scene.add_environment(Body(body, Pose::translation(1000, 0, 0)));
  const MoverId mover = scene.add_mover(Body(body));
  EXPECT_TRUE(scene.step().environment.empty());
  scene.set_pose(mover, Pose::translation(0, 1, 2));
  EXPECT_TRUE(scene.step().environment.empty());
  const std::size_t memory = scene.memory();  // of a scene that has moved
  std::uint64_t nodes = 0;
  for (int k = 0; k < 100'000; ++k) {
    scene.set_pose(mover, Pose::translation(0.001 * k, 1, 2));
    if (k % 100 == 0) {
      nodes += scene.step().cost.node_tests;
    }
  }
  EXPECT_EQ(nodes, 0U);
  EXPECT_EQ(scene.memory(), memory);
  EXPECT_EQ(&scene.mover(mover).shape.layout(), &body.layout());
  EXPECT_EQ(&scene.mover(mover).shape.mesh(), &body.mesh());
  scene.set_pose(mover, Pose::translation(999, 0, 0));
  EXPECT_FALSE(scene.step().environment.empty());
}

// R74: adding and removing degraded the structure until the stack ended.
TEST(SceneRegressions, R74KeepsMemoryAndWorkBoundedOverManyAdditionsAndRemovals) {
  const Shape sphere(scaled_sphere(24, 1));
  Rng rng(74);
  Scene scene;
  std::vector<MoverId> movers;
  std::vector<EnvironmentId> parts;
  for (int k = 0; k < 50; ++k) {
    movers.push_back(scene.add_mover(Body(sphere, random_turn(rng, 10))));
    parts.push_back(scene.add_environment(Body(sphere, random_turn(rng, 10))));
  }
  std::size_t least = 0;
  std::size_t most = 0;
  for (std::size_t k = 0; k < 100'000; ++k) {
    const std::size_t at = k % movers.size();
    scene.remove_mover(movers[at]);
    movers[at] = scene.add_mover(Body(sphere, random_turn(rng, 10)));
    scene.remove_environment(parts[at]);
    parts[at] = scene.add_environment(Body(sphere, random_turn(rng, 10)));
    if (k % 1000 == 0) {
      const StepReport report = scene.step();
      EXPECT_LE(report.box_pairs, 50U * 50U + 50U * 49U / 2);
      most = std::max(most, scene.memory());
      least = k == 10'000 ? most : least;
    }
  }
  EXPECT_LE(most, 2 * least);
  EXPECT_EQ(scene.movers().size(), 50U);
  EXPECT_EQ(scene.environments().size(), 50U);
  EXPECT_EQ(movers.back(), 50U + 100'000U - 1U);  // never given twice
}

// R77: a NaN in a pose looped, crashed, or was silently far from everything.
TEST(SceneRegressions, R77RefusesAPoseThatIsNotFiniteAndNamesIt) {
  Scene scene;
  const Shape sphere(scaled_sphere(24, 1));
  Body van(sphere);
  van.name = "van";
  const MoverId mover = scene.add_mover(van);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t entry = 0; entry < 12; ++entry) {
      Pose pose;
      pose.m[entry] = bad;
      try {
        scene.set_pose(mover, pose);
        FAIL() << "entry " << entry << " was taken";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::not_finite);
        EXPECT_NE(std::string(error.what()).find("mover 0 (van)"), std::string::npos)
            << error.what();
      }
      Body part(sphere);
      part.pose = pose;
      EXPECT_THROW(scene.add_environment(part), Error);
      EXPECT_THROW(scene.add_mover(part), Error);
    }
  }
  EXPECT_EQ(scene.mover(mover).pose, Pose::identity());
  EXPECT_EQ(scene.movers().size(), 1U);
  EXPECT_TRUE(scene.environments().empty());
}

// R79: empty scenes and meshes of few triangles crashed or looped.
TEST(SceneRegressions, R79AnswersForEmptyScenesAndTinyMeshes) {
  Scene scene;
  EXPECT_TRUE(scene.step().environment.empty());
  EXPECT_TRUE(scene.step().movers.empty());
  EXPECT_EQ(scene.step().coverage, Coverage::complete);
  Mesh points;  // vertices without faces
  points.vertices = {{0, 0, 0}, {1, 1, 1}};
  const Shape nothing{points};
  const MoverId empty = scene.add_mover(Body(nothing));
  scene.add_environment(Body(nothing));
  scene.add_environment(Body());
  EXPECT_EQ(scene.step().box_pairs, 0U);
  scene.set_pose(empty, Pose::translation(1, 2, 3));
  const Triangle flat{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  scene.add_environment(Body(Shape(triangle_mesh(flat))));
  const Vec3 point{0.5, 0.5, 0};
  const MoverId dot = scene.add_mover(Body(Shape(triangle_mesh({point, point, point}))));
  const StepReport report = scene.step();
  ASSERT_EQ(report.environment.size(), 1U);
  EXPECT_EQ(report.environment[0], (EnvironmentContact{dot, 2, 0, 0}));
  EXPECT_TRUE(report.movers.empty());
}

Body dot_at(double x) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return Body(Shape(triangle_mesh(triangle)), Pose::translation(x, 0, 0));
}

// R118: movers of one group at one place made quadratically many pairs, which were dropped one by
// one afterwards and whose memory was kept: for 20,000 some gigabytes.
TEST(SceneRegressions, R118MoversOfOneGroupInOnePlaceMakeNoPairs) {
  constexpr MoverId kMovers = test::kSlowBuild ? 4'000 : 20'000;
  const test::AllocationWatch watch;
  Scene scene;
  const Body dot = dot_at(0);
  for (MoverId k = 0; k < kMovers; ++k) {
    scene.add_mover(dot, 1);
  }
  for (int step = 0; step < 3; ++step) {
    const StepReport report = scene.step();
    EXPECT_EQ(report.box_pairs, 0U);
    EXPECT_EQ(report.queries, 0U);
    EXPECT_TRUE(report.movers.empty());
  }
  // One of another group, and one of none, meet all others.
  const MoverId other = scene.add_mover(dot, 2);
  const MoverId alone = scene.add_mover(dot);
  for (int step = 0; step < 2; ++step) {
    const StepReport report = scene.step();
    EXPECT_EQ(report.box_pairs, 2 * kMovers + 1);
    ASSERT_EQ(report.movers.size(), 2 * kMovers + 1);
    EXPECT_EQ(report.movers.front(), (MoverContact{0, other, 0, 0}));
    EXPECT_EQ(report.movers.back(), (MoverContact{other, alone, 0, 0}));
  }
  EXPECT_LT(scene.memory(), std::size_t{50} << 20);
  EXPECT_LT(watch.peak(), std::size_t{50} << 20);
}

// R118: and what so many pairs needed was never given back.
TEST(SceneRegressions, R118MemoryOfManyPairsIsGivenBack) {
  constexpr MoverId kMovers = 700;
  constexpr std::size_t kPairs = std::size_t{kMovers} * (kMovers - 1) / 2;
  const Body dot = dot_at(0);
  enum class Change { leave, leave_one_by_one, remove, share_a_group, ignore };
  for (const Change change : {Change::leave, Change::leave_one_by_one, Change::remove,
                              Change::share_a_group, Change::ignore}) {
    Scene scene;
    for (MoverId k = 0; k < kMovers; ++k) {
      scene.add_mover(dot);
    }
    ASSERT_EQ(scene.step().movers.size(), kPairs);
    const std::size_t before = scene.memory();
    EXPECT_GT(before, 20 * kPairs);
    for (MoverId k = 1; k < kMovers; ++k) {
      if (change == Change::leave || change == Change::leave_one_by_one) {
        scene.set_pose(k, Pose::translation(2.0 * k, 0, 0));
      } else if (change == Change::remove) {
        scene.remove_mover(k);
      } else if (change == Change::share_a_group) {
        scene.set_group(k, 1);
        scene.set_group(0, 1);
      }
      for (MoverId j = 0; change == Change::ignore && j < k; ++j) {
        scene.ignore(j, k);
      }
      if (change == Change::leave_one_by_one && k % 50 == 0) {
        static_cast<void>(scene.step());
      }
    }
    EXPECT_TRUE(scene.step().movers.empty());
    const std::size_t lists = change == Change::ignore ? std::size_t{20} * kPairs : 0;
    EXPECT_LT(scene.memory(), std::size_t{2048} * kMovers + lists) << static_cast<int>(change);
    if (change == Change::ignore) {
      for (MoverId k = 1; k < kMovers; ++k) {
        scene.remove_mover(k);
      }
      static_cast<void>(scene.step());
      EXPECT_LT(scene.memory(), std::size_t{1} << 16);
    }
  }
}

}  // namespace

}  // namespace soms
