#include "apps/view/window/scene_subject.h"

#include "soms/base/error.h"
#include "soms/io/write_mesh.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/session.h"
#include "apps/view/scene/load.h"
#include "apps/view/scene/orientation_menu.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace soms::view {
namespace {

Body named(const Mesh& mesh, const Pose& pose, std::string name) {
  Body body(Shape(mesh), pose);
  body.name = std::move(name);
  return body;
}

/// A block of 20 x 20 x 10 on the ground and a cube of side 2 beside it.
SceneContent block_and_cube() {
  return two_bodies(
      named(soms::test::box_body({-10, -10, 0}, {10, 10, 10}, 8), {}, "block"),
      named(soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 2), Pose::translation(20, 0, 5), "cube"));
}

/// As before, but a second cube drives along x and there are two more frames than it needs.
SceneContent with_traffic() {
  SceneContent content = block_and_cube();
  content.movers.push_back(
      {named(soms::test::box_body({-1, -1, -1}, {1, 1, 1}), Pose::translation(0, -20, 1), "car"),
       [](std::uint64_t frame) { return Pose::translation(static_cast<double>(frame), -20, 1); }});
  return content;
}

Ray down(double x, double y) {
  return {{x, y, 100}, {0, 0, -1}};
}

TEST(SceneSubject, TellsWhatThereIs) {
  const SceneSubject subject(block_and_cube());
  const Facts facts = subject.facts({});
  EXPECT_EQ(facts.name, "block");
  EXPECT_EQ(facts.triangles, 768U + 48U);
  EXPECT_EQ(facts.movers, 1U);
  EXPECT_EQ(facts.contacts, 0U);
  EXPECT_TRUE(facts.limits.has_object);
  EXPECT_EQ(facts.limits.object_size, 2);
  EXPECT_EQ(facts.object, Pose::translation(20, 0, 5));
  EXPECT_EQ(facts.object_bounds, (Box{{19, -1, 4}, {21, 1, 6}}));
  EXPECT_TRUE(facts.bounds.contains(facts.object_bounds));
}

TEST(SceneSubject, MovingTheObjectIntoTheBlockGivesContactsAndRedTrianglesAndHomeNone) {
  SceneSubject subject(block_and_cube());
  ViewState plain;
  plain.shown.gap = false;
  EXPECT_TRUE(subject.draw_list(plain).glows.empty());
  subject.place_object(Pose::translation(10, 0, 5));
  EXPECT_GT(subject.facts({}).contacts, 0U);
  EXPECT_EQ(subject.facts({}).bodies, 1U);
  EXPECT_FALSE(subject.draw_list({}).glows.empty());
  ViewState without;
  without.shown.contact_triangles = false;
  EXPECT_TRUE(subject.draw_list(without).glows.empty());
  subject.object_home();
  EXPECT_EQ(subject.facts({}).contacts, 0U);
  EXPECT_EQ(subject.facts({}).object, Pose::translation(20, 0, 5));
}

TEST(SceneSubject, ASessionDragsTheObjectIntoTheBlock) {
  SceneSubject subject(block_and_cube());
  Session session(subject, {1280, 720});
  session.state().paused = true;
  const auto pixel = [&](const Vec3& p) {
    return project(session.camera(), {1280, 720}, p)->pixel;
  };
  const Gizmo gizmo = *session.gizmo();
  const Vec3 grip = gizmo.center + Vec3{0.7 * gizmo.size, 0, 0};
  session.push(MouseMove{pixel(grip)});
  session.push(MouseDown{MouseButton::left, pixel(grip)});
  session.push(MouseMove{pixel(grip - Vec3{10, 0, 0})});
  session.handle({});
  session.tick(0.01);
  EXPECT_NEAR(session.facts().object->shift().x, 10, 1e-6);
  EXPECT_GT(session.facts().contacts, 0U);
  EXPECT_FALSE(session.picture().glows.empty());
}

