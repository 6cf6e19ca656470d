#include "apps/view/scene/frame_gaps.h"

#include "soms/query/distance.h"
#include "soms/scene/recording.h"

#include "apps/view/scene/draw_scene.h"
#include "apps/view/scene/load.h"
#include "apps/view/scene/view_scene.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

constexpr double kNear = 1.25;

/// Two blocks that drive at a wall and through it, one behind the other, recorded with a clearance.
struct NearWall {
  command::World world;
  std::string bytes;

  explicit NearWall(std::uint64_t frames, double clearance = kNear) {
    world.city.emplace_back(test::box_body({3, -5, 0}, {4, 5, 5}));
    command::Model model;
    model.shape = Shape(test::box_body({0, 0, 0}, {1, 1, 1}));
    model.name = "block";
    world.models.push_back(std::move(model));
    world.routes.resize(2);
    RecordingHead head;
    head.clearance = clearance;
    head.environment.emplace_back();
    head.environment[0].mesh.triangles = world.city[0].shape.mesh().triangles.size();
    head.models.emplace_back();
    head.models[0].triangles = world.models[0].shape.mesh().triangles.size();
    head.movers = {0, 0};
    std::ostringstream out;
    RecordingWriter writer(out, head);
    Scene scene;
    scene.add_environment(world.city[0]);
    scene.add_mover(Body(world.models[0].shape));
    scene.add_mover(Body(world.models[0].shape));
    for (std::uint64_t k = 0; k < frames; ++k) {
      const double x = 0.25 * static_cast<double>(k);
      const std::vector<Pose> poses{Pose::translation(x, 0, 1), Pose::translation(x - 2, 0, 1)};
      scene.set_pose(0, poses[0]);
      scene.set_pose(1, poses[1]);
      writer.add(poses, scene.step({.clearance = clearance}));
    }
    writer.finish(RecordingEnding::complete);
    bytes = out.str();
  }

  [[nodiscard]] ViewScene open() const {
    return ViewScene(
        content_of(world, Replay(std::make_unique<std::istringstream>(bytes), "near")));
  }
};

Gap found(BodyRef a, BodyRef b, Bracket distance, TrianglePair triangles, Vec3 point_a,
          Vec3 point_b) {
  return {
      a, b,
      Distance{
          .distance = distance, .triangles = triangles, .point_a = point_a, .point_b = point_b}};
}

/// The gap of two bodies as `distance` has it; nothing where they touch or are farther.
std::vector<Gap> gap_between(const ViewScene& scene, BodyRef a, BodyRef b) {
  const Distance answer = distance(scene.body(a), scene.body(b));
  if (answer.distance.upper == 0 || answer.distance.upper > kNear) {
    return {};
  }
  return {found(a, b, answer.distance, *answer.triangles, answer.point_a, answer.point_b)};
}

TEST(FrameGaps, AreThoseOfAStepTheNearestFirst) {
  StepReport report;
  report.environment_gaps = {{0, 1, 2, 3, {0.5, 0.5}, {1, 0, 0}, {2, 0, 0}},
                             {1, 0, 4, 5, {0.25, 0.25}, {0, 1, 0}, {0, 2, 0}}};
  report.mover_gaps = {{0, 1, 6, 7, {0.5, 0.75}, {0, 0, 1}, {0, 0, 2}}};
  EXPECT_EQ(gaps_of(report),
            (std::vector{
                found(mover(1), city_part(0), {0.25, 0.25}, {4, 5}, {0, 1, 0}, {0, 2, 0}),
                found(mover(0), city_part(1), {0.5, 0.5}, {2, 3}, {1, 0, 0}, {2, 0, 0}),
                found(mover(0), mover(1), {0.5, 0.75}, {6, 7}, {0, 0, 1}, {0, 0, 2}),
            }));
  EXPECT_TRUE(gaps_of({}).empty());
}

TEST(FrameGaps, AreWrittenWithFourDigitsAndTheUnit) {
  EXPECT_EQ(meters_in_text(found({}, {}, {0.123456, 0.123457}, {}, {}, {})), "0.1235 m");
  EXPECT_EQ(meters_in_text(found({}, {}, {2, 2}, {}, {}, {})), "2 m");
}

