// What a window does while its subject is made, on a display of its own.
#include "apps/view/window/opening.h"

#include "soms/base/error.h"

#include "tests/view/window/display.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <future>

namespace soms::view {
namespace {

class OpeningTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_window::Display::possible()) {
      GTEST_SKIP() << "Xvfb or xdotool is missing: install the packages of section view";
    }
    display_.emplace();
    ::setenv("DISPLAY", display_->name().c_str(), 1);
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    window_.emplace("opening", Size{320, 200});
  }

  std::optional<test_window::Display> display_;
  std::optional<AppWindow> window_;
  std::vector<InputEvent> events_;
};

TEST_F(OpeningTest, APictureComesBeforeTheEndOfTheWork) {
  std::promise<void> shown;
  std::optional<Color> middle;
  const auto work = [&](const Say& say) {
    say("reading", 0.5);
    shown.get_future().wait();  // it is not over before there is a picture
  };
  const auto meanwhile = [&] {
    middle = window_->read_pixels().at(160, 20);
    shown.set_value();
  };
  EXPECT_TRUE(work_behind(*window_, work, meanwhile, events_, {}));
  ASSERT_TRUE(middle);
  EXPECT_GT(int{middle->r} + int{middle->g} + int{middle->b}, 600) << "not black";
}

TEST_F(OpeningTest, ErrorsOfTheWorkAreThrown) {
  const auto work = [](const Say&) { throw Error(ErrorKind::bad_file, "broken", ""); };
  EXPECT_THROW((void)work_behind(*window_, work, [] {}, events_, {}), Error);
}

TEST_F(OpeningTest, EscEndsTheWork) {
  bool cancelled = false;
  const auto work = [&](const Say& say) {
    try {
      for (;;) {
        say("reading", 0);
      }
    } catch (const Error& error) {
      cancelled = error.kind() == ErrorKind::cancelled;
      throw;
    }
  };
  events_.emplace_back(KeyDown{{Key::escape}});
  EXPECT_FALSE(work_behind(*window_, work, [] {}, events_, {}));
  EXPECT_TRUE(cancelled);
}

}  // namespace
}  // namespace soms::view