TEST(SceneSubject, LevelsAreThoseOfTheTreeOnceItIsShown) {
  SceneSubject subject(block_and_cube());
  ViewState state;
  state.shown.tree_boxes = true;
  for (const TreeOf tree : {TreeOf::city, TreeOf::mover}) {
    state.tree_of = tree;
    state.level = 1;
    const DrawList root = subject.draw_list(state);
    ASSERT_EQ(root.box_groups.size(), 1U);
    EXPECT_EQ(root.box_groups[0].boxes.size(), 1U);
    state.level = 3;
    EXPECT_EQ(subject.draw_list(state).box_groups[0].boxes.size(), 4U);
  }
  const ViewLimits limits = subject.facts(state).limits;
  EXPECT_GE(limits.city_levels, 7);
  EXPECT_LT(limits.city_levels, 20);
  EXPECT_GE(limits.mover_levels, 3);
  EXPECT_LT(limits.mover_levels, limits.city_levels);
}

TEST(SceneSubject, TreeOfTheCityIsShownWithoutMoversToo) {
  SceneContent content;
  content.title = "block";
  content.city.push_back(named(soms::test::box_body({-1, -1, 0}, {1, 1, 1}, 4), {}, "block"));
  SceneSubject subject(std::move(content));
  ViewState state;
  state.shown.tree_boxes = true;
  EXPECT_EQ(subject.draw_list(state).box_groups.size(), 1U);
  EXPECT_GT(subject.facts(state).limits.city_levels, 3);
  EXPECT_LT(subject.facts(state).limits.city_levels, 15);
  EXPECT_FALSE(subject.facts(state).limits.has_object);
  EXPECT_FALSE(subject.facts(state).object);
}

TEST(SceneSubject, EachRuleAndTraversalCanBeShown) {
  SceneSubject subject(block_and_cube());
  subject.place_object(Pose::translation(10, 0, 5));
  const std::uint64_t contacts = subject.facts({}).contacts;
  ViewState state;
  state.traversal = Traversal::e_node;
  state.shown.visited = state.shown.pruned = state.shown.found = true;
  for (const RuleEntry& row : rules()) {
    state.rule = row.rule;
    subject.choose(state);
    EXPECT_FALSE(subject.draw_list(state).box_groups.empty()) << row.name;
  }
  for (const TraversalEntry& row : traversals().subspan(1)) {  // all but `fast`
    state.traversal = row.traversal;
    subject.choose(state);
    EXPECT_FALSE(subject.draw_list(state).box_groups.empty()) << row.name;
    EXPECT_TRUE(subject.facts(state).traversed);
    EXPECT_EQ(subject.facts(state).contacts, contacts);
  }
}

TEST(SceneSubject, AChoiceThatCannotBeIsTakenBackAndThePictureGoesOn) {
  SceneSubject subject(block_and_cube());
  Session session(subject, {640, 480});
  const auto tick = [&] {
    session.handle({});
    session.tick(0.01);
    return session.picture().glows.size();
  };
  session.state().paused = true;
  session.state().shown.gizmo = false;  // which has marks, too
  session.state().shown.gap = false;
  session.state().traversal = Traversal::e_node_front;
  EXPECT_EQ(tick(), 0U);
  EXPECT_EQ(session.message(), "");
  session.state().prune = false;  // of which the traversal knows nothing
  (void)tick();
  EXPECT_NE(session.message().find("e_node_front"), std::string::npos);
  EXPECT_TRUE(session.state().prune);
  EXPECT_EQ(session.state().traversal, Traversal::e_node_front);
  subject.place_object(Pose::translation(10, 0, 5));
  session.state().shown.edges = true;
  EXPECT_GT(tick(), 0U);

  session.state().traversal = Traversal::larger;
  session.state().prune = false;
  (void)tick();
  session.state().traversal = Traversal::e_node_front;
  (void)tick();
  EXPECT_EQ(session.state().traversal, Traversal::larger);
  EXPECT_FALSE(session.state().prune);
}

