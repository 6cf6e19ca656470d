#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soms::command {

std::string with_commas(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) {
    digits.insert(i - 3, 1, ',');
  }
  return digits;
}

std::string readable(double number, int most) {
  if (number == 0) {
    return "0";  // without the sign that a zero may have
  }
  const std::string whole = fmt::format("{}", number);
  const std::string mantissa = whole.substr(0, whole.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return '0' <= c && c <= '9'; });
  if (digits <= most) {
    return whole;
  }
  // Few digits are no excuse to round away what stands before the point, and two digits behind it.
  const bool few = most < 9 && std::abs(number) < 1e12;
  const int before = few ? static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1 : 0;
  return fmt::format("{:.{}g}", number, std::max(most, before + (before > 0 ? 2 : 0)));
}

std::string four_digits(double number) {
  return fmt::format("{:.4g}", number);
}

std::string point_in_text(const Vec3& point, int digits) {
  return fmt::format("({}, {}, {})", readable(point.x, digits), readable(point.y, digits),
                     readable(point.z, digits));
}

std::string table_line(std::string_view cells) {
  return std::string(cells.substr(0, cells.find_last_not_of(' ') + 1)) + "\n";
}

std::string counted(std::uint64_t number, const std::string& noun) {
  return with_commas(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace soms::command
