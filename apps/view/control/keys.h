/// \file
/// Keys of the keyboard as the viewer knows them, whatever library reports them.
#pragma once

#include <string>

namespace soms::view {

/// A key: printable keys by their character on a US keyboard (letters in upper case), others named.
enum class Key : int {
  none = 0,
  space = ' ',
  apostrophe = '\'',
  comma = ',',
  minus = '-',
  period = '.',
  slash = '/',
  digit_0 = '0',
  digit_9 = '9',
  equal = '=',
  letter_a = 'A',
  letter_z = 'Z',
  left_bracket = '[',
  right_bracket = ']',
  escape = 256,
  enter,
  tab,
  backspace,
  insert,
  del,
  right,
  left,
  down,
  up,
  page_up,
  page_down,
  home,
  end,
  f1,
  f2,
  f3,
  f4,
  f5,
  f11,
  f12,
};

/// The key of a printable character: a letter, a digit or a mark.
[[nodiscard]] constexpr Key key_of(char character) {
  return static_cast<Key>(static_cast<unsigned char>(character));
}

/// A key with the modifiers that are held; Alt and Super are not used.
struct KeyPress {
  Key key = Key::none;
  bool shift = false;
  bool control = false;

  [[nodiscard]] bool operator==(const KeyPress&) const = default;
};

/// The press as a help text writes it: "Ctrl+Left", "R", "Space".
[[nodiscard]] std::string name(const KeyPress& press);

}  // namespace soms::view