TEST(SceneSubject, WithoutPruningMoreBoxesAreEntered) {
  SceneSubject subject(block_and_cube());
  subject.place_object(Pose::translation(10, 0, 5));
  ViewState state;
  state.traversal = Traversal::e_node;
  state.shown.visited = true;
  subject.choose(state);
  (void)subject.draw_list(state);
  const std::uint64_t pruned = subject.facts(state).visited;
  state.prune = false;
  subject.choose(state);
  (void)subject.draw_list(state);
  EXPECT_GT(subject.facts(state).visited, pruned);
}

TEST(SceneSubject, PrunedAreTheBoxTestsThatEndedABranch) {
  SceneSubject subject(block_and_cube());
  ViewState state;
  state.shown.pruned = true;
  state.traversal = Traversal::larger;
  subject.choose(state);
  (void)subject.draw_list(state);  // apart at the roots
  EXPECT_EQ(subject.facts(state).pruned, 1U);
  subject.place_object(Pose::translation(10, 0, 5));
  (void)subject.draw_list(state);
  EXPECT_GT(subject.facts(state).pruned, 1U);
  EXPECT_FALSE(subject.facts(state).trace_cut);
}

TEST(SceneSubject, CountsOfATraceGoWithItsBoxes) {
  SceneSubject subject(block_and_cube());
  ViewState state;
  state.traversal = Traversal::e_node;
  state.shown.visited = true;
  subject.choose(state);
  (void)subject.draw_list(state);
  EXPECT_TRUE(subject.facts(state).traversed);
  state.shown.visited = false;
  subject.choose(state);
  subject.place_object(Pose::translation(10, 0, 5));  // of which nothing is traversed
  (void)subject.draw_list(state);
  EXPECT_FALSE(subject.facts(state).traversed);
}

TEST(SceneSubject, SaysThatATraceWasCut) {
  const Mesh cube = soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 40);
  SceneSubject subject(
      two_bodies(named(cube, {}, "still"), named(cube, Pose::translation(20, 0, 5), "moving")));
  ViewState state;
  state.shown.visited = true;
  state.traversal = Traversal::larger;
  state.prune = false;
  subject.choose(state);
  (void)subject.draw_list(state);
  EXPECT_TRUE(subject.facts(state).trace_cut);
}

TEST(SceneSubject, SaysHowManyContactsAPictureHolds) {
  const Mesh cube = soms::test::box_body({-1, -1, -1}, {1, 1, 1}, 12);
  SceneSubject subject(two_bodies(named(cube, {}, "still"), named(cube, {}, "moving")));
  ViewState state;
  (void)subject.draw_list(state);
  ASSERT_GT(subject.facts(state).contacts, 5000U);
  ASSERT_EQ(subject.facts(state).left_out.size(), 1U);
  EXPECT_EQ(subject.facts(state).left_out[0].rfind("2,000 of ", 0), 0U);
  subject.place_object(Pose::translation(20, 0, 5));
  (void)subject.draw_list(state);
  EXPECT_TRUE(subject.facts(state).left_out.empty());
}

TEST(SceneSubject, HomeIsWhereTheObjectWasBeforeATestOfOrientation) {
  SceneSubject subject(with_traffic());
  ViewState state;
  state.orientation_test = 0;
  subject.choose(state);
  subject.advance(20);
  state.orientation_test.reset();
  subject.choose(state);
  EXPECT_NE(subject.facts(state).object, Pose::translation(20, 0, 5));
  subject.object_home();
  EXPECT_EQ(subject.facts(state).object, Pose::translation(20, 0, 5));

  ASSERT_TRUE(subject.pick(down(20.2, -20.3)));
  subject.select();
  state.orientation_test = 0;
  subject.choose(state);
  subject.object_home();  // the test still ran
  EXPECT_FALSE(subject.facts(state).orientation_test);
  subject.seek(7);
  EXPECT_EQ(subject.facts(state).object, Pose::translation(7, -20, 1));
}

