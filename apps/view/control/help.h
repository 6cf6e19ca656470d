/// \file
/// Lines of the help: mouse and keys, by groups.
#pragma once

#include <string>
#include <vector>

namespace soms::view {

/// A line of the help; a heading has no text.
struct HelpLine {
  std::string keys;
  std::string text;
};

/// What the mouse does, then the table of actions by groups; fine moves in one line.
[[nodiscard]] std::vector<HelpLine> help_lines();

}  // namespace soms::view
