// The passages of a recording in the list of events, and what is shown of one.
#include "soms/scene/passages.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene.h"

#include "apps/view/control/panel_text.h"
#include "apps/view/scene/load.h"
#include "apps/view/window/scene_subject.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <vector>

namespace soms::view {
namespace {

/// A thin wall, and a cube that touches it in frame 2 and passes it on the way to frame 4.
SceneContent recorded_drive(bool swept) {
  SceneContent content =
      two_bodies(Body(Shape(test::box_body({5, -10, -10}, {5.01, 10, 10})), Pose(), "wall"),
                 Body(Shape(test::box_body({-1, -1, -1}, {1, 1, 1})), Pose(), "cube"));
  content.city[0].name = "wall";
  content.movers[0].body.name = "cube";
  Scene scene;
  scene.add_environment(content.city[0]);
  const MoverId cube = scene.add_mover(content.movers[0].body);
  RecordingHead head;
  head.swept = swept;
  head.environment.emplace_back();
  head.environment[0].mesh.triangles = content.city[0].shape.mesh().triangles.size();
  head.models.emplace_back();
  head.models[0].triangles = content.movers[0].body.shape.mesh().triangles.size();
  head.movers = {0};
  std::ostringstream out;
  RecordingWriter writer(out, head);
  for (const double x : {-8.0, 0.0, 4.5, 2.0, 12.0}) {
    const Pose pose = Pose::translation(x, 0, 0);
    scene.set_pose(cube, pose);
    writer.add(std::vector{pose}, scene.step({.swept = true}));
  }
  writer.finish(RecordingEnding::complete);
  content.recording =
      std::make_shared<Replay>(std::make_unique<std::istringstream>(out.str()), "recorded");
  return content;
}

void search_to_the_end(SceneSubject& subject) {
  while (!subject.events().done()) {
    subject.search_events();
  }
}

Camera fixed_camera(const Box& /*box*/, const Vec3& /*toward_eye*/) {
  return {};
}

TEST(RecordedPassages, AreAmongTheEventsInOrderOfTime) {
  SceneSubject subject(recorded_drive(true));
  search_to_the_end(subject);
  ASSERT_EQ(subject.events().rows.size(), 2U);
  EXPECT_EQ(subject.events().rows[0].title, "cube (mover 0) touches wall");
  EXPECT_EQ(subject.events().rows[0].after, 0);
  const ContactEvent& passage = subject.events().rows[1];
  EXPECT_EQ(passage.title, "cube (mover 0) passed through wall");
  EXPECT_EQ(passage.begin, 3U);
  EXPECT_NEAR(passage.after, 0.2, 1e-9);  // from 2 to 12, and in contact at 4
  EXPECT_EQ(words_of(passage),
            "cube (mover 0) passed through wall\n   frame 3 + 0.20, between two frames");
  SceneSubject plain(recorded_drive(false));
  search_to_the_end(plain);
  EXPECT_EQ(plain.events().rows.size(), 1U);
}

TEST(RecordedPassages, ShowTheMoverAtTheMoment) {
  SceneSubject subject(recorded_drive(true));
  search_to_the_end(subject);
  const Sight sight = subject.show_event(1, fixed_camera);
  EXPECT_EQ(sight.facts.title, "cube (mover 0) passed through wall");
  EXPECT_EQ(sight.facts.numbers.front().first, "moment");
  ASSERT_TRUE(subject.facts({}).object);
  EXPECT_NEAR(subject.facts({}).object->m[3], 4, 1e-9);
  EXPECT_GT(subject.facts({}).contacts, 0U);
  // Any other frame is as it was recorded.
  subject.seek(4);
  EXPECT_EQ(subject.facts({}).object->m[3], 12);
  EXPECT_EQ(subject.facts({}).contacts, 0U);
  static_cast<void>(subject.show_event(1, fixed_camera));
  subject.advance(-1);
  EXPECT_EQ(subject.facts({}).object->m[3], 2);
  static_cast<void>(subject.show_event(1, fixed_camera));
  static_cast<void>(subject.show_event(0, fixed_camera));
  EXPECT_EQ(subject.facts({}).object->m[3], 4.5);
}

}  // namespace
}  // namespace soms::view
