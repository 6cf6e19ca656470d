#include "bench/peers/core/distance_judge.h"

#include "soms/query/overlap.h"

#include "bench/peers/core/judge.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

#include <cmath>
#include <limits>

namespace soms::bench {
namespace {

FloatMesh one_triangle(const std::array<float, 3>& a, const std::array<float, 3>& b,
                       const std::array<float, 3>& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

double least_by_pairs(const FloatMesh& mover, const Pose& pose, const FloatMesh& fixed) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mover.triangles.size(); ++i) {
    for (std::size_t j = 0; j < fixed.triangles.size(); ++j) {
      const FloatMesh s{mover.vertices, {mover.triangles[i]}};
      const FloatMesh t{fixed.vertices, {fixed.triangles[j]}};
      least = std::min(least, DistanceJudge(s, t).distance(pose));
    }
  }
  return least;
}

TEST(DistanceJudge, MeasuresCornerToFaceAndEdgeToEdge) {
  const FloatMesh floor = one_triangle({-4, -4, 0}, {4, -4, 0}, {0, 8, 0});
  const FloatMesh spike = one_triangle({0, 0, 0}, {1, 0, 5}, {0, 1, 5});
  EXPECT_DOUBLE_EQ(DistanceJudge(spike, floor).distance(Pose::translation(0, 0, 3)), 3);
  const FloatMesh along_x = one_triangle({-1, 0, 0}, {1, 0, 0}, {0, 0, -9});
  const FloatMesh along_y = one_triangle({0, -1, 0}, {0, 1, 0}, {0, 0, 9});
  EXPECT_DOUBLE_EQ(DistanceJudge(along_y, along_x).distance(Pose::translation(0, 0, 0.25)), 0.25);
}

TEST(DistanceJudge, MeasuresWhatEveryPairAloneMeasures) {
  const FloatMesh knot = torus_knot(16, 5);
  const DistanceJudge judge(knot, knot);
  int apart = 0;
  test::for_each_case("bench/distance-judge", 12, [&](Rng& rng) {
    const Pose pose = random_rotation(rng, rng.uniform(0.8, 4) * random_direction(rng));
    const double distance = judge.distance(pose);
    EXPECT_EQ(distance, least_by_pairs(knot, pose, knot));
    apart += distance > 0 ? 1 : 0;
  });
  EXPECT_GT(apart, 3);
}

// A corner through the middle of a face: no corner and no edge is at distance 0 from another.
TEST(DistanceJudge, IsNothingExactlyWhereBodiesTouch) {
  const FloatMesh floor = one_triangle({-4, -4, 0}, {4, -4, 0}, {0, 8, 0});
  const FloatMesh spike = one_triangle({0, 0, -1}, {1, 0, 5}, {0, 1, 5});
  EXPECT_EQ(DistanceJudge(spike, floor).distance({}), 0);
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(DistanceJudge(cube, cube).distance(Pose::translation(2, 0, 0)), 0);
  EXPECT_GT(DistanceJudge(cube, cube).distance(Pose::translation(std::nextafter(2, 3), 0, 0)), 0);
}

class JudgeOfDistances : public testing::Test {
 protected:
  std::vector<Verdict> verdicts(Job job, std::vector<Answers> answers) const {
    return judge(measure_, {job, poses_, clearances_}, answers, 1e6);
  }

  FloatMesh cube_ = box({0, 0, 0}, {1, 1, 1});
  DistanceJudge measure_{cube_, cube_};
  std::vector<Pose> poses_{Pose::translation(3, 0, 0), Pose::translation(2, 0, 0)};
  std::vector<double> clearances_{1 + 1e-7, 0};
};

TEST_F(JudgeOfDistances, AllowsEachLibraryItsRounding) {
  const auto found = verdicts(Job::distance, {{{1 + 1e-7, 1e-7}, Precision::floats},
                                              {{1 + 1e-7, 1e-7}, Precision::doubles},
                                              {{1, 0}, Precision::exact},
                                              {{1 + 1e-3, 0}, Precision::floats},
                                              {{1, 1e-13}, Precision::exact},
                                              {{0, 0}, Precision::exact}});
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[1].wrong_questions, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(found[2].wrong, 0U);
  EXPECT_EQ(found[3].wrong_questions, std::vector<std::size_t>{0});
  EXPECT_EQ(found[4].wrong_questions, std::vector<std::size_t>{1});
  EXPECT_EQ(found[5].wrong_questions, std::vector<std::size_t>{0});
}

TEST_F(JudgeOfDistances, TakesBothFlagsWhereTheClearanceIsWithinTheRounding) {
  const auto found = verdicts(Job::within, {{{1, 1}, Precision::floats},
                                            {{0, 0}, Precision::floats},
                                            {{0, 1}, Precision::doubles},
                                            {{1, 0}, Precision::exact}});
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[1].wrong, 0U);
  EXPECT_EQ(found[2].wrong_questions, std::vector<std::size_t>{0});
  EXPECT_EQ(found[3].wrong_questions, std::vector<std::size_t>{1});
}

TEST_F(JudgeOfDistances, LooksAtEveryContradictionHoweverLittleItMayLookAt) {
  poses_.assign(50, Pose::translation(3, 0, 0));
  std::vector<Answers> answers(3, Answers{std::vector<double>(50, 1)});
  answers[1].precision = Precision::floats;
  answers[1].values[20] = 1 + 1e-7;  // rounded, which contradicts nothing
  answers[2].values[30] = 1.5;
  const auto found = judge(measure_, {Job::distance, poses_}, answers, 1);
  EXPECT_EQ(found[0].checked, 2U);
  EXPECT_EQ(found[1].wrong, 0U);
  EXPECT_EQ(found[2].wrong_questions, std::vector<std::size_t>{30});
}

TEST(NearMisses, LeaveTheGapThatTheirNameSays) {
  const Scene scene = knot_scene(1'000, 1);
  const DistanceJudge judge(scene.mover, scene.fixed);
  const Body twin(widened(scene.fixed));
  for (const auto& [set, gap] : {std::pair{std::size_t{2}, 0.001}, {std::size_t{3}, 0.01}}) {
    ASSERT_EQ(scene.sets[set].poses.size(), kPoses);
    for (std::size_t i = 0; i < kPoses; i += 97) {
      const Pose& pose = scene.sets[set].poses[i];
      EXPECT_NEAR(judge.distance(pose), gap, 0.02 * gap) << scene.sets[set].name << i;
      Body knot = twin;
      knot.pose = pose;
      EXPECT_FALSE(overlap(knot, twin).any);
    }
  }
}

}  // namespace
}  // namespace soms::bench
