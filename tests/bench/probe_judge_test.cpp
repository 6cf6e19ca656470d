#include "bench/peers/core/probe_judge.h"

#include "soms/query/reference/closest.h"
#include "soms/query/reference/contains.h"

#include "bench/peers/core/judge.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

#include <cmath>

namespace soms::bench {
namespace {

const FloatMesh& cube() {
  static const FloatMesh mesh = box({0, 0, 0}, {1, 1, 1});
  return mesh;
}

TEST(RayJudge, MeasuresHitsInUnitsOfTheDirection) {
  const RayJudge judge(cube());
  const Crossings hit = judge.crossings({{-5, 0.25, 0.5}, {2, 0, 0}}, Precision::exact);
  EXPECT_EQ(hit.sure, 2U);
  EXPECT_EQ(hit.open, 0U);
  EXPECT_NEAR(hit.least, 2, 1e-9);
  EXPECT_NEAR(hit.most, 2, 1e-9);
  EXPECT_LT(hit.least, hit.most);
  const Crossings behind = judge.crossings({{-5, 0.25, 0.5}, {-2, 0, 0}}, Precision::exact);
  EXPECT_EQ(behind.sure + behind.open, 0U);
  const Crossings beside = judge.crossings({{-5, 1.25, 0.5}, {2, 0, 0}}, Precision::exact);
  EXPECT_EQ(beside.sure + beside.open, 0U);
}

TEST(RayJudge, LeavesEdgesOpenAndRaysThatBeginOnAFace) {
  const RayJudge judge(cube());
  const Crossings edge = judge.crossings({{-5, 1, 0.25}, {1, 0, 0}}, Precision::exact);
  EXPECT_EQ(edge.sure, 0U);
  EXPECT_GT(edge.open, 0U);
  EXPECT_LE(edge.least, 4);
  EXPECT_EQ(edge.most, kMiss);
  const Crossings start = judge.crossings({{1, 0.25, 0.5}, {1, 0, 0}}, Precision::exact);
  EXPECT_EQ(start.sure, 0U);
  EXPECT_EQ(start.open, 1U);
  EXPECT_EQ(start.least, 0);
}

// A ray 1e-7 beside an edge: floats may take it either way, doubles may not.
TEST(RayJudge, LeavesOpenWhatALibrarysNumbersLeaveOpen) {
  const RayJudge judge(cube());
  const ProbeRay inside{{-5, 1 - 1e-7, 0.25}, {1, 0, 0}};
  EXPECT_EQ(judge.crossings(inside, Precision::exact).sure, 2U);
  const Crossings floats = judge.crossings(inside, Precision::floats);
  EXPECT_EQ(floats.most, kMiss);
  EXPECT_GT(floats.open, 0U);
}

TEST(SideJudge, SaysWhatTheReferenceSays) {
  const FloatMesh knot = torus_knot(40, 8);
  const SideJudge judge(knot);
  const Body body(widened(knot));
  int inside = 0;
  test::for_each_case("bench/side-judge", 200, [&](Rng& rng) {
    const Vec3 point{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5)};
    const Side side = reference::contains_by_brute_force(body, point);
    EXPECT_EQ(judge.side(point), side == Side::inside ? 1 : 0);
    inside += side == Side::inside ? 1 : 0;
  });
  EXPECT_GT(inside, 10);
}

TEST(SideJudge, KnowsPointsOfTheSurfaceExactly) {
  const SideJudge judge(cube());
  for (const Vec3& point : {Vec3{1, 0.25, 0.5}, {1, 1, 0.25}, {-1, -1, -1}}) {
    EXPECT_EQ(judge.side(point), kOnSurface);
  }
  EXPECT_EQ(judge.side({std::nextafter(1, 2), 0.25, 0.5}), SideJudge::kOpen);
  EXPECT_EQ(judge.side({0.999, 0.25, 0.5}), 1);
  EXPECT_EQ(judge.side({1.001, 0.25, 0.5}), 0);
}

TEST(JudgeOfPoints, MeasuresWhatTheReferenceMeasures) {
  const FloatMesh knot = torus_knot(30, 6);
  const Body body(widened(knot));
  std::vector<Vec3> points;
  Answers right;
  test::for_each_case("bench/judge-of-points", 50, [&](Rng& rng) {
    points.push_back({rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)});
    right.values.push_back(reference::closest_by_brute_force(body, points.back()).distance.lower);
  });
  Answers wrong = right;
  wrong.values[7] += 1e-6;
  Answers rounded = wrong;
  rounded.precision = Precision::floats;
  const Questions questions{.job = Job::closest, .points = points};
  const auto found = judge(DistanceJudge(point_mesh(), knot), questions,
                           std::vector<Answers>{right, wrong, rounded}, 1e6);
  EXPECT_EQ(found[0].checked, points.size());
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[1].wrong_questions, std::vector<std::size_t>{7});
  EXPECT_EQ(found[2].wrong, 0U);
}

