/// \file
/// A display of our own for programs with windows, and such programs.
#pragma once

#include "apps/view/drawing/camera.h"

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace soms::view::test_window {

class RunningProgram;

/// An X server without a screen (Xvfb) that lives as long as the object, with a mouse and keys.
class Display {
 public:
  /// True where Xvfb and xdotool are installed.
  [[nodiscard]] static bool possible();

  /// `density`: pixels of a point, as the desktop says.
  explicit Display(int density = 1);
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// For the variable DISPLAY.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Waits for a window of a program whose title has these words; false if the program ended
  /// before.
  [[nodiscard]] bool wait_for_window(const std::string& title, RunningProgram& program) const;

  /// The number of the window whose title has these words. \pre It is there.
  [[nodiscard]] unsigned long window(const std::string& title) const;

  /// Runs xdotool with these words.
  void type(const std::vector<std::string>& words) const;

  /// Moves the mouse to a place, presses, moves it to another in steps, releases. Calls `taken`
  /// after each act, which waits until the program has taken it.
  void drag(PixelPoint from, PixelPoint to, const std::function<void()>& taken) const;

  /// Ends the server, windows or not.
  void end();

 private:
  pid_t server_ = -1;
  std::string name_;
};

/// A program that runs beside the test; it is killed with the object.
class RunningProgram {
 public:
  /// Starts it in a folder, on a display (empty: none), with software OpenGL and these variables.
  RunningProgram(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::string& display, const std::vector<std::string>& variables = {});
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits for its end; exit status, 128 + n for signal n.
  [[nodiscard]] int wait();

  /// True once it ended.
  [[nodiscard]] bool ended();

  void signal(int number) const;

  /// Time that it took of processors so far.
  [[nodiscard]] double processor_seconds() const;

  /// What it wrote to standard error so far.
  [[nodiscard]] std::string errors() const;

 private:
  pid_t child_ = -1;
  int status_ = -1;
  std::filesystem::path errors_;
};

}  // namespace soms::view::test_window
