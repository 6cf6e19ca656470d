/// \file
/// A window with a context of OpenGL 3.3 and the panels' back ends, which turns what the window
/// system reports into events.
#pragma once

#include "apps/view/control/input_event.h"
#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/picture_file.h"

#include <memory>
#include <string>
#include <vector>

namespace soms::view {

/// A window that is shown from its making to its end, with a context that is current. There is one
/// at a time, in the main thread.
class AppWindow {
 public:
  /// \errors ErrorKind::cannot_write without a display or without OpenGL 3.3: the message names
  ///         what is missing.
  AppWindow(const std::string& title, Size size);
  ~AppWindow();
  AppWindow(const AppWindow&) = delete;
  AppWindow& operator=(const AppWindow&) = delete;

  /// Waits for events, at most `seconds`; 0 only looks, a negative number waits without end.
  void wait(double seconds);

  /// Ends a `wait` in another thread.
  static void wake();

  /// What was reported since the last call. Any report, also of a change of size or of a part to be
  /// redrawn, sets `touched`.
  [[nodiscard]] std::vector<InputEvent> take_events(bool& touched);

  /// Looks for reports; true if one came that is more than a move of the mouse: a key, a button,
  /// the wheel, a file, or the end.
  [[nodiscard]] bool wants_answer() const;

  [[nodiscard]] bool close_requested() const;

  /// Size in the units of the cursor and the panels.
  [[nodiscard]] Size size() const;

  /// Size in pixels; 0 x 0 while it is an icon.
  [[nodiscard]] Size pixels() const;

  /// Units of the cursor and the panels that a point of text has: above 1 on dense displays whose
  /// windows are measured in pixels.
  [[nodiscard]] double point() const;

  /// Pixels of a point.
  [[nodiscard]] double density() const;

  /// Fills the frame buffer with the color of the panels.
  void clear();

  /// Begins a frame of the panels.
  void begin_panels();

  /// Draws the panels over what is in the frame buffer.
  void end_panels();

  /// The frame buffer before it is shown.
  [[nodiscard]] Picture read_pixels() const;

  /// Waits until all is drawn, so that times are those of drawing and not of asking for it.
  void finish();

  /// Shows the frame.
  void show();

  /// Takes the window off the screen.
  void hide();

  void set_title(const std::string& title);

  /// Full screen, and back to where it was.
  void toggle_fullscreen();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms::view
