#include "apps/report/asset.h"

#include <gtest/gtest.h>

#include <string>

namespace soms::report {

namespace {

std::string whole_script() {
  std::string text;
  for (const std::string_view piece : script()) {
    text += piece;
  }
  return text;
}

TEST(Asset, HoldsTheScriptWithItsLicenceAndHowItIsMade) {
  const std::string text = whole_script();
  EXPECT_GT(text.size(), 300'000U);
  for (const char* words : {"npm ci && npm run build", "three.js", "MIT", "Three.js Authors"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
}

TEST(Asset, NeverEndsItsElement) {
  const std::string text = whole_script();
  EXPECT_EQ(text.find("</script"), std::string::npos);
  EXPECT_EQ(text.find("<!--"), std::string::npos);
  for (const char c : text) {
    ASSERT_GE(c, 0) << "not ASCII";
  }
}

}  // namespace

}  // namespace soms::report