TEST(SceneSubject, TestsOfOrientationRunRoundAndEndByHand) {
  SceneSubject subject(block_and_cube());
  ViewState state;
  for (std::size_t row = 0; row < orientation_tests().size(); ++row) {
    state.orientation_test = row;
    subject.choose(state);
    const Facts begin = subject.facts(state);
    EXPECT_EQ(begin.orientation_test, row);
    EXPECT_EQ(begin.frame, 0U);
    ASSERT_GT(begin.limits.frames, 40U);
    if (orientation_tests()[row].name != "drive") {  // which begins where a cube touches already
      EXPECT_EQ(begin.contacts, 0U) << orientation_tests()[row].name;
    }
    subject.seek(begin.limits.frames * 97 / 100);
    const Facts late = subject.facts(state);
    EXPECT_NE(late.object, begin.object);
    subject.seek(begin.limits.frames - 1);
    subject.advance(1);
    EXPECT_EQ(subject.facts(state).frame, 0U);
    subject.advance(-1);
    EXPECT_EQ(subject.facts(state).frame, 0U);
  }
  subject.place_object(Pose::translation(0, 0, 50));
  EXPECT_FALSE(subject.facts(state).orientation_test);
  EXPECT_EQ(subject.facts(state).limits.frames, 0U);
}

TEST(SceneSubject, TimeGoesOnAndBackAndRound) {
  SceneSubject endless(with_traffic());
  ViewState state;
  state.followed = 1;
  endless.advance(7);
  EXPECT_EQ(endless.facts(state).frame, 7U);
  EXPECT_EQ(endless.facts(state).followed->shift().x, 7);
  endless.advance(-3);
  EXPECT_EQ(endless.facts(state).frame, 4U);
  endless.restart();
  EXPECT_EQ(endless.facts(state).frame, 0U);
}

TEST(SceneSubject, PicksWithNumbersAndReasons) {
  SceneSubject subject(block_and_cube());
  EXPECT_FALSE(subject.pick(down(500, 500)));
  const auto top = subject.pick(down(-4.9, -4.6));
  ASSERT_TRUE(top);
  EXPECT_NE(top->title.find("of block"), std::string::npos);
  EXPECT_NEAR(top->point.z, 10, 1e-9);
  EXPECT_EQ(top->why, std::vector<std::string>{"It touches nothing."});
  EXPECT_EQ(top->numbers.back(), (std::pair<std::string, std::string>{"touches", "0"}));

  subject.place_object(Pose::translation(0, 0, 10.5));
  const auto side = subject.pick({{0.3, -50, 10.2}, {0, 1, 0}});
  ASSERT_TRUE(side);
  EXPECT_NE(side->title.find("cube (mover 0)"), std::string::npos);
  ASSERT_FALSE(side->why.empty());
  EXPECT_NE(side->why[0].find("of block: "), std::string::npos);
}

TEST(SceneSubject, HiddenMoversAreNotPicked) {
  SceneSubject subject(block_and_cube());
  ViewState state;
  EXPECT_TRUE(subject.pick(down(20.2, 0.3)));
  state.shown.movers = false;
  subject.choose(state);
  EXPECT_FALSE(subject.pick(down(20.2, 0.3)));
  EXPECT_TRUE(subject.pick(down(-4.9, -4.6)));
}

TEST(SceneSubject, PicksContactsThroughEverythingWhereTheyAreSeenSo) {
  SceneSubject subject(block_and_cube());
  subject.place_object(Pose::translation(0, 0, 0.3));  // through the floor, inside the block
  ViewState state;
  ASSERT_GT(subject.facts(state).contacts, 0U);
  const Ray at_contact{{1, 0.3, 100}, {0, 0, -1}};
  EXPECT_EQ(subject.pick(at_contact)->title.rfind("contact", 0), std::string::npos);
  state.shown.contacts_on_top = true;
  subject.choose(state);
  const auto contact = subject.pick(at_contact);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->title.rfind("contact of triangle", 0), 0U) << contact->title;
  EXPECT_NEAR(contact->point.z, 0, 1);
  ASSERT_EQ(contact->why.size(), 1U);
  subject.select();
  EXPECT_FALSE(subject.draw_list(state).lines.empty());
}

