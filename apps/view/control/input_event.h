/// \file
/// What a window reports, without a window: keys, mouse, wheel, files dropped.
#pragma once

#include "apps/view/control/keys.h"
#include "apps/view/drawing/camera.h"

#include <string>
#include <variant>

namespace soms::view {

enum class MouseButton { left, middle, right };

struct KeyDown {
  KeyPress press;
  bool repeat = false;  ///< held down, not pressed again
};

struct KeyUp {
  Key key = Key::none;
};

/// The cursor moved.
struct MouseMove {
  PixelPoint at;
};

struct MouseDown {
  MouseButton button = MouseButton::left;
  PixelPoint at;
  bool shift = false;
  bool control = false;
  double time = 0;  ///< seconds on any clock: two presses make a double click
};

struct MouseUp {
  MouseButton button = MouseButton::left;
  PixelPoint at;
};

struct Wheel {
  double notches = 0;  ///< away from the user
  PixelPoint at;
};

/// Keyboard and mouse went to another window: nothing is held any more.
struct FocusLost {};

struct FileDropped {
  std::string path;
};

using InputEvent =
    std::variant<KeyDown, KeyUp, MouseMove, MouseDown, MouseUp, Wheel, FocusLost, FileDropped>;

}  // namespace soms::view