TEST(JudgeOfSides, LooksAtEveryContradiction) {
  const std::vector<Vec3> points(30, Vec3{0.5, 0.25, 0.125});
  std::vector<Answers> answers(2, Answers{std::vector<double>(30, 1)});
  answers[1].values[13] = 0;
  answers[1].values[20] = kOnSurface;
  const auto found = judge(SideJudge(cube()), {.job = Job::contains, .points = points}, answers, 1);
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[0].checked, 3U);
  EXPECT_EQ(found[1].wrong_questions, (std::vector<std::size_t>{13, 20}));
}

TEST(JudgeOfRays, TakesMissesThatAgreeForNoContradiction) {
  std::vector<ProbeRay> rays(20, {{-5, 0.25, 0.5}, {1, 0, 0}});
  rays[3].direction = {-1, 0, 0};
  Answers right{std::vector<double>(20, 4)};
  right.values[3] = kMiss;
  Answers wrong = right;
  wrong.precision = Precision::floats;
  wrong.values[9] = kMiss;
  wrong.values[11] = 4 + 1e-7;  // rounded, which is none either
  wrong.values[12] = 5;
  const auto found = judge(RayJudge(cube()), {.job = Job::closest_hit, .rays = rays},
                           std::vector<Answers>{right, wrong}, 1);
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[0].checked, 3U);
  EXPECT_EQ(found[1].wrong_questions, (std::vector<std::size_t>{9, 12}));
}

TEST(JudgeOfRays, DecidesWhetherThereIsAnyHit) {
  const std::vector<ProbeRay> rays{
      {{-5, 0.25, 0.5}, {1, 0, 0}}, {{-5, 1.25, 0.5}, {1, 0, 0}}, {{-5, 1, 0.25}, {1, 0, 0}}};
  const auto found = judge(RayJudge(cube()), {.job = Job::any_hit, .rays = rays},
                           std::vector<Answers>{{{1, 0, 1}}, {{0, 1, 0}}}, 1e6);
  EXPECT_EQ(found[0].wrong, 0U);
  EXPECT_EQ(found[1].wrong_questions, (std::vector<std::size_t>{0, 1}));
}

TEST(Probes, AreFloatsAndTheirCameraSeesTheBody) {
  const Scene scene = knot_probes(1'000, 1);
  const RayJudge rays(scene.fixed);
  for (const ProbeSet& set : scene.probe_sets) {
    EXPECT_EQ(set.points.size() + set.rays.size(), 20'000U) << set.name;
    for (const Vec3& p : set.points) {
      EXPECT_EQ(p, wide(narrow(p)));
    }
    std::size_t hits = 0;
    for (std::size_t i = 0; i < set.rays.size(); i += 20) {
      EXPECT_EQ(set.rays[i].direction, wide(narrow(set.rays[i].direction)));
      hits += rays.crossings(set.rays[i], Precision::exact).sure != 0 ? 1U : 0U;
    }
    EXPECT_GE(hits, set.rays.size() / 200) << set.name;
  }
}

}  // namespace
}  // namespace soms::bench
