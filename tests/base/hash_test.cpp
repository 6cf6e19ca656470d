#include "soms/base/hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace soms {
namespace {

std::uint64_t hash_of(std::string_view text) {
  Fnv1a hash;
  for (const char c : text) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
  return hash.value();
}

// Published test vectors of FNV-1a 64.
TEST(Hash, MatchesPublishedVectors) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8ULL);
}

TEST(Hash, TakesNumbersAsLittleEndianBytes) {
  Fnv1a word;
  word.add(std::uint32_t{0x64636261});
  EXPECT_EQ(word.value(), hash_of("abcd"));
  Fnv1a wide;
  wide.add(std::uint64_t{0x6867666564636261});
  EXPECT_EQ(wide.value(), hash_of("abcdefgh"));
  Fnv1a real;
  real.add(1.0);
  Fnv1a bits;
  bits.add(std::uint64_t{0x3ff0000000000000});
  EXPECT_EQ(real.value(), bits.value());
}

}  // namespace
}  // namespace soms
