// Steps that stop at each mover's first contact.
#include "soms/generate/shapes.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/query/overlap.h"
#include "soms/scene/scene.h"

#include "tests/scene/random_bodies.h"
#include "tests/scene/scenes.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace soms {

namespace {

constexpr StepOptions kFirst{.mode = OverlapMode::any, .scope = StepScope::first_contact};

std::uint64_t tests_of(const Cost& cost) {
  return cost.node_tests + cost.triangle_tests;
}

Box world_box_of(const Body& body) {
  return detail::moved_bounds(body.pose, body.shape.bounds());
}

/// What it costs to query one mover after the other, each until its first contact.
struct OneByOne {
  Cost cost;
  std::uint64_t queries = 0;

  explicit OneByOne(const Scene& scene, const test::Exclusions& exclusions = {}) {
    for (const MoverId mover : scene.movers()) {
      query(scene, exclusions, mover);
    }
  }

  void query(const Scene& scene, const test::Exclusions& exclusions, MoverId mover) {
    const Body& body = scene.mover(mover);
    for (const EnvironmentId part : scene.environments()) {
      if (exclusions.parts.count({mover, part}) == 0 && touch(body, scene.environment(part))) {
        return;
      }
    }
    for (const MoverId other : scene.movers()) {
      const auto [a, b] = std::minmax(mover, other);
      if (a != b && !exclusions.excludes(a, b) && touch(scene.mover(a), scene.mover(b))) {
        return;
      }
    }
  }

