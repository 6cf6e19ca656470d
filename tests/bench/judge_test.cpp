#include "bench/peers/core/judge.h"

#include "soms/query/reference/overlap.h"

#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

namespace soms::bench {
namespace {

/// Small boxes on a floor of two triangles, which are large beside a cell of the grid.
FloatMesh yard() {
  FloatMesh mesh{{{-500, -500, 0}, {500, -500, 0}, {0, 700, 0}}, {{0, 1, 2}}};
  for (int i = 0; i < 40; ++i) {
    append(mesh, box({0.3 * i - 6, 0.1 * i, 0.1}, {0.1, 0.1, 0.1}, 0.3 * i));
  }
  return mesh;
}

TEST(PairCounter, CountsWhatBruteForceCounts) {
  const FloatMesh knot = torus_knot(25, 8);
  const FloatMesh floor = yard();
  const PairCounter twins(knot, knot);
  const PairCounter on_floor(knot, floor);
  std::uint64_t pairs = 0;
  test::for_each_case("bench/pair-counter", 60, [&](Rng& rng) {
    const Pose pose = random_rotation(rng, rng.uniform(0, 1.6) * random_direction(rng));
    const std::uint64_t near =
        reference::overlap(widened(knot), pose, widened(knot), {}).pairs.size();
    EXPECT_EQ(twins.count(pose, false), near);
    EXPECT_EQ(twins.count(pose, true), near == 0 ? 0U : 1U);
    const std::uint64_t far =
        reference::overlap(widened(knot), pose, widened(floor), {}).pairs.size();
    EXPECT_EQ(on_floor.count(pose, false), far);
    pairs += near + far;
  });
  EXPECT_GT(pairs, 1000U);
}

TEST(PairCounter, CountsTouchingPairs) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const PairCounter counter(cube, cube);
  const Pose beside = Pose::translation(2, 0, 0);
  EXPECT_EQ(counter.count(beside, false),
            reference::overlap(widened(cube), beside, widened(cube), {}).pairs.size());
  EXPECT_GT(counter.count(beside, false), 0U);
  EXPECT_EQ(counter.count(Pose::translation(2.001, 0, 0), false), 0U);
}

// 10^15 cells of the grid lie within the box of the large triangle.
TEST(PairCounter, EndsWhereALargeTriangleReachesOverTinyOnesFarApart) {
  const FloatMesh large{{{-500, -500, 0}, {500, -500, 0}, {0, 700, 0}}, {{0, 1, 2}}};
  FloatMesh tiny;
  for (int i = 0; i < 40; ++i) {
    append(tiny, box({25.0 * i - 500, 17.0 * i - 340, 10.0 * i - 200}, {0.001, 0.001, 0.001}));
  }
  const PairCounter counter(large, tiny);
  test::for_each_case("bench/pair-counter/large", 10, [&](Rng& rng) {
    const Pose pose = random_rotation(rng, {});
    const std::uint64_t pairs =
        reference::overlap(widened(large), pose, widened(tiny), {}).pairs.size();
    EXPECT_EQ(counter.count(pose, false), pairs);
    EXPECT_GT(pairs, 0U);  // one of them is where it turns about
  });
}

TEST(Judge, LooksAtEveryQuestionOnWhichTwoDifferHoweverLittleItMayLookAt) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const std::vector<PairCounter> counter{{cube, cube}};
  std::vector<Pose> poses;
  poses.reserve(100);
  for (int i = 0; i < 100; ++i) {
    poses.push_back(Pose::translation(0.05 * i, 0, 0));
  }
  std::vector<Answers> answers(3, Answers{std::vector<double>(100)});
  for (std::size_t i = 0; i < 100; ++i) {
    answers[0].values[i] = answers[1].values[i] = i <= 40 ? 1 : 0;
  }
  answers[2] = answers[0];
  answers[2].values.resize(60);
  answers[1].values[77] = 1;
  answers[2].values[13] = 0;
  const auto verdicts = judge(counter, {Job::any, poses}, answers, 1);
  EXPECT_EQ(verdicts[0].wrong, 0U);
  EXPECT_EQ(verdicts[0].checked, 3U);
  EXPECT_EQ(verdicts[1].wrong_questions, std::vector<std::size_t>{77});
  EXPECT_EQ(verdicts[2].wrong_questions, std::vector<std::size_t>{13});
  EXPECT_EQ(verdicts[2].checked, 2U);
  EXPECT_EQ(verdicts[1].share, 0.01);  // one of its hundred, not one of the three looked at
  EXPECT_EQ(verdicts[2].share, 1.0 / 60);
}

