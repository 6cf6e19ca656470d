#include "apps/view/control/keys.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(Keys, AreNamedAsHelpTextsWriteThem) {
  EXPECT_EQ(name(KeyPress{key_of('R')}), "R");
  EXPECT_EQ(name(KeyPress{key_of('R'), true, false}), "Shift+R");
  EXPECT_EQ(name(KeyPress{Key::left, false, true}), "Ctrl+Left");
  EXPECT_EQ(name(KeyPress{Key::space}), "Space");
  EXPECT_EQ(name(KeyPress{Key::f12}), "F12");
  EXPECT_EQ(name(KeyPress{Key::left_bracket}), "[");
}

}  // namespace
}  // namespace soms::view
