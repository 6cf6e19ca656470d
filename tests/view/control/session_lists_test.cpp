// Lists of the session: events, tests of a traversal, files.
#include "apps/view/control/action.h"
#include "apps/view/control/session.h"
#include "tests/support/support.h"
#include "tests/view/control/mock_subject.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace soms::view {
namespace {

constexpr Size kListWindow{1280, 720};

class SessionListsTest : public testing::Test {
 protected:
  void frame() {
    session_.handle({});
    session_.tick(1.0 / 60);
  }

  void press(const KeyPress& key) {
    session_.push(KeyDown{key});
    session_.push(KeyUp{key.key});
    frame();
  }

  void press(Action action) { press(actions()[static_cast<std::size_t>(action)].press); }

  /// Lets glides of the camera and searches end.
  void rest() {
    for (int i = 0; i < 40; ++i) {
      frame();
    }
  }

  MockSubject subject_;
  Session session_{subject_, kListWindow};
};

TEST_F(SessionListsTest, EventsAreSearchedForOnlyWhereTheyAreListed) {
  frame();
  frame();
  EXPECT_EQ(subject_.searches, 0);
  EXPECT_FALSE(session_.animating());
  press(Action::events);
  EXPECT_TRUE(session_.animating());
  rest();
  EXPECT_EQ(subject_.searches, 2);  // of ten frames each
  EXPECT_FALSE(session_.animating());
}

TEST_F(SessionListsTest, ASearchForEventsLeavesThePictureAsItIs) {
  frame();
  (void)session_.picture();
  const int lists = subject_.lists;
  const std::uint64_t version = session_.version();
  press(Action::events);
  for (int i = 0; i < 5; ++i) {
    frame();
    (void)session_.picture();
  }
  EXPECT_EQ(subject_.searches, 2);
  EXPECT_EQ(subject_.lists, lists);
  EXPECT_EQ(session_.version(), version);
}

TEST_F(SessionListsTest, AListThatIsHiddenSearchesForNothing) {
  press(Action::events);
  session_.state().panels = false;
  const int before = subject_.searches;
  frame();
  EXPECT_EQ(subject_.searches, before);
  EXPECT_FALSE(session_.animating());
}

TEST_F(SessionListsTest, TheNextEventIsGoneToOnceItIsFound) {
  const Camera before = session_.camera();
  press(Action::event_next);
  EXPECT_EQ(session_.state().event, std::nullopt);  // none is found yet
  rest();
  EXPECT_EQ(session_.state().event, 0U);
  EXPECT_EQ(subject_.frame, 5U);
  ASSERT_TRUE(session_.picked());
  EXPECT_EQ(session_.picked()->title, "car (mover 1) touches house");
  EXPECT_NE(session_.camera(), before);
  const auto seen = project(session_.camera(), kListWindow, {12, 12, 2});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->pixel.x, kListWindow.width / 2.0, 1);
  press(Action::event_next);
  rest();
  EXPECT_EQ(session_.state().event, 1U);
  EXPECT_EQ(subject_.frame, 7U);
  press(Action::event_next);
  EXPECT_EQ(session_.state().event, 1U);
  EXPECT_EQ(session_.message(), "this is the last event");
  press(Action::event_previous);
  rest();
  EXPECT_EQ(session_.state().event, 0U);
  press(Action::event_previous);
  EXPECT_EQ(session_.state().event, 0U);
  EXPECT_EQ(session_.message(), "this is the first event");
}

TEST_F(SessionListsTest, AnEventThatStillGoesOnIsAwaited) {
  subject_.rows_at_once = true;
  subject_.found.frames = 100;
  press(Action::event_next);  // ten frames are searched, and the event ends in frame 9 or later
  EXPECT_EQ(session_.state().event, std::nullopt);
  EXPECT_EQ(session_.state().requests.event, 0U);
  EXPECT_TRUE(session_.animating());
  EXPECT_EQ(subject_.frame, 0U);
  frame();
  EXPECT_EQ(session_.state().event, 0U);
  EXPECT_EQ(subject_.frame, subject_.rows[0].most_frame);
  EXPECT_EQ(subject_.searches, 2) << "the rest is not needed";
  session_.state().requests.event = 7;  // no such row
  frame();
  EXPECT_EQ(session_.state().requests.event, std::nullopt);
}

