#include "bench/peers/core/solid_judge.h"

#include "soms/query/reference/solid.h"

#include "bench/peers/core/judge.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

namespace soms::bench {
namespace {

double number_of(Relation relation) {
  return static_cast<double>(relation);
}

TEST(SolidJudge, FindsWhichBoxIsInTheOther) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const FloatMesh small = box({0, 0, 0}, {0.25, 0.25, 0.25});
  EXPECT_EQ(SolidJudge(small, cube).relation({}), number_of(Relation::a_in_b));
  EXPECT_EQ(SolidJudge(cube, small).relation({}), number_of(Relation::b_in_a));
  EXPECT_EQ(SolidJudge(cube, small).relation(Pose::translation(3, 0, 0)),
            number_of(Relation::clear));
  EXPECT_EQ(SolidJudge(cube, small).relation(Pose::translation(1, 0.1, 0.2)),
            number_of(Relation::crossing));
}

TEST(SolidJudge, LeavesOpenWhatNoCornerProves) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(SolidJudge(cube, cube).relation({}), SolidJudge::kTouching);
  EXPECT_EQ(SolidJudge(cube, cube).relation(Pose::translation(2, 0.5, 0)), SolidJudge::kTouching);
}

TEST(SolidJudge, SaysWhatTheReferenceSays) {
  const FloatMesh knot = torus_knot(16, 5);
  const SolidJudge judge(knot, knot);
  const Body fixed(widened(knot));
  int crossing = 0;
  int clear = 0;
  test::for_each_case("bench/solid-judge", 12, [&](Rng& rng) {
    Body mover(widened(knot));
    mover.pose = random_rotation(rng, rng.uniform(0.5, 2) * random_direction(rng));
    const Relation relation = reference::solid_by_brute_force(mover, fixed).relation;
    EXPECT_EQ(judge.relation(mover.pose), number_of(relation));
    crossing += relation == Relation::crossing ? 1 : 0;
    clear += relation == Relation::clear ? 1 : 0;
  });
  EXPECT_GT(crossing, 2);
  EXPECT_GT(clear, 2);
}

TEST(SolidJudge, FindsALieAndAllowsWhatItLeavesOpen) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const SolidJudge solids(cube, cube);
  const std::vector<Pose> poses{Pose(), Pose::translation(3, 0, 0),
                                Pose::translation(0.5, 0.25, 0.1)};
  const auto verdict = [&](Relation first, Relation second, Relation third) {
    const Answers answers{{number_of(first), number_of(second), number_of(third)}};
    return judge(solids, {.job = Job::solid, .poses = poses}, std::span(&answers, 1), 1e6).front();
  };
  EXPECT_EQ(verdict(Relation::same, Relation::clear, Relation::crossing).wrong, 0U);
  EXPECT_EQ(verdict(Relation::clear, Relation::clear, Relation::crossing).wrong_questions,
            std::vector<std::size_t>{0});
  EXPECT_EQ(verdict(Relation::same, Relation::touching, Relation::a_in_b).wrong, 2U);
  EXPECT_EQ(verdict(Relation::same, Relation::clear, Relation::crossing).checked, 3U);
}

}  // namespace
}  // namespace soms::bench