TEST(SceneSubject, AContactInAPointIsAsLargeAsItsTriangle) {
  Mesh ground;
  ground.vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  ground.triangles = {{0, 1, 2}};
  Mesh spike;
  spike.vertices = {{0, 0, 0}, {0.001, 0, 0.003}, {-0.001, 0, 0.003}};
  spike.triangles = {{0, 1, 2}};
  SceneSubject subject(two_bodies(named(ground, {}, "ground"), named(spike, {}, "spike")));
  ViewState state;
  state.shown.contacts_on_top = true;
  subject.choose(state);
  ASSERT_EQ(subject.facts(state).contacts, 1U);
  const auto contact = subject.pick({{0, -1, 1}, {0, std::sqrt(0.5), -std::sqrt(0.5)}});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->title.rfind("contact of triangle", 0), 0U) << contact->title;
  EXPECT_LT(std::abs(contact->point.x) + std::abs(contact->point.y) + std::abs(contact->point.z),
            1e-9);
  EXPECT_EQ(contact->bounds, (Box{{-0.001, 0, 0}, {0.001, 0, 0.003}}));
}

TEST(SceneSubject, AChosenContactThatIsNoMoreIsNotDrawn) {
  SceneSubject subject(block_and_cube());
  subject.place_object(Pose::translation(0, 0, 10.5));
  ASSERT_TRUE(subject.pick({{0.3, -50, 10.2}, {0, 1, 0}}));
  subject.select();
  (void)subject.draw_list({});
  subject.place_object(Pose::translation(0, 0, 40));
  EXPECT_NO_THROW((void)subject.draw_list({}));
  ViewState plain;
  plain.shown.gap = false;
  EXPECT_TRUE(subject.draw_list(plain).glows.empty());
}

TEST(SceneSubject, TheGapFollowsTheObjectAndIsSaidInNumbers) {
  SceneSubject subject(block_and_cube());
  for (const auto& [x, length] :
       {std::pair(20.0, "9"), std::pair(14.5, "3.5"), std::pair(11.25, "0.25")}) {
    subject.place_object(Pose::translation(x, 0, 5));
    const auto gap = subject.facts({}).gap;
    ASSERT_TRUE(gap.has_value()) << x;
    EXPECT_EQ(gap->length, length);
    ASSERT_EQ(gap->numbers.size(), 3U);
    EXPECT_EQ(gap->numbers[0].second, length);
    EXPECT_NE(gap->numbers[1].second.find(" of block"), std::string::npos);
    EXPECT_NE(gap->numbers[2].second.find(" of cube"), std::string::npos);
    const DrawList list = subject.draw_list({});
    ASSERT_EQ(list.labels.size(), 1U);
    EXPECT_EQ(list.labels[0].text, gap->length);
    EXPECT_EQ(list.labels[0].a.x, 10);
    EXPECT_EQ(list.labels[0].b.x, x - 1);
    Box segment;
    segment.grow(list.labels[0].a);
    segment.grow(list.labels[0].b);
    EXPECT_TRUE(gap->surroundings.contains(segment));
  }
  ViewState without;
  without.shown.gap = false;
  EXPECT_FALSE(subject.facts(without).gap.has_value());
  EXPECT_TRUE(subject.draw_list(without).labels.empty());
  subject.place_object(Pose::translation(10, 0, 5));
  EXPECT_FALSE(subject.facts({}).gap.has_value()) << "it touches the block";
  EXPECT_TRUE(subject.draw_list({}).labels.empty());
}

TEST(SceneSubject, AGapThatIsNotKnownInTimeIsBoundedInNumbersAndNotDrawn) {
  SceneSubject subject(block_and_cube());
  subject.set_gap_patience(std::chrono::nanoseconds(0));
  subject.place_object(Pose::translation(14, 0, 5));
  EXPECT_TRUE(subject.draw_list({}).labels.empty());
  if (const auto gap = subject.facts({}).gap) {
    EXPECT_EQ(gap->numbers[0].second.find("at most "), 0U);
    EXPECT_TRUE(gap->surroundings.empty());
  }
  subject.set_gap_patience(std::nullopt);
  subject.place_object(Pose::translation(15, 0, 5));
  EXPECT_EQ(subject.draw_list({}).labels.size(), 1U);
}

