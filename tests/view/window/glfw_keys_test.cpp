#include "apps/view/window/glfw_keys.h"

#include "apps/view/control/action.h"
#include "apps/view/window/glfw_input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace soms::view {
namespace {

TEST(GlfwKeys, EveryKeyOfTheTableOfActionsIsOnTheKeyboard) {
  std::vector<Key> known;
  for (int key = 0; key <= GLFW_KEY_LAST; ++key) {
    known.push_back(key_of_glfw(key, nullptr));
  }
  for (const ActionRow& row : actions()) {
    EXPECT_NE(std::find(known.begin(), known.end(), row.press.key), known.end()) << name(row.press);
  }
}

TEST(GlfwKeys, LettersFollowTheLayout) {
  EXPECT_EQ(key_of_glfw(GLFW_KEY_Q, "a"), key_of('A'));  // a French keyboard
  EXPECT_EQ(key_of_glfw(GLFW_KEY_Q, nullptr), key_of('Q'));
  EXPECT_EQ(key_of_glfw(GLFW_KEY_1, "&"), key_of('1'));
  EXPECT_EQ(key_of_glfw(GLFW_KEY_Z, "Z"), key_of('Z'));
}

TEST(GlfwKeys, MarksFollowTheLayout) {
  // A German keyboard, which has brackets with AltGr only: they are where they are on a US one.
  EXPECT_EQ(key_of_glfw(GLFW_KEY_SLASH, "-"), Key::minus);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_LEFT_BRACKET, "\xc3\xbc"), Key::left_bracket);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_RIGHT_BRACKET, "+"), Key::right_bracket);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_M, ","), Key::comma);  // a French one, where this was M
  EXPECT_EQ(key_of_glfw(GLFW_KEY_6, "-"), Key::minus);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_E, "."), Key::period);  // Dvorak, where this was E
  EXPECT_EQ(key_of_glfw(GLFW_KEY_EQUAL, "]"), Key::right_bracket);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_COMMA, ","), Key::comma);
}

TEST(GlfwKeys, EveryMarkOfTheTableOfActionsFollowsTheLayout) {
  for (const ActionRow& row : actions()) {
    const auto mark = static_cast<int>(row.press.key);
    if (mark > ' ' && mark < 128 && std::isalnum(mark) == 0) {
      const std::string label(1, static_cast<char>(mark));
      EXPECT_EQ(key_of_glfw(GLFW_KEY_WORLD_1, label.c_str()), row.press.key) << label;
    }
  }
}

TEST(GlfwKeys, TheNumberPadIsTheMainField) {
  EXPECT_EQ(key_of_glfw(GLFW_KEY_KP_DECIMAL, ","), Key::period);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_KP_7, "7"), key_of('7'));
  EXPECT_EQ(key_of_glfw(GLFW_KEY_KP_ADD, "+"), Key::equal);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_KP_ENTER, nullptr), Key::enter);
}

TEST(GlfwKeys, UnknownKeysAreNone) {
  EXPECT_EQ(key_of_glfw(GLFW_KEY_PRINT_SCREEN, nullptr), Key::none);
  EXPECT_EQ(key_of_glfw(GLFW_KEY_UNKNOWN, nullptr), Key::none);
}

TEST(GlfwKeys, ModifiersAreTaken) {
  EXPECT_EQ(press_of_glfw(Key::left, GLFW_MOD_CONTROL), (KeyPress{Key::left, false, true}));
  EXPECT_EQ(press_of_glfw(Key::left, GLFW_MOD_SHIFT | GLFW_MOD_NUM_LOCK),
            (KeyPress{Key::left, true, false}));
}

}  // namespace
}  // namespace soms::view