TEST(FrameGaps, OfAReplayAreThoseOfItsFrame) {
  const NearWall recorded(24);
  ViewScene scene = recorded.open();
  std::size_t gaps = 0;
  std::size_t none = 0;
  for (std::uint64_t k = 0; k < 24; ++k) {
    ASSERT_TRUE(scene.replaying());
    std::vector<Gap> expected = gap_between(scene, mover(0), city_part(0));
    for (const auto& [a, b] : {std::pair(mover(1), city_part(0)), std::pair(mover(0), mover(1))}) {
      const std::vector<Gap> more = gap_between(scene, a, b);
      expected.insert(expected.end(), more.begin(), more.end());
    }
    std::stable_sort(expected.begin(), expected.end(), [](const Gap& x, const Gap& y) {
      return x.distance.distance.upper < y.distance.distance.upper;
    });
    ASSERT_EQ(scene.frame_gaps().size(), expected.size()) << k;
    for (const Gap& gap : expected) {
      EXPECT_NE(std::find(scene.frame_gaps().begin(), scene.frame_gaps().end(), gap),
                scene.frame_gaps().end());
    }
    const SceneStatistics facts = scene.statistics();
    EXPECT_EQ(facts.clearance, kNear);
    EXPECT_EQ(facts.gaps, expected.size());
    ASSERT_TRUE(facts.least_gap);  // the blocks are always near each other
    EXPECT_EQ(facts.least_gap->distance.distance, expected.front().distance.distance);
    gaps += expected.size();
    none += gap_between(scene, mover(0), city_part(0)).empty() ? 1U : 0U;
    scene.step();
  }
  EXPECT_GT(gaps, 24U);
  EXPECT_GT(none, 0U);
}

TEST(FrameGaps, AreSoughtAgainWhereTheHandMovesARecordedMover) {
  const NearWall recorded(24);
  ViewScene scene = recorded.open();
  ASSERT_EQ(scene.frame_gaps().size(), 1U);
  scene.set_pose(0, Pose::translation(1.5, 0, 1));
  EXPECT_FALSE(scene.replaying());
  EXPECT_EQ(scene.frame_gaps(), gap_between(scene, mover(0), city_part(0)));
  EXPECT_EQ(scene.frame_gaps().front().distance.distance, (Bracket{0.5, 0.5}));
}

TEST(FrameGaps, AreNoneWithoutAClearance) {
  const NearWall recorded(6, 0);
  ViewScene scene = recorded.open();
  EXPECT_TRUE(scene.frame_gaps().empty());
  EXPECT_EQ(scene.statistics().clearance, 0);
  EXPECT_FALSE(scene.statistics().least_gap);
  ViewOptions frame_alone;
  frame_alone.gap = false;
  EXPECT_TRUE(make_draw_list(scene, frame_alone).labels.empty());
}

TEST(FrameGaps, AreDrawnFromPointToPointWithTheirLengths) {
  const NearWall recorded(24);
  ViewScene scene = recorded.open();
  scene.go_to(6);
  ASSERT_EQ(scene.frame_gaps().size(), 2U);
  const DrawnScene drawn = draw_scene(scene, {});
  EXPECT_EQ(drawn.counts.gaps, 2U);
  EXPECT_EQ(drawn.counts.gaps_drawn, 2U);
  ASSERT_EQ(drawn.list.labels.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Gap& gap = scene.frame_gaps()[k];
    EXPECT_EQ(drawn.list.labels[k].text, meters_in_text(gap));
    EXPECT_TRUE(std::any_of(drawn.list.lines.begin(), drawn.list.lines.end(), [&](const Line& l) {
      return l.a == gap.distance.point_a && l.b == gap.distance.point_b;
    }));
  }
  ViewOptions without;
  without.gap = false;
  without.frame_gaps.shown = false;
  EXPECT_TRUE(make_draw_list(scene, without).labels.empty());
}

// The gap of the pair is drawn on its own, without a unit, only where it is none of the frame's.
TEST(FrameGaps, AreDrawnOnceWhereThePairHasOne) {
  const NearWall recorded(24);
  ViewScene scene = recorded.open();
  scene.go_to(6);
  ASSERT_TRUE(scene.gap());
  const auto labels = [&] { return make_draw_list(scene, {}).labels; };
  EXPECT_EQ(labels().size(), 2U);
  scene.go_to(0);  // the wall is farther than the clearance
  ASSERT_EQ(scene.frame_gaps().size(), 1U);
  ASSERT_EQ(labels().size(), 2U);
  EXPECT_EQ(labels()[1].text, "2");
}

TEST(FrameGaps, ThatFindNoRoomAreTheFarthestAndCounted) {
  const NearWall recorded(24);
  ViewScene scene = recorded.open();
  scene.go_to(6);
  ASSERT_EQ(scene.frame_gaps().size(), 2U);
  ViewOptions one;
  one.frame_gaps.most = 1;
  const DrawnScene drawn = draw_scene(scene, one);
  ASSERT_EQ(drawn.list.labels.size(), 1U);
  EXPECT_EQ(drawn.list.labels[0].text, meters_in_text(scene.frame_gaps()[0]));
  EXPECT_EQ(left_out(drawn.counts), std::vector<std::string>{"1 of 2 gaps"});
}

}  // namespace
}  // namespace soms::view
