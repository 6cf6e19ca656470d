/// \file
/// What other programs of a desktop do: a file is dropped on a window (XDND), and all learn how
/// dense the display is.
#pragma once

#include <filesystem>
#include <string>

namespace soms::view::test_window {

/// Drops a file on a window, as a file manager does, and waits until the window's program has taken
/// it. \pre The window takes drops.
void drop_file(const std::string& display, unsigned long window, const std::filesystem::path& file);

/// Says, before a program starts, how many pixels a point has.
void set_density(const std::string& display, int density);

}  // namespace soms::view::test_window
