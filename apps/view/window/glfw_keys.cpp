#include "apps/view/window/glfw_keys.h"

#include "apps/view/window/glfw_input.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace soms::view {

namespace {

constexpr std::array<std::pair<int, Key>, 33> kNamed{{
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_INSERT, Key::insert},
    {GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_F1, Key::f1},
    {GLFW_KEY_F2, Key::f2},
    {GLFW_KEY_F3, Key::f3},
    {GLFW_KEY_F4, Key::f4},
    {GLFW_KEY_F5, Key::f5},
    {GLFW_KEY_F11, Key::f11},
    {GLFW_KEY_F12, Key::f12},
    {GLFW_KEY_KP_ADD, Key::equal},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_KP_DECIMAL, Key::period},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_COMMA, Key::comma},
    {GLFW_KEY_MINUS, Key::minus},
    {GLFW_KEY_PERIOD, Key::period},
    {GLFW_KEY_SLASH, Key::slash},
    {GLFW_KEY_EQUAL, Key::equal},
    {GLFW_KEY_LEFT_BRACKET, Key::left_bracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::right_bracket},
}};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Marks that are keys of actions, wherever a layout has them.
bool is_mark(char c) {
  constexpr std::string_view kMarks = ",-.=[]";
  return kMarks.find(c) != std::string_view::npos;
}

bool on_number_pad(int glfw_key) {
  return glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_EQUAL;
}

}  // namespace

Key key_of_glfw(int glfw_key, const char* layout_name) {
  const std::string_view label = layout_name == nullptr ? "" : layout_name;
  if (label.size() == 1 && is_letter(label[0])) {
    const char c = label[0];
    return key_of(c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c);
  }
  if (label.size() == 1 && is_mark(label[0]) && !on_number_pad(glfw_key)) {
    return key_of(label[0]);
  }
  if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) {
    return key_of(static_cast<char>('0' + (glfw_key - GLFW_KEY_0)));
  }
  if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_9) {
    return key_of(static_cast<char>('0' + (glfw_key - GLFW_KEY_KP_0)));
  }
  if (glfw_key >= GLFW_KEY_A && glfw_key <= GLFW_KEY_Z) {
    return key_of(static_cast<char>('A' + (glfw_key - GLFW_KEY_A)));
  }
  const auto* const named = std::find_if(
      kNamed.begin(), kNamed.end(), [&](const auto& entry) { return entry.first == glfw_key; });
  return named == kNamed.end() ? Key::none : named->second;
}

KeyPress press_of_glfw(Key key, int modifiers) {
  return {key, (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_CONTROL) != 0};
}

}  // namespace soms::view
