// Contacts over time and traversals test by test, as the controls see them.
#include "apps/view/control/panel_text.h"
#include "apps/view/drawing/length.h"
#include "apps/view/scene/load.h"
#include "apps/view/window/scene_subject.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace soms::view {
namespace {

/// A block, a cube that stands beside it, and a car that drives through its side in frames 3 to 6.
SceneContent block_cube_and_car() {
  SceneContent content = two_bodies(
      Body(soms::test::box_body({-10, -10, 0}, {10, 10, 10}, 8)),
      Body(soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 2), Pose::translation(20, 0, 5)));
  content.city[0].name = "block";
  content.movers[0].body.name = "cube";
  content.movers.push_back(
      {Body(soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 2)), [](std::uint64_t frame) {
         return Pose::translation(0.3, frame >= 3 && frame <= 6 ? -10 : -20, 2.1);
       }});
  content.movers[1].body.name = "car";
  content.frames = 20;
  return content;
}

TEST(SubjectEvents, AreFoundOnRequestAndGoneTo) {
  SceneSubject subject(block_cube_and_car());
  EXPECT_EQ(subject.events().frames, 20U);
  EXPECT_EQ(subject.events().searched, 0U);
  while (!subject.events().done()) {
    subject.search_events();
  }
  ASSERT_EQ(subject.events().rows.size(), 1U);
  const ContactEvent& row = subject.events().rows[0];
  EXPECT_EQ(row.title, "car (mover 1) touches block");
  EXPECT_EQ(row.begin, 3U);
  EXPECT_EQ(row.end, 6U);

  subject.place_object(Pose::translation(9, 0, 5));  // the cube, by hand, into the block
  const FitCamera fit = [](const Box& box, const Vec3& toward) {
    return fitted(box, toward, {1280, 720});
  };
  EXPECT_FALSE(subject.draw_list({}).focus);
  const Sight sight = subject.show_event(0, fit);
  const Facts facts = subject.facts({});
  EXPECT_EQ(facts.frame, row.most_frame);
  EXPECT_EQ(facts.contacts, row.most_pairs);  // the cube is back
  EXPECT_EQ(facts.bodies, 1U);
  EXPECT_NE(sight.facts.title.find("of car (mover 1)"), std::string::npos) << sight.facts.title;
  EXPECT_TRUE(project(sight.camera, {1280, 720}, sight.facts.point));
  EXPECT_LT(sight.camera.eye.y, -10);                         // from outside the block
  EXPECT_EQ(facts.object, Pose::translation(0.3, -10, 2.1));  // the car is the object
  const DrawList list = subject.draw_list({});
  ASSERT_TRUE(list.focus);  // what is around it is pale
  EXPECT_LT(length(list.focus->center - sight.facts.point), list.focus->radius);
  subject.seek(0);
  EXPECT_FALSE(subject.draw_list({}).focus);  // they do not touch any more
}

TEST(SubjectEvents, AreOfOneFrameWhereNothingMoves) {
  SceneContent content = block_cube_and_car();
  content.movers.pop_back();
  SceneSubject subject(std::move(content));
  EXPECT_EQ(subject.events().frames, 1U);
  subject.search_events();
  EXPECT_TRUE(subject.events().done());
  EXPECT_TRUE(subject.events().rows.empty());
}

TEST(SubjectLesson, IsShownTestByTest) {
  SceneSubject subject(block_cube_and_car());
  ViewState state;
  state.traversal = Traversal::e_node;
  subject.choose(state);
  EXPECT_FALSE(subject.facts(state).learn);
  const std::size_t boxes = subject.draw_list(state).box_groups.size();
  subject.place_object(Pose::translation(10, 0.3, 5));
  state.learn = true;
  subject.choose(state);
  const Facts first = subject.facts(state);
  ASSERT_TRUE(first.learn);
  ASSERT_GT(first.learn->tests, 10U);
  EXPECT_EQ(first.learn->sentences.size(), 2U);
  EXPECT_EQ(first.learn->a.name, "block");
  EXPECT_EQ(first.learn->b.name, "cube");
  EXPECT_EQ(subject.draw_list(state).box_groups.size(), boxes + 4);  // faces and edges of two

  state.learn_step = 1'000'000;
  subject.choose(state);
  const Facts last = subject.facts(state);
  EXPECT_EQ(last.learn->test, last.learn->tests - 1);
  for (const TreeBars* bars : {&last.learn->a, &last.learn->b}) {
    EXPECT_EQ(std::count_if(bars->bars.begin(), bars->bars.end(),
                            [](const auto& bar) { return bar.look == TreeBars::Look::now; }),
              1);
    for (const TreeBars::Bar& bar : bars->bars) {
      EXPECT_LT(bar.level, bars->levels);
      EXPECT_LT(bar.left, bar.right);
      EXPECT_LE(bar.right, 1.0001F);
    }
    EXPECT_EQ(bars->bars[0].right, 1);
  }

  const auto has_color = [&](Color color) {
    const DrawList list = subject.draw_list(state);
    return std::any_of(list.box_groups.begin(), list.box_groups.end(), [&](const BoxGroup& group) {
      return std::any_of(group.boxes.begin(), group.boxes.end(),
                         [&](const BoxItem& item) { return item.color == color; });
    });
  };
  for (const Traversal traversal : {Traversal::simultaneous, Traversal::fast}) {
    state.traversal = traversal;
    state.learn_step = 0;
    subject.choose(state);
    const Facts facts = subject.facts(state);
    ASSERT_TRUE(facts.learn);
    ASSERT_GT(facts.learn->tests, 3U);
    EXPECT_NE(facts.learn->a.now, facts.learn->b.now);
    EXPECT_TRUE(has_color(color_of(facts.learn->a, TreeBars::Look::now)));
    EXPECT_TRUE(has_color(color_of(facts.learn->b, TreeBars::Look::now)));
  }
}

TEST(SubjectLesson, StepsThroughTheTraversalThatAnswersQueries) {
  SceneSubject subject(block_cube_and_car());
  ViewState state;
  subject.place_object(Pose::translation(10, 0.3, 5));
  state.learn = true;
  state.traversal = Traversal::fast;
  subject.choose(state);
  const std::uint64_t steps = subject.facts(state).learn->tests;
  std::uint64_t leaves = 0;
  for (state.learn_step = 0; state.learn_step < steps; ++state.learn_step) {
    subject.choose(state);
    const Facts facts = subject.facts(state);
    EXPECT_EQ(facts.learn->test, state.learn_step);
    EXPECT_GE(facts.learn->sentences.size(), 3U);
    leaves += facts.learn->sentences[1].find("Two leaves") == 0 ? 1U : 0U;
    for (const TreeBars* bars : {&facts.learn->a, &facts.learn->b}) {
      EXPECT_EQ(bars->bars.front().left, 0);
      EXPECT_EQ(bars->bars.front().right, 1);
    }
  }
  EXPECT_GT(leaves, 0U);
  state.learn_step = steps - 1;
  subject.choose(state);
  const Facts last = subject.facts(state);
  EXPECT_EQ(last.learn->sentences.back(),
            "Touching pairs known so far: " + std::to_string(last.contacts) + ".");
}

}  // namespace
}  // namespace soms::view
