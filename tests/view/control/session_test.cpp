#include "apps/view/control/session.h"

#include "apps/view/control/action.h"
#include "tests/view/control/mock_subject.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms::view {
namespace {

constexpr Size kWindowSize{1280, 720};
constexpr double kTick = 1.0 / 60;

double eye_distance(const Vec3& a, const Vec3& b) {
  const Vec3 d = a - b;
  return std::sqrt(dot(d, d));
}

class SessionTest : public testing::Test {
 protected:
  void SetUp() override { session_.state().paused = true; }

  void frame(double seconds = kTick) {
    session_.handle({});
    session_.tick(seconds);
  }

  void press(const KeyPress& key) {
    session_.push(KeyDown{key});
    session_.push(KeyUp{key.key});
    frame();
  }

  void press(Action action) { press(actions()[static_cast<std::size_t>(action)].press); }

  void drag(MouseButton button, PixelPoint from, PixelPoint to, bool shift = false) {
    session_.push(MouseMove{from});
    session_.push(MouseDown{button, from, shift, false, now_ += 1});
    frame();
    session_.push(MouseMove{to});
    frame();
    session_.push(MouseUp{button, to});
    frame();
  }

  void click(PixelPoint at, double time) {
    session_.push(MouseMove{at});
    session_.push(MouseDown{MouseButton::left, at, false, false, time});
    session_.push(MouseUp{MouseButton::left, at});
    frame();
  }

  /// Lets glides of the camera end.
  void rest() {
    for (int i = 0; i < 40; ++i) {
      frame();
    }
  }

  PixelPoint pixel_of(const Vec3& point) {
    return project(session_.camera(), kWindowSize, point)->pixel;
  }

  /// A place of the ground away from the handles.
  PixelPoint ground() { return pixel_of({50, -60, 0}); }

