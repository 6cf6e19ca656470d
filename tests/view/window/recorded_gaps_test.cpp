// The gaps of a recording in the window.
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "apps/view/scene/load.h"
#include "apps/view/window/scene_subject.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <vector>

namespace soms::view {
namespace {

/// A block and a cube beside it, 9 m apart, in a recording of one frame with a clearance.
SceneContent recorded_with(double clearance) {
  SceneContent content =
      two_bodies(Body(Shape(test::box_body({-10, -10, 0}, {10, 10, 10}))),
                 Body(Shape(test::box_body({-1, -1, -1}, {1, 1, 1})), Pose::translation(20, 0, 5)));
  Scene scene;
  scene.add_environment(content.city[0]);
  scene.add_mover(content.movers[0].body);
  RecordingHead head;
  head.clearance = clearance;
  head.environment.emplace_back();
  head.environment[0].mesh.triangles = content.city[0].shape.mesh().triangles.size();
  head.models.emplace_back();
  head.models[0].triangles = content.movers[0].body.shape.mesh().triangles.size();
  head.movers = {0};
  std::ostringstream out;
  RecordingWriter writer(out, head);
  writer.add(std::vector{content.movers[0].body.pose}, scene.step({.clearance = clearance}));
  writer.finish(RecordingEnding::complete);
  content.recording =
      std::make_shared<Replay>(std::make_unique<std::istringstream>(out.str()), "recorded");
  return content;
}

TEST(RecordedGaps, AreCountedAndDrawnUnlessTheyAreHidden) {
  SceneSubject near(recorded_with(10));
  EXPECT_EQ(near.facts({}).clearance, "10 m");
  EXPECT_EQ(near.facts({}).gaps, 1U);
  EXPECT_EQ(near.facts({}).least_gap, "9 m");
  EXPECT_EQ(near.draw_list({}).labels.size(), 1U);
  ViewState hidden;
  hidden.shown.gap = false;
  EXPECT_TRUE(near.draw_list(hidden).labels.empty());
  const SceneSubject far(recorded_with(8));
  EXPECT_EQ(far.facts({}).clearance, "8 m");
  EXPECT_EQ(far.facts({}).gaps, 0U);
  EXPECT_EQ(far.facts({}).least_gap, "");
  const SceneSubject without(recorded_with(0));
  EXPECT_EQ(without.facts({}).clearance, "");
}

}  // namespace
}  // namespace soms::view
