#include "soms/scene/scene.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <set>
#include <stop_token>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr Box kUnit{{0, 0, 0}, {1, 1, 1}};

Shape box_shape(const Box& box = kUnit) {
  return Shape(test::box_mesh(box));
}

Body body_at(const Shape& shape, double x, double y = 0, double z = 0) {
  return Body(shape, Pose::translation(x, y, z));
}

TEST(Scene, TellsWhichTrianglesOfAMoverTouchWhichPart) {
  Scene scene;
  const EnvironmentId near = scene.add_environment(body_at(box_shape(), 0));
  scene.add_environment(body_at(box_shape(), 10));
  const MoverId mover = scene.add_mover(body_at(box_shape(), 0.5, 0.25, 0.25));
  const StepReport report = scene.step();
  ASSERT_FALSE(report.environment.empty());
  for (const EnvironmentContact& contact : report.environment) {
    EXPECT_EQ(contact.mover, mover);
    EXPECT_EQ(contact.part, near);
  }
  EXPECT_EQ(report.queries, 1U);
  EXPECT_EQ(report.coverage, Coverage::complete);
  EXPECT_TRUE(report.movers.empty());
}

TEST(Scene, ReportsWhatAScanOfAllPairsReports) {
  std::size_t contacts = 0;
  test::for_each_case("scene/all-pairs", 60, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, rng.uniform(2, 14), rng.below(30), rng.below(20));
    for (int step = 0; step < 3; ++step) {
      const StepReport report = scene.step();
      const StepReport expected = test::scan(scene);
      ASSERT_EQ(report.environment, expected.environment);
      ASSERT_EQ(report.movers, expected.movers);
      contacts += report.environment.size() + report.movers.size();
      for (const MoverId id : scene.movers()) {
        scene.set_pose(id, test::random_pose(rng, 8));
      }
    }
  });
  EXPECT_GT(contacts, 10000U);
}

TEST(Scene, ReportsTheSameBytesForAnyNumberOfThreads) {
  Rng rng(11);
  Scene scene = test::random_scene(rng, 12, 400, 60);
  const StepReport one = scene.step();
  ASSERT_GT(one.environment.size() + one.movers.size(), 1000U);
  for (const int threads : {2, 8}) {
    for (const OverlapMode mode : {OverlapMode::all, OverlapMode::first}) {
      const StepOptions options{.mode = mode};
      const StepReport serial = scene.step(options);
      const StepReport report = scene.step(options, Limits{.threads = threads});
      EXPECT_EQ(report.environment, serial.environment);
      EXPECT_EQ(report.movers, serial.movers);
      EXPECT_EQ(report.hash(), serial.hash());
      EXPECT_EQ(report.queries, serial.queries);
      EXPECT_EQ(report.box_pairs, serial.box_pairs);
      if (mode == OverlapMode::all) {
        EXPECT_EQ(report.cost, serial.cost);
      }
    }
  }
}

// Which pair a query of mode any finds depends on the threads that it is split among.
TEST(Scene, ReportsTheSameAnyPairOfFewBodiesForAnyNumberOfThreads) {
  for (const OverlapMode mode : {OverlapMode::any, OverlapMode::first, OverlapMode::all}) {
    Scene scene;
    scene.add_environment(Body(Shape(generate_sphere(2000))));
    scene.add_mover(Body(Shape(generate_sphere(2000)), Pose::translation(0.5, 0.25, 0.125)));
    const StepReport one = scene.step({.mode = mode});
    ASSERT_FALSE(one.environment.empty());
    for (const int threads : {2, 8}) {
      const StepReport report = scene.step({.mode = mode}, Limits{.threads = threads});
      EXPECT_EQ(report.environment, one.environment);
      EXPECT_EQ(report.hash(), one.hash());
    }
  }
}