  MockSubject subject_;
  Session session_{subject_, kWindowSize};
  double now_ = 100;
};

TEST_F(SessionTest, BeginsWithAllInView) {
  for (const Vec3& corner : {Vec3{-100, -100, 0}, Vec3{100, 100, 50}, Vec3{100, -100, 0}}) {
    const auto seen = project(session_.camera(), kWindowSize, corner);
    ASSERT_TRUE(seen);
    EXPECT_GT(seen->pixel.x, 0);
    EXPECT_LT(seen->pixel.x, kWindowSize.width);
    EXPECT_GT(seen->pixel.y, 0);
    EXPECT_LT(seen->pixel.y, kWindowSize.height);
  }
}

TEST(Session, StartsStill) {
  MockSubject subject;
  Session session(subject, kWindowSize);
  session.tick(kTick);
  EXPECT_FALSE(session.animating());
  EXPECT_EQ(subject.advanced, 0);
}

TEST_F(SessionTest, DoesNotRunWhereNothingMoves) {
  subject_.moves = false;
  frame();
  press(Action::pause);
  frame(1);
  EXPECT_TRUE(session_.state().paused);
  EXPECT_FALSE(session_.animating());
  EXPECT_EQ(subject_.advanced, 0);
  EXPECT_NE(session_.message().find("nothing moves"), std::string::npos) << session_.message();
  subject_.moves = true;
  frame();
  press(Action::pause);
  EXPECT_TRUE(session_.animating());
}

TEST_F(SessionTest, TheViewIsFittedBesideThePanelsUntilTheUserMovesIt) {
  session_.set_covered({400, 200});
  for (const Vec3& corner : {Vec3{-100, -100, 0}, Vec3{100, 100, 50}, Vec3{100, -100, 0}}) {
    const auto seen = project(session_.camera(), kWindowSize, corner);
    ASSERT_TRUE(seen);
    EXPECT_GT(seen->pixel.x, 400);
    EXPECT_LT(seen->pixel.x, kWindowSize.width - 200);
  }
  drag(MouseButton::left, {900, 600}, {960, 600});
  const Camera moved = session_.camera();
  session_.set_covered({});
  EXPECT_EQ(session_.camera(), moved);
}

TEST_F(SessionTest, TheBarePictureHasNoHandles) {
  frame();
  const std::size_t bare = session_.bare_picture().lines.size();
  EXPECT_EQ(bare, 1U);
  EXPECT_GT(session_.picture().lines.size(), bare);
  EXPECT_EQ(session_.bare_picture().lines.size(), bare);
}

TEST_F(SessionTest, DraggingTurnsAndShiftDraggingShifts) {
  const Camera before = session_.camera();
  drag(MouseButton::left, {900, 600}, {960, 600});
  EXPECT_EQ(session_.camera().target, before.target);
  EXPECT_NE(session_.camera().eye, before.eye);
  const Camera turned = session_.camera();
  drag(MouseButton::left, {900, 600}, {960, 600}, true);
  EXPECT_NE(session_.camera().target, turned.target);
  drag(MouseButton::middle, {960, 600}, {900, 600});
  EXPECT_LT(eye_distance(session_.camera().target, turned.target), 1e-6);
  drag(MouseButton::right, {900, 600}, {900, 500});
  EXPECT_LT(distance_to_target(session_.camera()), distance_to_target(turned));
}

TEST_F(SessionTest, ATremblingClickPicksAndDoesNotMoveTheCamera) {
  const Camera before = session_.camera();
  drag(MouseButton::left, ground(), {ground().x + 2, ground().y + 1});
  EXPECT_EQ(session_.camera(), before);
  ASSERT_TRUE(session_.picked());
  EXPECT_EQ(subject_.selected, "triangle 4711 of mock city");
  EXPECT_TRUE(session_.state().selected);
}

TEST_F(SessionTest, AClickBesideEverythingDropsWhatWasPicked) {
  click(ground(), 1);
  ASSERT_TRUE(session_.picked());
  click({5, 5}, 10);
  EXPECT_FALSE(session_.picked());
  EXPECT_TRUE(subject_.selected.empty());
}

TEST_F(SessionTest, APickThatFailsIsAMessage) {
  subject_.refuse_to_pick = true;
  click(ground(), 1);
  EXPECT_FALSE(session_.picked());
  EXPECT_EQ(session_.message(), "a ray beyond 2^300; come nearer");
  click(ground(), 1.2);
  session_.push(Wheel{1, ground()});
  EXPECT_NO_THROW(frame());
}

TEST_F(SessionTest, EscapeDropsWhatWasPickedAndOnlyThenQuits) {
  click(ground(), 1);
  press(Action::back);
  EXPECT_FALSE(session_.picked());
  EXPECT_FALSE(session_.state().requests.quit);
  press(Action::back);
  EXPECT_TRUE(session_.state().requests.quit);
}

TEST_F(SessionTest, DoubleClickMakesThePlaceThePivot) {
  click({800, 500}, 1);
  const Vec3 point = session_.picked()->point;
  click({800, 500}, 1.2);
  rest();
  EXPECT_LT(eye_distance(session_.camera().target, point), 1e-9);
}

TEST_F(SessionTest, TwoSlowClicksAreNoDoubleClick) {
  const Camera before = session_.camera();
  click({800, 500}, 1);
  click({800, 500}, 2);
  rest();
  EXPECT_EQ(session_.camera(), before);
}

TEST_F(SessionTest, WheelKeepsThePlaceUnderTheCursor) {
  const PixelPoint cursor{800, 500};
  const Vec3 under = subject_.pick(ray_through(session_.camera(), kWindowSize, cursor))->point;
  session_.push(Wheel{3, cursor});
  frame();
  EXPECT_NEAR(pixel_of(under).x, cursor.x, 1e-6);
  EXPECT_NEAR(pixel_of(under).y, cursor.y, 1e-6);
}

TEST_F(SessionTest, ManyTurnsOfTheWheelEndAndComeBack) {
  const Vec3 forward = view::frame(session_.camera()).forward;
  for (const double notches : {50.0, -50.0}) {
    for (int i = 0; i < 200; ++i) {
      session_.push(Wheel{notches, {640, 360}});
      frame();
    }
    const double distance = distance_to_target(session_.camera());
    EXPECT_GT(distance, 1e-8);
    EXPECT_LT(distance, 1e7);
    EXPECT_LT(eye_distance(view::frame(session_.camera()).forward, forward), 1e-3) << notches;
  }
}

TEST_F(SessionTest, DraggingAnArrowMovesTheObjectAlongItsAxis) {
  const Gizmo gizmo = *session_.gizmo();
  const Camera before = session_.camera();
  const Vec3 grip = gizmo.center + Vec3{0.8 * gizmo.size, 0, 0};
  const Vec3 goal = grip + Vec3{30, 0, 0};
  drag(MouseButton::left, pixel_of(grip), pixel_of(goal));
  EXPECT_LT(eye_distance(subject_.object.shift(), {30, 0, 10}), 1e-6);
  EXPECT_EQ(session_.camera(), before);
  EXPECT_FALSE(session_.picked());
}

TEST_F(SessionTest, ManyMovesOfTheMouseInOneFrameAskForContactsOnce) {
  const Gizmo gizmo = *session_.gizmo();
  const PixelPoint grip = pixel_of(gizmo.center + Vec3{0.8 * gizmo.size, 0, 0});
  session_.push(MouseMove{grip});
  session_.push(MouseDown{MouseButton::left, grip});
  frame();
  for (int i = 1; i <= 50; ++i) {
    session_.push(MouseMove{{grip.x + i, grip.y}});
  }
  frame();
  EXPECT_EQ(subject_.placed, 1);
}

TEST_F(SessionTest, EscapeDuringADragPutsTheObjectBack) {
  const Gizmo gizmo = *session_.gizmo();
  const PixelPoint grip = pixel_of(gizmo.center + Vec3{0.8 * gizmo.size, 0, 0});
  session_.push(MouseMove{grip});
  session_.push(MouseDown{MouseButton::left, grip});
  session_.push(MouseMove{{grip.x + 60, grip.y}});
  frame();
  EXPECT_NE(subject_.object, Pose::translation(0, 0, 10));
  press(Action::back);
  EXPECT_EQ(subject_.object, Pose::translation(0, 0, 10));
  EXPECT_FALSE(session_.state().requests.quit);
}

TEST_F(SessionTest, TheHandleUnderTheCursorIsDrawnBrighter) {
  const Gizmo gizmo = *session_.gizmo();
  EXPECT_FALSE(session_.handle_in_use());
  session_.push(MouseMove{pixel_of(gizmo.center + Vec3{0, 0, 0.8 * gizmo.size})});
  frame();
  EXPECT_EQ(session_.handle_in_use(), Handle::axis_z);
  session_.handle({.mouse = true});
  EXPECT_FALSE(session_.handle_in_use());
}

TEST_F(SessionTest, KeysMoveTheObjectAsTheCameraSeesIt) {
  press(Action::view_front);
  rest();
  press(Action::object_right);
  EXPECT_LT(eye_distance(subject_.object.shift(), {0.4, 0, 10}), 1e-12);
  press(Action::object_forward);
  EXPECT_LT(eye_distance(subject_.object.shift(), {0.4, 0.4, 10}), 1e-12);
  press(Action::object_up_fine);
  EXPECT_LT(eye_distance(subject_.object.shift(), {0.4, 0.4, 10.04}), 1e-12);
  press(Action::view_right);
  rest();
  press(Action::object_right);  // from +x, right is +y
  EXPECT_LT(eye_distance(subject_.object.shift(), {0.4, 0.8, 10.04}), 1e-12);
  press(Action::object_home);
  EXPECT_EQ(subject_.object, Pose::translation(0, 0, 10));
}

TEST_F(SessionTest, KeysTurnTheObjectAboutItsMiddle) {
  press(Action::object_turn_left);
  EXPECT_LT(eye_distance(subject_.object.shift(), {0, 0, 10}), 1e-12);
  EXPECT_NEAR(subject_.object.m[4], std::sin(std::acos(-1.0) / 36), 1e-12);
  press(Action::object_turn_right);
  EXPECT_NEAR(subject_.object.m[4], 0, 1e-12);
}

TEST_F(SessionTest, HeldKeysCountEachRepeatOfAMoveAndNoneOfASwitch) {
  press(Action::view_front);
  rest();
  for (int i = 0; i < 5; ++i) {
    session_.push(KeyDown{{Key::right}, i > 0});
    session_.push(KeyDown{{key_of('V')}, i > 0});
  }
  frame();
  EXPECT_NEAR(subject_.object.shift().x, 2, 1e-12);
  EXPECT_TRUE(session_.state().shown.visited);
}

TEST_F(SessionTest, RunsSixtyFramesASecondUnlessPaused) {
  for (int i = 0; i < 60; ++i) {
    frame();
  }
  EXPECT_EQ(subject_.advanced, 0);
  EXPECT_FALSE(session_.animating());
  press(Action::pause);
  const int before = subject_.advanced;
  for (int i = 0; i < 60; ++i) {
    frame();
  }
  EXPECT_EQ(subject_.advanced - before, 60);
  EXPECT_TRUE(session_.animating());
}

TEST_F(SessionTest, ARestIsNotCaughtUpWith) {
  session_.state().paused = false;
  frame(1000);
  EXPECT_LE(subject_.advanced, Playback::kMost);
}

TEST_F(SessionTest, StepsSeeksAndRestarts) {
  press(Action::step);
  EXPECT_EQ(subject_.frame, 1U);
  press(Action::step_back);
  EXPECT_EQ(subject_.frame, 0U);
  press(Action::last_frame);
  EXPECT_EQ(subject_.frame, 99U);
  EXPECT_EQ(session_.state().frame, 99U);
  subject_.can_seek = false;
  frame();
  press(Action::first_frame);
  EXPECT_EQ(subject_.restarts, 1);
}

TEST_F(SessionTest, TellsTheSubjectWhatWasChosenOnceAChange) {
  const int before = subject_.chosen;
  press(Action::rule_next);
  EXPECT_EQ(subject_.chosen, before + 1);
  EXPECT_EQ(subject_.last_choice, choice(session_.state()));
  rest();
  EXPECT_EQ(subject_.chosen, before + 1);
  press(Action::orientation_next);
  EXPECT_EQ(subject_.last_choice.orientation_test, 0U);
}

TEST_F(SessionTest, MovingTheObjectByHandEndsTheTest) {
  press(Action::orientation_next);
  EXPECT_EQ(session_.state().orientation_test, 0U);
  const int before = subject_.chosen;
  press(Action::object_up);
  EXPECT_FALSE(session_.state().orientation_test);
  frame();
  EXPECT_EQ(subject_.chosen, before);
}

TEST_F(SessionTest, FollowsAMoverAndTheNext) {
  press(Action::next_mover);
  const Vec3 to_mover = session_.camera().target - session_.facts().followed->shift();
  session_.state().paused = false;
  for (int i = 0; i < 30; ++i) {
    frame();
  }
  EXPECT_LT(eye_distance(session_.camera().target - session_.facts().followed->shift(), to_mover),
            1e-9);
  EXPECT_GT(session_.facts().followed->shift().x, 20);
  press(Action::next_mover);
  EXPECT_NEAR(session_.camera().target.y, 10, 1e-9);
}

TEST_F(SessionTest, FliesWhileKeysAreHeldAndStopsWhenTheFocusIsLost) {
  press(Action::camera_mode);
  const Camera before = session_.camera();
  session_.push(KeyDown{{key_of('W')}});
  frame(0.1);
  EXPECT_TRUE(session_.animating());
  EXPECT_NEAR(eye_distance(session_.camera().eye, before.eye), 200 * 0.1 * 0.1, 1e-9);
  session_.push(FocusLost{});
  frame(0.1);
  EXPECT_FALSE(session_.animating());
  EXPECT_NEAR(eye_distance(session_.camera().eye, before.eye), 200 * 0.1 * 0.1, 1e-9);
}

TEST_F(SessionTest, PanelsKeepWhatIsTheirs) {
  const Camera before = session_.camera();
  session_.push(MouseDown{MouseButton::left, {10, 10}});
  session_.push(Wheel{3, {10, 10}});
  session_.push(KeyDown{{key_of('V')}});
  session_.push(MouseMove{{300, 300}});
  session_.handle({.mouse = true, .keys = true});
  session_.tick(kTick);
  EXPECT_EQ(session_.camera(), before);
  EXPECT_FALSE(session_.state().shown.visited);
}

TEST_F(SessionTest, ADroppedFileIsOpenedAndABrokenOneIsAMessage) {
  session_.push(FileDropped{"car.ply"});
  frame();
  EXPECT_EQ(subject_.opened, std::vector<std::string>{"car.ply"});
  EXPECT_TRUE(session_.message().empty());
  session_.push(FileDropped{"broken.ply"});
  frame();
  EXPECT_EQ(session_.message(), "broken.ply, line 3: no vertices; repair the file");
  press(Action::step);
  EXPECT_TRUE(session_.message().empty());
}

TEST_F(SessionTest, AMessageStaysWhileTimePasses) {
  session_.state().paused = false;
  session_.push(FileDropped{"broken.ply"});
  frame(0.1);
  frame(0.1);
  EXPECT_GT(subject_.advanced, 0);
  EXPECT_EQ(session_.message(), "broken.ply, line 3: no vertices; repair the file");
  press(Action::step);
  EXPECT_TRUE(session_.message().empty());
}

TEST_F(SessionTest, FocusGoesToWhatIsPickedElseToTheObject) {
  press(Action::focus);
  rest();
  EXPECT_LT(eye_distance(session_.camera().target, {0, 0, 10}), 1e-9);
  press(Action::view_top);
  rest();
  click({500, 300}, 1);
  const Vec3 point = session_.picked()->bounds.center();
  press(Action::focus);
  rest();
  EXPECT_LT(eye_distance(session_.camera().target, point), 1e-9);
}

TEST_F(SessionTest, TheGapIsGoneToWhereThereIsOne) {
  const Camera before = session_.camera();
  press(Action::focus_gap);
  rest();
  EXPECT_EQ(session_.camera(), before);
  EXPECT_NE(session_.message().find("no gap"), std::string::npos) << session_.message();
  subject_.gap = GapFacts{"0.5", {{"Gap", "0.5"}}, {{29, -1, 4}, {31, 1, 6}}};
  press(Action::focus_gap);
  rest();
  EXPECT_LT(eye_distance(session_.camera().target, {30, 0, 5}), 1e-9);
  EXPECT_LT(distance_to_target(session_.camera()), 10);
}

TEST_F(SessionTest, TheSubjectsListIsMadeAnewOnlyAfterAChange) {
  (void)session_.picture();
  const int before = subject_.lists;
  drag(MouseButton::left, {900, 600}, {960, 640});
  (void)session_.picture();
  EXPECT_EQ(subject_.lists, before);
  const std::size_t lines = session_.picture().lines.size();
  (void)session_.picture();
  EXPECT_EQ(session_.picture().lines.size(), lines);
  EXPECT_GT(lines, 1U);
  press(Action::edges);
  (void)session_.picture();
  EXPECT_EQ(subject_.lists, before + 1);
  press(Action::gizmo);
  EXPECT_EQ(session_.picture().lines.size(), 1U);
}

TEST_F(SessionTest, KeepsThePictureWhenTheSubjectRefusesToDraw) {
  const std::size_t lines = session_.picture().lines.size();
  subject_.refuse_to_draw = true;
  press(Action::pruning);
  EXPECT_EQ(session_.picture().lines.size(), lines);
  EXPECT_EQ(session_.message(), "no front without pruning; switch pruning on");
  subject_.refuse_to_draw = false;
  press(Action::pruning);
  const std::uint64_t before = session_.version();
  (void)session_.picture();
  EXPECT_EQ(session_.version(), before + 1);
  EXPECT_TRUE(session_.message().empty());
}

TEST_F(SessionTest, HasNoGizmoWithoutAnObject) {
  subject_.has_object = false;
  frame();
  EXPECT_FALSE(session_.gizmo());
  press(Action::object_right);
  EXPECT_EQ(subject_.placed, 0);
}

TEST_F(SessionTest, ResizingChangesTheRayUnderAPixel) {
  session_.resize({640, 360});
  EXPECT_EQ(session_.window(), (Size{640, 360}));
  const Vec3 place{50, -60, 0};
  click(project(session_.camera(), {640, 360}, place)->pixel, 1);
  ASSERT_TRUE(session_.picked());
  EXPECT_LT(eye_distance(session_.picked()->point, place), 1e-6);
}

TEST(Session, ATestThatIsStartedIsSeenAtOnceInItsFrame) {
  MockSubject subject;
  Session session(subject, {800, 600});
  session.start_test(2, 48);
  EXPECT_EQ(session.state().orientation_test, 2U);
  EXPECT_EQ(subject.last_choice.orientation_test, 2U);
  EXPECT_EQ(subject.frame, 48U);
  const Camera camera = session.camera();
  session.state().paused = true;
  session.tick(1.0 / 60);
  EXPECT_EQ(session.camera(), camera);  // nothing glides
  EXPECT_EQ(session.state().frame, 48U);
}

}  // namespace
}  // namespace soms::view
