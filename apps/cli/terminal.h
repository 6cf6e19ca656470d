/// \file
/// What a terminal shows to people: lines of its width, in colors. Pipes and files get neither.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace soms::command {

/// What words on a terminal are. Terminals have their own shades of these colors, which suit their
/// background; apps/draw/look.h has the same meanings for pictures and pages.
enum class Ink {
  heading,  ///< bold
  touches,  ///< red, as contacts are everywhere
  free,     ///< green
  open,     ///< yellow: a warning, or what is undecided
};

/// A stream that may be a terminal.
struct Terminal {
  bool person = false;    ///< it is one: lines are laid out for its reader
  bool colors = false;    ///< shows colors, or a pipe does, by CLICOLOR_FORCE
  std::size_t width = 0;  ///< columns; 0 where lines may have any length

  /// `text` in a color, where there are colors.
  [[nodiscard]] std::string paint(std::string_view text, Ink ink) const;

  /// Digits of a number in a table: six for people, nine where the text may be read by a program.
  [[nodiscard]] int digits() const { return person ? 6 : 9; }
};

/// What a descriptor is. The width is COLUMNS, or else what the terminal says, or else 80.
[[nodiscard]] Terminal terminal_of(int descriptor);

/// A verdict in the color of what it says. What is undecided may be found, or not.
[[nodiscard]] Ink ink_of(bool found, bool undecided);

/// `text` in lines of at most `width` columns, broken at blanks; `indent` blanks before each line
/// but the first. A word that is longer stays whole. As it is where `width` is 0.
[[nodiscard]] std::string wrap_words(std::string_view text, std::size_t width, std::size_t indent);

/// A help for a terminal: meanings of options hang in their column, commands continue behind
/// backslashes, and headings are bold. As it is for what is no terminal.
[[nodiscard]] std::string help_on(const Terminal& terminal, std::string_view help);

}  // namespace soms::command
