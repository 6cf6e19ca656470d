/// \file
/// A file that is dragged from another program and dropped on a window (XDND).
#pragma once

#include <filesystem>
#include <string>

namespace soms::view::test_window {

/// Drops a file on a window, as a file manager does, and waits until the window's program has taken
/// it. \pre The window takes drops.
void drop_file(const std::string& display, unsigned long window, const std::filesystem::path& file);

}  // namespace soms::view::test_window
