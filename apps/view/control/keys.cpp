#include "apps/view/control/keys.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace soms::view {

namespace {

constexpr std::array<std::pair<Key, std::string_view>, 22> kNames{{
    {Key::space, "Space"},
    {Key::escape, "Esc"},
    {Key::enter, "Enter"},
    {Key::tab, "Tab"},
    {Key::backspace, "Backspace"},
    {Key::insert, "Insert"},
    {Key::del, "Delete"},
    {Key::right, "Right"},
    {Key::left, "Left"},
    {Key::down, "Down"},
    {Key::up, "Up"},
    {Key::page_up, "PgUp"},
    {Key::page_down, "PgDn"},
    {Key::home, "Home"},
    {Key::end, "End"},
    {Key::f1, "F1"},
    {Key::f2, "F2"},
    {Key::f3, "F3"},
    {Key::f4, "F4"},
    {Key::f5, "F5"},
    {Key::f11, "F11"},
    {Key::f12, "F12"},
}};

}  // namespace

std::string name(const KeyPress& press) {
  std::string text;
  if (press.control) {
    text += "Ctrl+";
  }
  if (press.shift) {
    text += "Shift+";
  }
  const auto* const named = std::find_if(
      kNames.begin(), kNames.end(), [&](const auto& entry) { return entry.first == press.key; });
  if (named != kNames.end()) {
    return text.append(named->second);
  }
  return text + static_cast<char>(press.key);
}

}  // namespace soms::view