TEST_F(SessionListsTest, TheFirstEventIsShownOnceToWhoDoesNothing) {
  const Camera before = session_.camera();
  session_.await_first_event();
  EXPECT_TRUE(session_.animating());
  rest();
  EXPECT_EQ(session_.state().event, 0U);
  EXPECT_EQ(subject_.frame, subject_.rows[0].most_frame);
  EXPECT_NE(session_.camera(), before);
  EXPECT_FALSE(session_.picked()) << "no panel covers the picture";
  EXPECT_EQ(session_.message().rfind("frame 5: car (mover 1) touches house", 0), 0U)
      << session_.message();
  session_.state().requests.seek = 0;
  rest();
  EXPECT_EQ(subject_.frame, 0U) << "once only";
  EXPECT_EQ(session_.message(), "") << "it was of another frame";
}

TEST_F(SessionListsTest, WhoDoesAnythingIsNotTakenToTheFirstEvent) {
  for (const InputEvent& act :
       {InputEvent{KeyDown{{key_of('E')}}}, InputEvent{Wheel{1, {9, 9}}},
        InputEvent{MouseDown{MouseButton::left, {9, 9}, false, false, 0}}}) {
    MockSubject subject;
    Session session(subject, kListWindow);
    session.await_first_event();
    session.push(MouseMove{{5, 5}});
    session.push(act);
    for (int i = 0; i < 5; ++i) {
      session.handle({});
      session.tick(1.0 / 60);
    }
    EXPECT_EQ(session.state().event, std::nullopt);
    EXPECT_EQ(subject.searches, 0);
  }
  session_.state().paused = false;
  session_.await_first_event();
  rest();
  EXPECT_EQ(session_.state().event, std::nullopt) << "it runs";
}

TEST_F(SessionListsTest, WhatIsKnownOfAContactChangesWithTimeAndEndsWithIt) {
  press(Action::event_next);
  rest();
  ASSERT_TRUE(session_.picked());
  subject_.touch_until = 9;
  session_.state().requests.seek = 8;
  frame();
  ASSERT_TRUE(session_.picked());
  EXPECT_EQ(session_.picked()->title, "in frame 8");
  EXPECT_TRUE(session_.state().at_event);
  session_.state().requests.seek = 60;
  frame();
  EXPECT_FALSE(session_.picked());
  EXPECT_FALSE(session_.state().selected);
  EXPECT_FALSE(session_.state().at_event);
}

TEST_F(SessionListsTest, AContactIsSeenInTheMiddleBesideAllPanels) {
  const Covered panels{200, 0};
  session_.set_covered(panels, 300);
  press(Action::event_next);
  rest();
  const auto seen = project(session_.camera(), kListWindow, {12, 12, 2});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->pixel.x, (200 + kListWindow.width - 300) / 2.0, 1);
}

TEST_F(SessionListsTest, WhereNothingTouchesItSaysSo) {
  subject_.rows.clear();
  press(Action::event_next);
  rest();
  EXPECT_EQ(session_.message(), "nothing touches in the frames searched");
  EXPECT_EQ(session_.state().event, std::nullopt);
}

TEST_F(SessionListsTest, TestsOfATraversalAreSteppedThroughAndEnd) {
  press(Action::learn_next);
  EXPECT_TRUE(session_.state().learn);
  EXPECT_EQ(session_.state().learn_step, 0U);
  const int lists = subject_.lists;
  press(Action::learn_next);
  (void)session_.picture();
  EXPECT_EQ(session_.state().learn_step, 1U);
  EXPECT_GT(subject_.lists, lists);
  session_.state().learn_step = 100;
  frame();
  EXPECT_EQ(session_.state().learn_step, 11U);
  press(Action::learn_previous);
  EXPECT_EQ(session_.state().learn_step, 10U);
}

TEST_F(SessionListsTest, KeysChooseAFileWhileTheListIsOpen) {
  const soms::test::TemporaryFolder folder;
  for (const char* const name : {"a.ply", "b.ply", "c.ply"}) {
    std::ofstream(folder.path() / name) << "x";
  }
  session_.state().files.emplace(folder.path());
  press(KeyPress{Key::down});
  press(KeyPress{key_of('C')});  // no camera: a letter of a name
  EXPECT_EQ(session_.state().camera, CameraMode::orbit);
  press(KeyPress{Key::up});
  press(KeyPress{Key::enter});
  ASSERT_EQ(subject_.opened.size(), 1U);
  EXPECT_EQ(std::filesystem::path(subject_.opened[0]).filename(), "b.ply");
  EXPECT_FALSE(session_.state().files);
  press(Action::open);
  ASSERT_TRUE(session_.state().files);  // where the last one was
  EXPECT_EQ(session_.state().files->folder(), std::filesystem::weakly_canonical(folder.path()));
  press(KeyPress{Key::escape});
  EXPECT_FALSE(session_.state().files);
  EXPECT_FALSE(session_.state().requests.quit);
}

}  // namespace
}  // namespace soms::view
