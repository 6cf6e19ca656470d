#include "apps/report/asset.h"

#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::report {

namespace {

std::string whole(std::span<const std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) {
    text += piece;
  }
  return text;
}

TEST(Asset, HoldsTheScriptWithItsLicenceAndHowItIsMade) {
  const std::string text = whole(script());
  EXPECT_GT(text.size(), 300'000U);
  for (const char* words : {"npm ci && npm run build", "three.js", "MIT", "Three.js Authors"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
}

TEST(Asset, NeverEndsItsElement) {
  const std::string text = whole(script());
  EXPECT_EQ(text.find("</script"), std::string::npos);
  EXPECT_EQ(text.find("<!--"), std::string::npos);
  for (const char c : text) {
    ASSERT_GE(c, 0) << "not ASCII";
  }
}

TEST(Asset, HoldsAModulePackedByGzip) {
  const std::string text = whole(live_module());
  EXPECT_LT(text.size(), 250'000U);
  const std::vector<std::uint8_t> bytes = test::bytes_of(text);
  ASSERT_GT(bytes.size(), 100'000U);
  EXPECT_EQ(bytes[0], 0x1fU);
  EXPECT_EQ(bytes[1], 0x8bU);
}

}  // namespace

}  // namespace soms::report