TEST(Scene, ReportsFrameByFrameWhatAStepFromNothingReports) {
  Rng rng(13);
  Scene scene = test::random_scene(rng, 12, 300, 40);
  Rng again(13);
  Scene twin = test::random_scene(again, 12, 300, 40);
  std::vector<Pose> poses;
  std::vector<Vec3> motions;
  for (const MoverId id : scene.movers()) {
    poses.push_back(scene.mover(id).pose);
    motions.push_back({rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)});
  }
  std::set<std::uint64_t> hashes;
  for (int frame = 0; frame < 30; ++frame) {
    for (MoverId id = 0; id < poses.size(); ++id) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        poses[id].m[4 * axis + 3] += motions[id][axis];
      }
      scene.set_pose(id, poses[id]);
      twin.set_pose(id, poses[id]);
    }
    const StepReport kept = scene.step();
    const StepReport rebuilt = twin.step({.coherent = false});
    ASSERT_EQ(kept.environment, rebuilt.environment);
    ASSERT_EQ(kept.movers, rebuilt.movers);
    ASSERT_EQ(kept.box_pairs, rebuilt.box_pairs);
    ASSERT_EQ(kept.cost, rebuilt.cost);
    hashes.insert(kept.hash());
  }
  EXPECT_EQ(hashes.size(), 30U);
}

TEST(Scene, SplitsASingleLargePairForManyThreadsAndReportsTheSame) {
  Rng rng(12);
  Mesh soup;
  for (int k = 0; k < 60; ++k) {
    append(soup, test::random_mesh(rng));
  }
  Scene scene;
  scene.add_environment(Body(Shape(soup)));
  scene.add_mover(body_at(Shape(soup), 1, 1, 1));
  const StepReport one = scene.step();
  const StepReport eight = scene.step({}, Limits{.threads = 8});
  EXPECT_GT(one.environment.size(), 1000U);
  EXPECT_EQ(one.environment, eight.environment);
  EXPECT_EQ(one.cost, eight.cost);
}

TEST(Scene, ModesAnyAndFirstGiveOnePairForEachPairOfBodies) {
  test::for_each_case("scene/modes", 20, [](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 20, 10);
    const StepReport all = scene.step();
    const StepReport first = scene.step({.mode = OverlapMode::first});
    const StepReport any = scene.step({.mode = OverlapMode::any});
    std::vector<EnvironmentContact> least = all.environment;
    const auto same_bodies = [](const EnvironmentContact& a, const EnvironmentContact& b) {
      return a.mover == b.mover && a.part == b.part;
    };
    least.erase(std::unique(least.begin(), least.end(), same_bodies), least.end());
    EXPECT_EQ(first.environment, least);
    ASSERT_EQ(any.environment.size(), least.size());
    for (std::size_t k = 0; k < least.size(); ++k) {
      EXPECT_TRUE(same_bodies(any.environment[k], least[k]));
      EXPECT_TRUE(
          std::binary_search(all.environment.begin(), all.environment.end(), any.environment[k]));
    }
    EXPECT_EQ(first.coverage, Coverage::first);
    EXPECT_EQ(any.coverage, Coverage::first);
  });
}

TEST(Scene, ComparesNoMoversWhenNotRequested) {
  Scene scene;
  scene.add_mover(body_at(box_shape(), 0));
  scene.add_mover(body_at(box_shape(), 0.5));
  EXPECT_FALSE(scene.step().movers.empty());
  const StepReport report = scene.step({.mover_mover = false});
  EXPECT_TRUE(report.movers.empty());
  EXPECT_EQ(report.queries, 0U);
}

TEST(Scene, DoesNotComparePairsOfOneGroup) {
  Scene scene;
  const MoverId a = scene.add_mover(body_at(box_shape(), 0), 5);
  const MoverId b = scene.add_mover(body_at(box_shape(), 0.25), 5);
  const MoverId c = scene.add_mover(body_at(box_shape(), 0.5), 0);
  const MoverId d = scene.add_mover(body_at(box_shape(), 0.75), 0);
  std::set<std::pair<MoverId, MoverId>> met;
  for (const MoverContact& contact : scene.step().movers) {
    met.emplace(contact.a, contact.b);
  }
  EXPECT_EQ(met, (std::set<std::pair<MoverId, MoverId>>{{a, c}, {a, d}, {b, c}, {b, d}, {c, d}}));
}

