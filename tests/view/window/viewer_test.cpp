// The real viewer in a real window, on a display of its own: Xvfb, with xdotool at the keys.
#include "soms/io/write_mesh.h"

#include "apps/view/control/session.h"
#include "apps/view/drawing/palette.h"
#include "apps/view/drawing/picture_file.h"
#include "apps/view/scene/load.h"
#include "apps/view/window/scene_subject.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"
#include "tests/support/wait.h"
#include "tests/view/pictures.h"
#include "tests/view/window/display.h"
#include "tests/view/window/drop.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <utility>

namespace soms::view {
namespace {

using view::test_window::Display;
using view::test_window::RunningProgram;

constexpr Size kSize{960, 540};

/// Pixels in the red of contacts, as light and smoothing leave it.
std::size_t red_pixels(const Picture& picture) {
  return count_near(picture, palette::kContact, 40);
}

class ViewerTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!Display::possible()) {
      GTEST_SKIP() << "Xvfb or xdotool is missing: install the packages of section view";
    }
    write_mesh(folder_.path() / "block.ply", soms::test::box_body({-10, -10, 0}, {10, 10, 10}, 4),
               MeshFormat::ply);
    write_mesh(folder_.path() / "cube.ply", soms::test::box_body({-3, -3, -3}, {3, 3, 3}, 4),
               MeshFormat::ply);
    std::ofstream(folder_.path() / "still.csv") << "x,y,z,qw,qx,qy,qz\n20,0,5,1,0,0,0\n";
  }

  [[nodiscard]] std::vector<std::string> words() const {
    return {SOMS_VIEW_COMMAND, "view",   path("block.ply"), "--mover", path("cube.ply"), "--route",
            path("still.csv"), "--size", "960x540"};
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::vector<std::string> words_and(const std::vector<std::string>& more) const {
    std::vector<std::string> all = words();
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// Waits for a picture that F12 or Shift+F12 saves, and takes it away. The viewer has taken all
  /// that came before.
  Picture picture(const Display& display, RunningProgram& viewer, const char* key = "F12") {
    display.type({"key", key});
    const auto file = folder_.path() / "soms-view-1.png";
    soms::test::wait_until([&] { return std::filesystem::exists(file) || viewer.ended(); });
    const Picture read = read_png(file);
    std::filesystem::remove(file);
    return read;
  }

  soms::test::TemporaryFolder folder_;
};

/// The scene as the viewer has it, to know where on the screen things are.
SceneSubject twin() {
  Body block(Shape(soms::test::box_body({-10, -10, 0}, {10, 10, 10}, 4)));
  Body cube(Shape(soms::test::box_body({-3, -3, -3}, {3, 3, 3}, 4)), Pose::translation(20, 0, 5));
  return SceneSubject(two_bodies(std::move(block), std::move(cube)));
}

TEST_F(ViewerTest, KeysActAndADragIntoTheBuildingTurnsPixelsRed) {
  const Display display;
  RunningProgram viewer(words(), folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();

  const Picture before = picture(display, viewer, "shift+F12");
  EXPECT_EQ(before.size, kSize);
  EXPECT_EQ(red_pixels(before), 0U);

  display.type({"key", "Tab"});  // panels off: the picture changes on its left
  const Picture bare = picture(display, viewer, "shift+F12");
  EXPECT_GT(difference(before, bare, 20).beyond, 20'000U);
  EXPECT_EQ(red_pixels(bare), 0U);

  SceneSubject subject = twin();
  Session session(subject, kSize);
  const auto pixel = [&](const Vec3& p) { return project(session.camera(), kSize, p)->pixel; };
  const Gizmo gizmo = *session.gizmo();
  const Vec3 grip = gizmo.center + Vec3{0.7 * gizmo.size, 0, 0};
  display.drag(pixel(grip), pixel(grip - Vec3{9, 0, 0}), [&] { (void)picture(display, viewer); });
  const Picture after = picture(display, viewer);
  EXPECT_GT(red_pixels(after), 200U);

  display.type({"key", "BackSpace"});  // the object back home
  EXPECT_EQ(red_pixels(picture(display, viewer)), 0U);

  display.type({"key", "ctrl+q"});
  EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
  EXPECT_EQ(viewer.errors(), "");
}

/// Waits until a program comes to rest: for two seconds, or more, it takes no time of any
/// processor. One that draws on never does.
void expect_rest(RunningProgram& viewer) {
  double before = -1;
  soms::test::wait_until([&] {
    const double now = viewer.processor_seconds();
    const bool rests = now == before;
    before = now;
    soms::test::wait_at_least(2);
    return rests;
  });
  EXPECT_FALSE(viewer.ended());
}

TEST_F(ViewerTest, StartsStillThoughMoversCouldMove) {
  const Display display;
  RunningProgram viewer({SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover", path("cube.ply"),
                         "--count", "3", "--size", "960x540"},
                        folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  const Picture first = picture(display, viewer);
  expect_rest(viewer);
  EXPECT_EQ(difference(first, picture(display, viewer), 0).beyond, 0U);
}

TEST_F(ViewerTest, WordsAndHandlesGrowOnADenseDisplay) {
  const auto at = [&](int density, const std::string& size) {
    const Display display(density);
    RunningProgram viewer({SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover",
                           path("cube.ply"), "--route", path("still.csv"), "--size", size},
                          folder_.path(), display.name());
    EXPECT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
    return picture(display, viewer);
  };
  const Picture one = at(1, "480x320");
  const Picture two = at(2, "480x320");
  EXPECT_EQ(two.size, (Size{2 * one.size.width, 2 * one.size.height}));
  const auto ink = [](const Picture& p) {
    return static_cast<double>(count_near(p, palette::kInk, 50));
  };
  ASSERT_GT(ink(one), 200);
  EXPECT_NEAR(ink(two) / ink(one), 4, 1.2);
}

TEST_F(ViewerTest, RestsWhereNothingMovesThoughItRuns) {
  const Display display;
  RunningProgram viewer(
      {SOMS_VIEW_COMMAND, "view", path("block.ply"), "--size", "960x540", "--run"}, folder_.path(),
      display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  display.type({"key", "space"});
  (void)picture(display, viewer);
  expect_rest(viewer);
}

TEST_F(ViewerTest, AFileIsOpenedFromTheListAndByDroppingIt) {
  const Display display;
  const std::vector<std::string> block{SOMS_VIEW_COMMAND, "view", path("block.ply"), "--size",
                                       "960x540"};
  const auto with = [&](const std::function<void(RunningProgram&)>& open) {
    RunningProgram viewer(block, folder_.path(), display.name());
    EXPECT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
    const Picture before = picture(display, viewer);
    open(viewer);
    display.type({"key", "7"});  // from above, whatever the view was
    Picture after = before;
    soms::test::wait_until([&] {  // the camera glides there
      const Picture now = picture(display, viewer);
      const bool rests = difference(std::exchange(after, now), now, 0).beyond == 0;
      return rests && difference(before, now, 20).beyond > 1'000U;  // it has begun
    });
    EXPECT_GT(difference(before, after, 20).beyond, 1'000U);
    return after;
  };
  const Picture alone = with([](RunningProgram&) {});
  const Picture dropped = with([&](RunningProgram&) {
    test_window::drop_file(display.name(), display.window("soms view"), path("cube.ply"));
  });
  const Picture chosen = with([&](RunningProgram& viewer) {
    display.type({"key", "ctrl+o"});
    (void)picture(display, viewer, "shift+F12");  // the list is there
    display.type({"key", "Down"});                // from block.ply to cube.ply
    display.type({"key", "Return"});
  });
  EXPECT_GT(difference(alone, dropped, 20).beyond, 1'000U);
  EXPECT_EQ(difference(dropped, chosen, 0).beyond, 0U);
}

TEST_F(ViewerTest, TheNextEventIsFoundAndShown) {
  std::ofstream(folder_.path() / "through.csv")
      << "x,y,z,qw,qx,qy,qz\n20,0,5,1,0,0,0\n15,0,5,1,0,0,0\n9,0,5,1,0,0,0\n20,0,5,1,0,0,0\n";
  const Display display;
  RunningProgram viewer({SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover", path("cube.ply"),
                         "--route", path("through.csv"), "--size", "960x540"},
                        folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  EXPECT_EQ(red_pixels(picture(display, viewer)), 0U);
  display.type({"key", "F3"});
  soms::test::wait_until([&] { return red_pixels(picture(display, viewer)) > 200; });
  display.type({"key", "F5"});  // and the traversal of the two, test by test
  display.type({"key", "F5"});
  EXPECT_EQ(picture(display, viewer).size, kSize);
  display.type({"key", "ctrl+q"});
  EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
  EXPECT_EQ(viewer.errors(), "");
}

TEST_F(ViewerTest, CtrlCEndsCleanlyAlsoWhenItRests) {
  const Display display;
  RunningProgram viewer(words(), folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  (void)picture(display, viewer);
  viewer.signal(SIGINT);
  EXPECT_EQ(viewer.wait(), 130);
  EXPECT_EQ(viewer.errors(), "soms-view view: interrupted\n");
}

TEST_F(ViewerTest, ALostDisplayIsOneSentenceAndStatus5) {
  Display display;
  RunningProgram viewer(words(), folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  (void)picture(display, viewer);
  display.end();
  EXPECT_EQ(viewer.wait(), 5);
  EXPECT_EQ(viewer.errors(),
            "soms-view: the display was lost; start the viewer again when it is back\n");
}

TEST_F(ViewerTest, AScreenshotIsTheFinishedPictureWithoutPanelsAndHandles) {
  const Display display;
  const auto shot = [&](const std::vector<std::string>& more) {
    RunningProgram viewer(words_and(more), folder_.path(), display.name());
    EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
    Picture read = read_png(folder_.path() / "end.png");
    EXPECT_EQ(read.size, kSize);
    return read;
  };
  const Picture bare = shot({"--screenshot", "end.png"});
  EXPECT_EQ(difference(bare, shot({"--frames", "3", "--screenshot", "end.png"}), 0).beyond, 0U);
  const Picture panels = shot({"--screenshot", "end.png", "--with-panels"});
  EXPECT_GT(difference(bare, panels, 20).beyond, 20'000U);

  RunningProgram viewer(words(), folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  EXPECT_EQ(difference(bare, picture(display, viewer), 0).beyond, 0U);
  display.type({"key", "K"});  // handles off: no other picture
  EXPECT_EQ(difference(bare, picture(display, viewer), 0).beyond, 0U);
}

TEST_F(ViewerTest, FramesRunAndEnd) {
  const Display display;
  RunningProgram viewer(words_and({"--frames", "3"}), folder_.path(), display.name());
  EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
}

TEST_F(ViewerTest, AWindowClosedBeforeItsScreenshotIsAnError) {
  const Display display;
  RunningProgram viewer(words_and({"--frames", "1000000", "--screenshot", "end.png"}),
                        folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  display.type({"key", "ctrl+q"});
  EXPECT_EQ(viewer.wait(), 5);
  EXPECT_NE(viewer.errors().find("end.png: the window was closed before"), std::string::npos)
      << viewer.errors();
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "end.png"));
}

TEST_F(ViewerTest, ATestBeginsInTheFrameInWhichMostTouches) {
  const Display display;
  const auto red = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{SOMS_VIEW_COMMAND, "view",         path("block.ply"), "--mover",
                                 path("cube.ply"),  "--size",       "960x540",         "--test",
                                 "right",           "--screenshot", "end.png"};
    all.insert(all.end(), more.begin(), more.end());
    RunningProgram viewer(all, folder_.path(), display.name());
    EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
    return red_pixels(read_png(folder_.path() / "end.png"));
  };
  EXPECT_GT(red({}), 200U);
  EXPECT_EQ(red({"--frame", "0"}), 0U);
  EXPECT_EQ(red({"--frames", "2"}), 0U);  // played from the first frame on
}

/// Pixels in the violet of surfaces that touch, beside boxes that collide.
std::size_t violet_pixels(const Picture& picture) {
  return count_near(picture, palette::kViolet, 60);
}

TEST_F(ViewerTest, TheDemonstrationOfTheThesisTakesTwoKeys) {
  const Display display;
  RunningProgram viewer({SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover", path("cube.ply"),
                         "--size", "960x540"},
                        folder_.path(), display.name());
  ASSERT_TRUE(display.wait_for_window("soms view", viewer)) << viewer.errors();
  (void)picture(display, viewer);
  display.type({"key", "z"});  // tree, traversal and boxes of the thesis
  display.type({"key", "o"});  // the test from the right, which runs
  soms::test::wait_until([&] {
    const Picture now = picture(display, viewer);
    return red_pixels(now) > 100 && violet_pixels(now) > 50;
  });
  display.type({"key", "ctrl+q"});
  EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
}

TEST_F(ViewerTest, TheDemonstrationOfTheThesisTakesOneCommand) {
  const Display display;
  RunningProgram viewer(
      {SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover", path("cube.ply"), "--size",
       "960x540", "--thesis", "--test", "right", "--screenshot", "end.png"},
      folder_.path(), display.name());
  EXPECT_EQ(viewer.wait(), 0) << viewer.errors();
  const Picture end = read_png(folder_.path() / "end.png");
  EXPECT_GT(red_pixels(end), 100U);
  EXPECT_GT(violet_pixels(end), 50U);
}

TEST_F(ViewerTest, ATestThatIsNotThereIsUsage) {
  const Display display;
  for (const auto& [more, said] :
       {std::pair<std::vector<std::string>, std::string>{{"--test", "rigth"}, "right"},
        {{"--test", "top", "--frame", "49"}, "from 0 to 48"},
        {{"--test", "top", "--count", "2"}, "moves the one model"}}) {
    std::vector<std::string> all{SOMS_VIEW_COMMAND, "view", path("block.ply"), "--mover",
                                 path("cube.ply")};
    all.insert(all.end(), more.begin(), more.end());
    RunningProgram viewer(all, folder_.path(), display.name());
    EXPECT_EQ(viewer.wait(), 2) << viewer.errors();
    EXPECT_NE(viewer.errors().find(said), std::string::npos) << viewer.errors();
  }
}

TEST_F(ViewerTest, NoDisplayIsOneSentenceAndStatus5) {
  RunningProgram viewer(words(), folder_.path(), "");
  EXPECT_EQ(viewer.wait(), 5);
  const std::string errors = viewer.errors();
  EXPECT_EQ(errors.rfind("soms-view view: cannot open a window: no display", 0), 0U) << errors;
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1);
}

TEST_F(ViewerTest, AContextBelow33IsOneSentenceAndStatus5) {
  const Display display;
  RunningProgram viewer(words(), folder_.path(), display.name(),
                        {"MESA_GL_VERSION_OVERRIDE=3.1", "MESA_GLSL_VERSION_OVERRIDE=140"});
  EXPECT_EQ(viewer.wait(), 5);
  const std::string errors = viewer.errors();
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

TEST_F(ViewerTest, WrongOptionsAreUsage) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--size", "12"},
                                                {"--size", "10x10"},
                                                {"--frames", "0"},
                                                {"--frame", "3"},
                                                {"--with-panels"}}) {
    RunningProgram viewer(words_and(wrong), folder_.path(), "");
    EXPECT_EQ(viewer.wait(), 2) << wrong[0] << viewer.errors();
  }
}

}  // namespace
}  // namespace soms::view