  bool touch(const Body& a, const Body& b) {
    if (!overlaps(world_box_of(a), world_box_of(b))) {
      return false;
    }
    const Overlap answer = overlap(a, b, {.mode = OverlapMode::any});
    cost += answer.cost;
    ++queries;
    return answer.any;
  }
};

TEST(StepScope, FirstContactFindsWhichMoversTouchAtNoMoreCostThanOneByOne) {
  std::size_t touching = 0;
  std::size_t free = 0;
  std::uint64_t saved = 0;
  test::for_each_case("scene/first-contact", 80, [&](Rng& rng) {
    Scene scene = test::random_scene(rng, rng.uniform(2, 14), rng.below(30), rng.below(12));
    test::Exclusions exclusions;
    for (const MoverId id : scene.movers()) {
      exclusions.groups[id] = static_cast<std::uint32_t>(rng.below(6));
      scene.set_group(id, exclusions.groups[id]);
    }
    const StepReport all = scene.step();
    const StepReport first = scene.step(kFirst);
    ASSERT_EQ(first.touching_movers(), all.touching_movers());
    EXPECT_EQ(first.coverage, Coverage::first);
    EXPECT_EQ(first.box_pairs, all.box_pairs);
    EXPECT_TRUE(std::includes(all.environment.begin(), all.environment.end(),
                              first.environment.begin(), first.environment.end()));
    EXPECT_TRUE(std::includes(all.movers.begin(), all.movers.end(), first.movers.begin(),
                              first.movers.end()));
    EXPECT_LE(first.environment.size() + first.movers.size(), scene.movers().size());
    const OneByOne single(scene, exclusions);
    ASSERT_LE(first.queries, single.queries);
    ASSERT_LE(tests_of(first.cost), tests_of(single.cost));
    saved += all.queries - first.queries;
    touching += first.touching_movers().size();
    free += scene.movers().size() - first.touching_movers().size();
  });
  EXPECT_GT(touching, 300U);
  EXPECT_GT(free, 300U);
  EXPECT_GT(saved, 1000U);
}

TEST(StepScope, FirstContactReportsTheSameBytesForAnyThreadsAndFromNothing) {
  Rng rng(23);
  Scene scene = test::random_scene(rng, 9, 300, 30);
  for (const OverlapMode mode : {OverlapMode::any, OverlapMode::first, OverlapMode::all}) {
    StepOptions options = kFirst;
    options.mode = mode;
    const StepReport one = scene.step(options);
    ASSERT_GT(one.touching_movers().size(), 100U);
    for (const bool coherent : {true, false}) {
      options.coherent = coherent;
      for (const int threads : {1, 2, 4}) {
        const StepReport report = scene.step(options, Limits{.threads = threads});
        EXPECT_EQ(report.environment, one.environment);
        EXPECT_EQ(report.movers, one.movers);
        EXPECT_EQ(report.queries, one.queries);
        EXPECT_EQ(report.cost, one.cost);
      }
    }
  }
}

// The mode still says what is reported of a pair of bodies.
TEST(StepScope, FirstContactListsOfEachPairWhatTheModeSays) {
  Rng rng(5);
  Scene scene = test::random_scene(rng, 5, 60, 6);
  StepOptions options = kFirst;
  options.mode = OverlapMode::all;
  const StepReport every = scene.step();
  const StepReport all = scene.step(options);
  options.mode = OverlapMode::first;
  const StepReport least = scene.step(options);
  EXPECT_EQ(all.touching_movers(), every.touching_movers());
  std::set<std::pair<MoverId, EnvironmentId>> pairs;
  std::size_t of_these = 0;
  for (const EnvironmentContact& contact : all.environment) {
    pairs.emplace(contact.mover, contact.part);
  }
  for (const EnvironmentContact& contact : every.environment) {
    of_these += pairs.count({contact.mover, contact.part});
  }
  EXPECT_EQ(all.environment.size(), of_these);
  EXPECT_GT(of_these, pairs.size());
  ASSERT_EQ(least.environment.size(), pairs.size());
  for (const EnvironmentContact& contact : least.environment) {
    EXPECT_EQ(contact, *std::lower_bound(every.environment.begin(), every.environment.end(),
                                         EnvironmentContact{contact.mover, contact.part, 0, 0}));
  }
}

// 200 movers that all touch each other: a comparison for each after the first.
TEST(StepScope, FirstContactInOnePlaceComparesEachMoverOnce) {
  constexpr std::uint32_t kMovers = 200;
  const Shape shape(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  Scene scene;
  for (std::uint32_t k = 0; k < kMovers; ++k) {
    scene.add_mover(Body(shape, Pose::translation(0.001 * k, 0, 0)));
  }
  const StepReport report = scene.step(kFirst);
  EXPECT_EQ(report.queries, kMovers - 1);
  EXPECT_EQ(report.movers.size(), kMovers - 1);
  EXPECT_EQ(report.touching_movers().size(), kMovers);
  EXPECT_EQ(report.box_pairs, kMovers * (kMovers - 1) / 2);
}

// A mover that touches the environment is compared with no mover on its own behalf, but a free one
// is compared with it.
TEST(StepScope, FirstContactOfAFreeMoverMayBeOneThatTouchesTheEnvironment) {
  const Shape shape(test::box_mesh({{0, 0, 0}, {1, 1, 1}}));
  Scene scene;
  const EnvironmentId wall = scene.add_environment(Body(shape, Pose::translation(-0.5, 0, 0)));
  const MoverId a = scene.add_mover(Body(shape, Pose::translation(0, 0, 0)));
  const MoverId b = scene.add_mover(Body(shape, Pose::translation(0.25, 0, 0)));
  const MoverId c = scene.add_mover(Body(shape, Pose::translation(0.75, 0, 0)));
  const StepReport report = scene.step(kFirst);
  ASSERT_EQ(report.environment.size(), 2U);
  EXPECT_EQ(report.environment[0].part, wall);
  ASSERT_EQ(report.movers.size(), 1U);
  EXPECT_EQ(report.movers[0].a, a);
  EXPECT_EQ(report.movers[0].b, c);
  EXPECT_EQ(report.touching_movers(), (std::vector<MoverId>{a, b, c}));
  EXPECT_EQ(report.queries, 3U);
  StepOptions alone = kFirst;
  alone.mover_mover = false;
  EXPECT_EQ(scene.step(alone).touching_movers(), (std::vector<MoverId>{a, b}));
}

}  // namespace

}  // namespace soms
