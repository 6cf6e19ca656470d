// Numbers of options: what is taken is what the C library reads there, all else is a usage error.
#include "apps/cli/parse.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace soms::command {
namespace {

using fuzz::require;

/// What `parse` gives, or nothing where it refuses.
template <class Parse>
auto outcome(const Parse& parse) -> std::optional<decltype(parse())> {
  try {
    return parse();
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::usage, "the kind of an option's error");
    require(error.place().find("--option") == 0 && !error.remedy().empty(), "an option's error");
    return std::nullopt;
  }
}

/// Digits alone, as a number of 64 bits.
std::optional<std::uint64_t> digits(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) {
    return std::nullopt;
  }
  errno = 0;
  const std::uint64_t value = std::strtoull(std::string(text).c_str(), nullptr, 10);
  return errno == 0 ? std::optional(value) : std::nullopt;
}

void check_count(std::string_view text, std::uint64_t least, std::uint64_t most) {
  const auto found = outcome([&] { return parse_count("--option", text, least, most); });
  std::optional<std::uint64_t> expected = digits(text);
  if (expected && (*expected < least || *expected > most)) {
    expected.reset();
  }
  require(found == expected, "a count");
}

void check_number(const std::string& text) {
  const auto found = outcome([&] { return parse_number("--option", text); });
  if (!found) {
    return;
  }
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  require(std::isfinite(*found) && *found == expected && end == text.c_str() + text.size(),
          "a number");
}

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

void check_bytes(std::string_view text) {
  constexpr std::string_view kUnits = "KMGT";
  const auto found = outcome([&] { return parse_bytes("--option", text); });
  const std::size_t behind = std::min(text.find_first_not_of("0123456789"), text.size());
  std::optional<std::uint64_t> expected = digits(text.substr(0, behind));
  if (behind < text.size()) {
    const std::size_t unit = kUnits.find(upper(text[behind]));
    std::string rest(text.substr(behind + 1));
    std::transform(rest.begin(), rest.end(), rest.begin(), upper);
    const bool known =
        unit != std::string_view::npos && (rest.empty() || rest == "B" || rest == "IB");
    for (std::size_t power = 0; expected && power <= unit; ++power) {
      const bool fits = known && *expected <= std::numeric_limits<std::uint64_t>::max() / 1024;
      expected = fits ? std::optional(*expected * 1024) : std::nullopt;
    }
  }
  if (expected == 0) {
    expected.reset();
  }
  require(found == expected, "a number of bytes");
}

void check_choice(std::string_view text) {
  const Choices<int> choices = {{"all", 1}, {"any", 2}, {"first", 3}};
  const auto found = outcome([&] { return parse_choice("--option", text, choices); });
  const int expected = text == "all" ? 1 : text == "any" ? 2 : text == "first" ? 3 : 0;
  require(found.value_or(0) == expected, "a choice");
}

}  // namespace
}  // namespace soms::command

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace soms::command;
  soms::fuzz::Bytes bytes({data, size});
  const std::uint64_t least = bytes.below(8);
  const std::uint64_t most = bytes.below(2) == 0 ? 1000 : std::numeric_limits<std::uint64_t>::max();
  const std::string text(bytes.rest());
  check_count(text, least, most);
  check_number(text);
  check_bytes(text);
  check_choice(text);
  return 0;
}
