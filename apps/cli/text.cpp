#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::command {

namespace {

constexpr std::ptrdiff_t kDigits = 9;

}  // namespace

std::string with_commas(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) {
    digits.insert(i - 3, 1, ',');
  }
  return digits;
}

std::string readable(double number) {
  if (number == 0) {
    return "0";  // without the sign that a zero may have
  }
  const std::string whole = fmt::format("{}", number);
  const std::string mantissa = whole.substr(0, whole.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return '0' <= c && c <= '9'; });
  return digits <= kDigits ? whole : fmt::format("{:.{}g}", number, kDigits);
}

std::string four_digits(double number) {
  return fmt::format("{:.4g}", number);
}

std::string point_in_text(const Vec3& point) {
  return fmt::format("({}, {}, {})", readable(point.x), readable(point.y), readable(point.z));
}

std::string table_line(std::string_view cells) {
  return std::string(cells.substr(0, cells.find_last_not_of(' ') + 1)) + "\n";
}

std::string counted(std::uint64_t number, const std::string& noun) {
  return with_commas(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace soms::command