TEST(Scene, IgnoresThePairsItWasReportedTo) {
  Scene scene;
  const EnvironmentId wall = scene.add_environment(body_at(box_shape(), 0.1));
  const EnvironmentId floor = scene.add_environment(body_at(box_shape(), 0.2));
  const MoverId a = scene.add_mover(body_at(box_shape(), 0));
  const MoverId b = scene.add_mover(body_at(box_shape(), 0.5));
  scene.ignore(b, a);
  scene.ignore(a, b);
  scene.ignore_environment(a, wall);
  const StepReport report = scene.step();
  EXPECT_TRUE(report.movers.empty());
  std::set<std::pair<MoverId, EnvironmentId>> met;
  for (const EnvironmentContact& contact : report.environment) {
    met.emplace(contact.mover, contact.part);
  }
  EXPECT_EQ(met, (std::set<std::pair<MoverId, EnvironmentId>>{{a, floor}, {b, wall}, {b, floor}}));
  EXPECT_EQ(report.queries, 3U);
  EXPECT_EQ(report.box_pairs, 4U);  // two parts for each mover; the movers ignore each other
}

// What holds already costs a step nothing: a program may repeat its list in every frame.
TEST(Scene, KeepsTheFilterWhereAnIgnoredPairIsRepeated) {
  Scene scene;
  const MoverId a = scene.add_mover(body_at(box_shape(), 0));
  const MoverId b = scene.add_mover(body_at(box_shape(), 0.5));
  const MoverId c = scene.add_mover(body_at(box_shape(), 0.7));
  scene.ignore(a, b);
  const auto allocations_of_a_step = [&] {
    const test::AllocationWatch watch;
    EXPECT_FALSE(scene.step().movers.empty());
    return watch.count();
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) {
    allocations_of_a_step();
  }
  const std::uint64_t usual = allocations_of_a_step();
  scene.ignore(b, a);
  scene.unignore(a, c);
  EXPECT_EQ(allocations_of_a_step(), usual);
}

TEST(Scene, ForgetsIgnoredPairsOfWhatWasRemoved) {
  Scene scene;
  const MoverId stays = scene.add_mover(body_at(box_shape(), 0));
  const EnvironmentId wall = scene.add_environment(body_at(box_shape(), 0.1));
  EXPECT_FALSE(scene.step().environment.empty());
  for (int k = 0; k < 1000; ++k) {
    const MoverId other = scene.add_mover(body_at(box_shape(), 0.5));
    scene.ignore(stays, other);
    scene.ignore_environment(other, wall);
    const EnvironmentId part = scene.add_environment(body_at(box_shape(), 5));
    scene.ignore_environment(stays, part);
    scene.remove_mover(other);
    scene.remove_environment(part);
  }
  EXPECT_LT(scene.memory(), 50000U);
  scene.add_mover(body_at(box_shape(), 0.5));
  EXPECT_FALSE(scene.step().movers.empty());
}

/// Two movers and two parts, all of which touch; each mover ignores what is its own.
struct SmallScene {
  Scene scene;
  MoverId a = scene.add_mover(body_at(box_shape(), 0));
  MoverId b = scene.add_mover(body_at(box_shape(), 0.5));
  EnvironmentId wall = scene.add_environment(body_at(box_shape(), 0.1));
  EnvironmentId part = scene.add_environment(body_at(box_shape(), 0.2));

  SmallScene() { scene.ignore_environment(b, wall); }
};

