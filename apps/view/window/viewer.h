/// \file
/// The loop of the viewer: a window, a session, a renderer.
#pragma once

#include "apps/view/control/session.h"
#include "apps/view/control/subject.h"
#include "apps/view/drawing/camera.h"
#include "apps/view/window/opening.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace soms::view {

/// An orientation test that runs from the start on.
struct StartedTest {
  std::size_t row = 0;  ///< of `orientation_tests`
  std::uint64_t frame = 0;
};

/// How the viewer starts and, for scripts, how it ends.
struct ViewerOptions {
  Size size{1280, 720};
  bool run = false;  ///< starts running; else it stands still at the first frame
  bool panels = true;
  BuildOptions build{.rule = Rule::soms};  ///< of the trees that are shown
  TraversalOptions traversal = {};         ///< that is chosen at first
  bool boxes = false;                      ///< of the traversal are shown from the start on
  std::optional<StartedTest> test;
  /// PNG of the finished picture, after which the viewer ends; empty: none.
  std::string screenshot;
  bool screenshot_panels = false;       ///< with the panels over it
  std::optional<std::uint64_t> frames;  ///< runs as many, each a sixtieth of a second, then ends
};

/// Makes what is shown, in a thread of its own, and says meanwhile what it does.
using SubjectMaker = std::function<std::unique_ptr<Subject>(const Say& say)>;

/// Opens a window, which shows how far `make` has come, and then the subject, until the window is
/// closed, the user quits, or a stop is requested. Draws only when something changed or runs, and
/// at most about 60 times a second. \errors As `make`, `AppWindow`, `GlRenderer` and `write_png`;
/// ErrorKind::cannot_write where the window is closed before the frame of `screenshot`.
void run_viewer(const SubjectMaker& make, const ViewerOptions& options,
                const std::stop_token& stop);

}  // namespace soms::view