TEST(SceneSubject, PickingAMoverMakesItTheObject) {
  SceneSubject subject(with_traffic());
  EXPECT_EQ(subject.facts({}).object, Pose::translation(20, 0, 5));
  ASSERT_TRUE(subject.pick(down(0.2, -20.3)));
  subject.select();
  EXPECT_EQ(subject.facts({}).object, Pose::translation(0, -20, 1));
  const DrawList chosen = subject.draw_list({});
  subject.deselect();
  EXPECT_LT(subject.draw_list({}).lines.size(), chosen.lines.size());
}

TEST(SceneSubject, ACarThatTheHandMovedGoesOnAlongItsWayFromHome) {
  SceneSubject subject(with_traffic());
  ASSERT_TRUE(subject.pick(down(0.2, -20.3)));
  subject.select();
  subject.place_object(Pose::translation(0, 0, 40));
  subject.advance(5);
  EXPECT_EQ(subject.facts({}).object, Pose::translation(0, 0, 40));
  subject.object_home();
  EXPECT_EQ(subject.facts({}).object, Pose::translation(5, -20, 1));
}

TEST(SceneSubject, OpensADroppedModelAsTheNewObjectAndRefusesABrokenOne) {
  const soms::test::TemporaryFolder folder;
  const auto path = folder.path() / "van.ply";
  write_mesh(path, soms::test::box_body({30, 0, 0}, {33, 2, 2}), MeshFormat::ply);
  SceneSubject subject(block_and_cube());
  subject.open(path.string());
  EXPECT_EQ(subject.facts({}).movers, 2U);
  EXPECT_EQ(subject.facts({}).object_bounds, (Box{{30, 0, 0}, {33, 2, 2}}));
  EXPECT_THROW(subject.open((folder.path() / "nothing.ply").string()), Error);
  EXPECT_EQ(subject.facts({}).movers, 2U);
  ViewState state;
  state.orientation_test = 0;
  subject.choose(state);
  subject.open(path.string());  // the new object is in no test
  EXPECT_FALSE(subject.facts(state).orientation_test);
}

TEST(SceneSubject, SaysWhatADroppedFileStatesAndWhatBecameOfIt) {
  const soms::test::TemporaryFolder folder;
  const auto path = folder.path() / "van.glb";
  Mesh mesh = soms::test::box_body({30, 0, 0}, {33, 2, 2});
  mesh.up = UpAxis::y;
  write_mesh(path, mesh, MeshFormat::glb);
  SceneSubject subject(block_and_cube());
  EXPECT_EQ(subject.facts({}).note, "");
  subject.open(path.string());
  EXPECT_NE(subject.facts({}).note.find("van.glb: the up axis is y; rotated to z"),
            std::string::npos);
  subject.open((soms::test::data("formats/groups.obj")).string());
  EXPECT_NE(subject.facts({}).note.find("groups.obj: "), std::string::npos);
}

TEST(SceneSubject, AnEmptySceneCanBeShownAndFilled) {
  const soms::test::TemporaryFolder folder;
  const auto path = folder.path() / "block.ply";
  write_mesh(path, soms::test::box_body({-1, -1, 0}, {1, 1, 1}), MeshFormat::ply);
  SceneSubject subject(SceneContent{});
  Session session(subject, {640, 480});
  EXPECT_TRUE(session.picture().instances.empty());
  EXPECT_FALSE(subject.pick(down(0, 0)));
  session.push(FileDropped{path.string()});
  session.handle({});
  session.tick(0.01);
  EXPECT_TRUE(session.message().empty()) << session.message();
  EXPECT_EQ(session.picture().instances.size(), 1U);
}

}  // namespace
}  // namespace soms::view