// Half of the sample is wrong without a contradiction: half of all answers will be.
TEST(Judge, TakesASampleForTheAnswersThatNobodyContradicts) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const std::vector<PairCounter> counter{{cube, cube}};
  const std::vector<Pose> poses(40, Pose::translation(0.5, 0, 0));
  std::vector<Answers> answers(2, Answers{std::vector<double>(40, 0)});
  for (std::size_t i = 0; i < 20; ++i) {
    answers[0].values[i] = answers[1].values[i] = 1;
  }
  answers[1].values[3] = 0;
  const auto verdicts = judge(counter, {Job::any, poses}, answers, 120);  // looks at 10
  EXPECT_EQ(verdicts[0].checked, 11U);
  EXPECT_EQ(verdicts[0].wrong, 5U);
  EXPECT_EQ(verdicts[0].share, (0 + 39 * 0.5) / 40);
  EXPECT_EQ(verdicts[1].share, (1 + 39 * 0.5) / 40);
}

TEST(Judge, FindsAFaultThatAllShareWhereItMayLook) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const std::vector<PairCounter> counter{{cube, cube}};
  const std::vector<Pose> poses(5, Pose::translation(0.5, 0, 0));
  const std::vector<Answers> answers(2, Answers{std::vector<double>(5, 0)});
  const auto verdicts = judge(counter, {Job::any, poses}, answers, 1e6);
  EXPECT_EQ(verdicts[0].wrong, 5U);
  EXPECT_EQ(verdicts[1].wrong, 5U);
}

TEST(Judge, CountsBoxesThatOverlapOrTouch) {
  const FloatBox a{{0, 0, 0}, {1, 1, 1}};
  const FloatBox b{{1, 1, 1}, {2, 2, 2}};
  const FloatBox c{{0, 3, 0}, {2, 4, 2}};
  const std::vector<std::vector<FloatBox>> frames{{a, b, c}, {a, a, b}};
  const std::vector<Answers> answers{{{1, 3}}, {{1, 2}}};
  const auto verdicts = judge(frames, answers);
  EXPECT_EQ(verdicts[0].wrong, 0U);
  EXPECT_EQ(verdicts[1].wrong_questions, std::vector<std::size_t>{1});
}

TEST(Judge, CountsBoxesOfAllSizesAsEveryPairRequestedAloneDoes) {
  test::for_each_case("bench/boxes", 20, [](Rng& rng) {
    std::vector<FloatBox> boxes;
    for (int i = 0; i < 200; ++i) {
      const double side = rng.below(20) == 0 ? 30 : 1;
      const Vec3 lower{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-2, 2)};
      const Vec3 extent{side * rng.unit(), side * rng.unit(), rng.unit()};
      boxes.push_back({narrow(lower), narrow(lower + extent)});
    }
    double pairs = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        pairs += overlaps(boxes[i], boxes[j]) ? 1 : 0;
      }
    }
    const std::vector<std::vector<FloatBox>> frames{boxes};
    EXPECT_EQ(judge(frames, std::vector<Answers>{{{pairs}}})[0].wrong, 0U);
    EXPECT_EQ(judge(frames, std::vector<Answers>{{{pairs + 1}}})[0].wrong, 1U);
  });
}

}  // namespace
}  // namespace soms::bench
