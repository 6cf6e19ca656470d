#include "apps/view/window/glfw_keys.h"

#include "apps/view/control/action.h"
#include "apps/view/window/glfw_input.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(GlfwKeys, TheNumberPadIsTheMainField) {
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