// A change is made wholly or, where any of its allocations fails, not at all.
TEST(Scene, ChangesWhollyOrNotAtAllWhereMemoryRunsShort) {
  const std::vector<void (*)(SmallScene&)> changes = {
      [](SmallScene& s) { s.scene.ignore(s.a, s.b); },
      [](SmallScene& s) { s.scene.ignore_environment(s.a, s.part); },
      [](SmallScene& s) { s.scene.remove_mover(s.b); },
      [](SmallScene& s) { s.scene.remove_environment(s.wall); },
      [](SmallScene& s) { s.scene.add_mover(body_at(s.scene.mover(s.a).shape, 0.3)); },
  };
  for (std::size_t k = 0; k < changes.size(); ++k) {
    std::uint64_t failures = 0;
    for (bool failed = true; failed; failures += failed ? 1 : 0) {
      SmallScene small;
      const std::uint64_t before = small.scene.step().hash();
      failed = false;
      try {
        const test::AllocationFault fault(failures);
        changes[k](small);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
      if (failed) {
        ASSERT_EQ(small.scene.step().hash(), before) << "change " << k << ", " << failures;
        small.scene.remove_mover(small.b);
        small.scene.remove_environment(small.wall);
        small.scene.remove_mover(small.a);
        small.scene.remove_environment(small.part);
      }
    }
    EXPECT_GT(failures, 0U) << "change " << k;
  }
}

TEST(Scene, AddsAndRemovesBetweenSteps) {
  test::for_each_case("scene/add-remove", 20, [](Rng& rng) {
    Scene scene = test::random_scene(rng, 6, 10, 6);
    const Shape shape(test::random_mesh(rng));
    for (int k = 0; k < 12; ++k) {
      const std::vector<MoverId> movers = scene.movers();
      const std::vector<EnvironmentId> parts = scene.environments();
      const std::uint64_t what = rng.below(4);
      if (what == 0) {
        scene.add_mover(Body(shape, test::random_pose(rng, 6)));
      } else if (what == 1) {
        scene.add_environment(Body(shape, test::random_pose(rng, 6)));
      } else if (what == 2 && !movers.empty()) {
        scene.remove_mover(movers[rng.below(movers.size())]);
      } else if (!parts.empty()) {
        scene.remove_environment(parts[rng.below(parts.size())]);
      }
      const StepReport report = scene.step();
      const StepReport expected = test::scan(scene);
      ASSERT_EQ(report.environment, expected.environment);
      ASSERT_EQ(report.movers, expected.movers);
    }
  });
}

// The same bodies added in another order: the same contacts under the other numbers.
TEST(Scene, DoesNotDependOnTheOrderOfAdding) {
  test::for_each_case("scene/order", 20, [](Rng& rng) {
    std::vector<Body> bodies;
    for (int k = 0; k < 24; ++k) {
      bodies.emplace_back(Shape(test::random_mesh(rng)), test::random_pose(rng, 5));
    }
    Scene scene;
    Scene reversed;
    const auto count = static_cast<std::uint32_t>(bodies.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      scene.add_mover(bodies[k]);
      reversed.add_mover(bodies[count - 1 - k]);
    }
    std::vector<MoverContact> renamed;
    for (const MoverContact& contact : reversed.step().movers) {
      renamed.push_back({count - 1 - contact.b, count - 1 - contact.a, contact.j, contact.i});
    }
    std::sort(renamed.begin(), renamed.end());
    EXPECT_EQ(scene.step().movers, renamed);
  });
}

TEST(Scene, NamesANumberThatIsNotThere) {
  Scene scene;
  const MoverId mover = scene.add_mover(body_at(box_shape(), 0));
  const EnvironmentId part = scene.add_environment(body_at(box_shape(), 0));
  scene.remove_mover(mover);
  scene.remove_environment(part);
  const auto refused = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage;
    }
    return false;
  };
  EXPECT_TRUE(refused([&] { scene.set_pose(mover, {}); }));
  EXPECT_TRUE(refused([&] { static_cast<void>(scene.mover(mover)); }));
  EXPECT_TRUE(refused([&] { static_cast<void>(scene.environment(part)); }));
  EXPECT_TRUE(refused([&] { scene.remove_mover(mover); }));
  EXPECT_TRUE(refused([&] { scene.remove_environment(part); }));
  EXPECT_TRUE(refused([&] { scene.ignore_environment(mover, part); }));
  const MoverId next = scene.add_mover(body_at(box_shape(), 0));
  EXPECT_NE(next, mover);
  EXPECT_TRUE(refused([&] { scene.ignore(next, next); }));
  EXPECT_TRUE(refused([&] { scene.ignore(next, 77); }));
}

TEST(Scene, StopsWhenRequestedAndGoesOnAfterwards) {
  Rng rng(3);
  Scene scene = test::random_scene(rng, 5, 50, 20);
  const StepReport before = scene.step();
  std::stop_source stop;
  stop.request_stop();
  try {
    static_cast<void>(scene.step({}, Limits{.threads = 2, .stop = stop.get_token()}));
    FAIL() << "the step did not stop";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
  EXPECT_EQ(scene.step().hash(), before.hash());
}

TEST(Scene, HashesBothLists) {
  StepReport report;
  EXPECT_EQ(report.hash(), 0xcbf29ce484222325ULL);
  report.environment.push_back({1, 2, 3, 4});
  const std::uint64_t one = report.hash();
  EXPECT_NE(one, 0xcbf29ce484222325ULL);
  report.movers.push_back({1, 2, 3, 4});
  EXPECT_NE(report.hash(), one);
}

}  // namespace

}  // namespace soms
