// What a scene says of the cost of collision: that of the traversal that was chosen.
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"

#include "apps/view/control/action.h"
#include "apps/view/control/session.h"
#include "apps/view/scene/load.h"
#include "apps/view/window/scene_subject.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <chrono>

namespace soms::view {
namespace {

/// A block of 20 x 20 x 10 on the ground and a cube of side 2 beside it.
SceneContent wall_and_die() {
  return two_bodies(
      Body(Shape(soms::test::box_body({-10, -10, 0}, {10, 10, 10}, 8))),
      Body(Shape(soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 2)), Pose::translation(20, 0, 5)));
}

/// The wall and the die in it, by the library.
thesis::CountedOverlap by_library(const TreeChoice& trees) {
  const ShapeOptions options{.build = trees.build, .keep_tree = true};
  const SceneContent content = wall_and_die();
  const Body wall(Shape(content.city[0].shape.shared_mesh(), options));
  const Body die(Shape(content.movers[0].body.shape.shared_mesh(), options),
                 Pose::translation(10, 0.1, 5));
  return thesis::overlap(wall, die, trees.traversal);
}

TEST(SubjectCosts, NumbersAreThoseOfTheTraversalChosen) {
  SceneSubject subject(wall_and_die());
  subject.place_object(Pose::translation(10, 0.1, 5));
  ViewState state;
  subject.choose(state);
  const Facts fast = subject.facts(state);
  EXPECT_EQ(fast.cost, by_library(trees_of(state)).answer.cost);
  EXPECT_FALSE(fast.entered);
  for (const TraversalEntry& row : traversals().subspan(1)) {  // all but `fast`
    SCOPED_TRACE(row.name);
    state.traversal = row.traversal;
    subject.choose(state);
    const Facts facts = subject.facts(state);
    const auto [answer, counts] = by_library(trees_of(state));
    EXPECT_EQ(facts.cost, answer.cost);
    EXPECT_NE(facts.cost, fast.cost);
    EXPECT_EQ(facts.entered, counts.entered);
    EXPECT_EQ(facts.contacts, answer.pairs.size());
    EXPECT_FALSE(facts.cost_cut);
  }
  state.traversal = Traversal::fast;
  subject.choose(state);
  EXPECT_EQ(subject.facts(state).cost, fast.cost);
}

TEST(SubjectCosts, NumbersSayThatTimeRanOut) {
  SceneSubject subject(wall_and_die());
  subject.set_step_patience(std::chrono::seconds(0));
  subject.place_object(Pose::translation(10, 0, 5));
  ViewState state;
  state.traversal = Traversal::larger;
  subject.choose(state);
  EXPECT_TRUE(subject.facts(state).cost_cut);
  EXPECT_GT(subject.facts(state).contacts, 0U);  // the answer is the scene's
}

TEST(SubjectCosts, TreesAndTraversalOfTheThesisCanBeChosen) {
  SceneSubject subject(wall_and_die());
  subject.place_object(Pose::translation(10, 0.1, 5));
  ViewState state;
  begin_with(state, thesis_options(Rule::soms), {.traversal = Traversal::e_node});
  EXPECT_EQ(trees_of(state).build, thesis_options(Rule::soms));
  EXPECT_EQ(trees_of(state).traversal, (TraversalOptions{.traversal = Traversal::e_node}));
  subject.choose(state);
  const auto [answer, counts] = by_library(trees_of(state));
  EXPECT_EQ(subject.facts(state).cost, answer.cost);
  EXPECT_EQ(subject.facts(state).entered, counts.entered);
  state.rule = Rule::fast;  // uses neither midpoints nor empty sides
  subject.choose(state);
  EXPECT_EQ(trees_of(state).build, thesis_options(Rule::fast));
  state.descent = Descent::cross;  // which the front cannot go up
  state.traversal = Traversal::e_node_front;
  EXPECT_NO_THROW(subject.choose(state));
}

TEST(SubjectCosts, WhoShowsBoxesOfATraversalGetsOneThatHasSome) {
  SceneSubject subject(wall_and_die());
  Session session(subject, {640, 480});
  const auto tick = [&] {
    session.handle({});
    session.tick(0.01);
    return session.state().traversal;
  };
  EXPECT_EQ(tick(), Traversal::fast);
  apply(session.state(), Action::visited);
  EXPECT_EQ(tick(), Traversal::e_node);
  EXPECT_FALSE(session.picture().box_groups.empty());
  session.state().traversal = Traversal::fast;
  EXPECT_EQ(tick(), Traversal::fast);  // chosen while boxes are shown, it stays
  session.state().shown.visited = false;
  session.state().traversal = Traversal::b_first;
  (void)tick();
  apply(session.state(), Action::found);
  EXPECT_EQ(tick(), Traversal::b_first);
}

}  // namespace
}  // namespace soms::view
