#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <bit>

namespace soms::test {

std::string element(std::string_view page, std::string_view id) {
  const std::string mark = "id=\"soms-" + std::string(id) + "\">";
  const std::size_t at = page.find(mark);
  EXPECT_NE(at, std::string_view::npos) << id;
  if (at == std::string_view::npos) {
    return "";
  }
  EXPECT_EQ(page.find(mark, at + 1), std::string_view::npos) << id;
  const std::size_t begin = at + mark.size();
  return std::string(page.substr(begin, page.find("</script", begin) - begin));
}

std::vector<std::uint8_t> bytes_of(std::string_view base64) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_EQ(base64.size() % 4, 0U);
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) {
      EXPECT_EQ(c, '=');
      continue;
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::uint8_t>((bits >> held) & 0xffU));
    }
  }
  return bytes;
}

std::vector<std::uint32_t> words_of(std::string_view base64) {
  const std::vector<std::uint8_t> bytes = bytes_of(base64);
  EXPECT_EQ(bytes.size() % 4, 0U);
  std::vector<std::uint32_t> words(bytes.size() / 4, 0);
  for (std::size_t k = 0; k < 4 * words.size(); ++k) {
    words[k / 4] |= std::uint32_t{bytes[k]} << (8 * (k % 4));
  }
  return words;
}

std::vector<float> floats_of(std::string_view base64) {
  std::vector<float> floats;
  for (const std::uint32_t word : words_of(base64)) {
    floats.push_back(std::bit_cast<float>(word));
  }
  return floats;
}

nlohmann::json scene_of(std::string_view page) {
  return nlohmann::json::parse(element(page, "scene"));
}

}  // namespace soms::test
