/// \file
/// Keys of GLFW as the viewer's.
#pragma once

#include "apps/view/control/keys.h"

namespace soms::view {

/// The viewer's key of a key of GLFW; Key::none where it has none. Letters and the marks that stand
/// in the table of actions follow the layout of the keyboard: `layout_name` is what GLFW calls the
/// key, or nullptr. Digits, and keys whose mark no action has, go by their place on a US keyboard.
/// Keys of the number pad are those of the main field.
[[nodiscard]] Key key_of_glfw(int glfw_key, const char* layout_name);

/// The press of a key with GLFW's modifiers.
[[nodiscard]] KeyPress press_of_glfw(Key key, int modifiers);

}  // namespace soms::view
