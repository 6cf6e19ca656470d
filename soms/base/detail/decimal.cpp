#include "soms/base/detail/decimal.h"

#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace soms::detail {

namespace {

/// The host's mark between whole and fraction, which strtod reads and printf writes.
char host_point() {
  const std::lconv* const names = std::localeconv();
  return names != nullptr && *names->decimal_point != '\0' ? *names->decimal_point : '.';
}

char* print(char* begin, char* end, const char* format, int digits, double value) {
  const auto room = static_cast<std::size_t>(end - begin);
  const int size = std::snprintf(begin, room, format, digits, value);
  char* const stop = begin + std::min<std::size_t>(static_cast<std::size_t>(size), room - 1);
  std::replace(begin, stop, host_point(), '.');
  return stop;
}

void parse(const std::string& text, double& value) {
  value = std::strtod(text.c_str(), nullptr);
}

void parse(const std::string& text, float& value) {
  value = std::strtof(text.c_str(), nullptr);
}

template <class Real>
Real parsed(std::string text) {
  std::replace(text.begin(), text.end(), '.', host_point());
  Real value = 0;
  parse(text, value);
  return value;
}

/// A number's digits, the first of them before the point, times 10^exponent.
struct Digits {
  std::string digits;
  int exponent = 0;

  [[nodiscard]] std::string text() const {
    return digits.substr(0, 1) + "." + digits.substr(1) + "e" + std::to_string(exponent);
  }
};

Digits rounded_digits(double magnitude, int count) {
  std::array<char, 40> text;
  char* const end = print(text.data(), text.data() + text.size(), "%.*e", count - 1, magnitude);
  char* const e = std::find(text.data(), end, 'e');
  Digits result{std::string(text.data(), e), std::atoi(e + 1)};
  result.digits.erase(std::remove(result.digits.begin(), result.digits.end(), '.'),
                      result.digits.end());
  return result;
}

/// The next larger number of as many digits.
Digits raised(Digits from) {
  std::size_t i = from.digits.size();
  while (i > 0 && from.digits[i - 1] == '9') {
    from.digits[--i] = '0';
  }
  if (i == 0) {
    from.digits.insert(0, 1, '1');
    from.digits.pop_back();
    ++from.exponent;
  } else {
    ++from.digits[i - 1];
  }
  return from;
}

/// The fewest digits from which the same number is read. Of so many, the nearest ones are taken;
/// next to a power of two, whose lower neighbor is nearer than its upper one, those above them may
/// be read back where they are not.
template <class Real>
Digits fewest_digits(Real magnitude) {
  for (int count = 1; count < std::numeric_limits<Real>::max_digits10; ++count) {
    const Digits nearest = rounded_digits(magnitude, count);
    for (const Digits& tried : {nearest, raised(nearest)}) {
      if (parsed<Real>(tried.text()) == magnitude) {
        return tried;
      }
    }
  }
  return rounded_digits(magnitude, std::numeric_limits<Real>::max_digits10);
}

/// Scientific if that is shorter, else without an exponent.
std::string layout(const Digits& number, double magnitude) {
  const auto count = static_cast<int>(number.digits.size());
  const int exponent = number.exponent;
  const int scientific = count + (count > 1 ? 1 : 0) + (std::abs(exponent) > 99 ? 5 : 4);
  const int fixed = exponent < 0 ? count + 1 - exponent : std::max(exponent + 1, count + 1);
  if (exponent >= count - 1 ? exponent + 1 <= scientific : fixed <= scientific) {
    if (exponent >= count - 1) {
      std::array<char, 40> text;
      char* const end = print(text.data(), text.data() + text.size(), "%.*f", 0, magnitude);
      return std::string(text.data(), end);
    }
    if (exponent < 0) {
      return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + number.digits;
    }
    std::string text = number.digits;
    return text.insert(static_cast<std::size_t>(exponent) + 1, 1, '.');
  }
  std::string text = number.digits;
  if (count > 1) {
    text.insert(1, 1, '.');
  }
  const std::string power = std::to_string(std::abs(exponent));
  return text + (exponent < 0 ? "e-" : "e+") + (power.size() < 2 ? "0" : "") + power;
}

template <class Real>
char* write_any(char* begin, Real value) {
  std::string text = std::signbit(value) ? "-" : "";
  const Real magnitude = std::abs(value);
  if (std::isnan(value)) {
    text += "nan";
  } else if (std::isinf(value)) {
    text += "inf";
  } else if (value == 0) {
    text += "0";
  } else {
    text += layout(fewest_digits(magnitude), magnitude);
  }
  return std::copy(text.begin(), text.end(), begin);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The end of `word`, in letters of any size, at `begin`; `begin` where it is not there.
const char* behind_word(const char* begin, const char* end, std::string_view word) {
  const char* p = begin;
  for (const char letter : word) {
    if (p == end || (*p | 0x20) != letter) {
      return begin;
    }
    ++p;
  }
  return p;
}

/// The end of the words for what is no finite number; `begin` where there are none.
const char* behind_name(const char* begin, const char* end) {
  const char* p = behind_word(begin, end, "nan");
  if (p != begin) {
    return p;
  }
  p = behind_word(begin, end, "infinity");
  return p != begin ? p : behind_word(begin, end, "inf");
}

/// The end of digits with a point and an exponent; `begin` where there are none.
const char* behind_digits(const char* begin, const char* end) {
  const char* p = begin;
  int digits = 0;
  bool point = false;
  for (; p != end && (is_digit(*p) || (*p == '.' && !point)); ++p) {
    point = point || *p == '.';
    digits += *p == '.' || digits > 0 ? 0 : 1;
  }
  if (digits == 0) {
    return begin;
  }
  if (p != end && (*p == 'e' || *p == 'E')) {
    const char* power = p + 1;
    power += power != end && (*power == '-' || *power == '+') ? 1 : 0;
    if (power != end && is_digit(*power)) {
      p = std::find_if_not(power, end, is_digit);
    }
  }
  return p;
}

template <class Real>
std::from_chars_result read_any(const char* begin, const char* end, Real& value) {
  const char* const number = begin != end && *begin == '-' ? begin + 1 : begin;
  const char* stop = behind_name(number, end);
  if (stop != number) {
    const bool nan = (*number | 0x20) == 'n';
    const Real magnitude =
        nan ? std::numeric_limits<Real>::quiet_NaN() : std::numeric_limits<Real>::infinity();
    value = number == begin ? magnitude : -magnitude;
    return {stop, std::errc()};
  }
  stop = behind_digits(number, end);
  if (stop == number) {
    return {begin, std::errc::invalid_argument};
  }
  const auto found = parsed<Real>(std::string(begin, stop));
  const char* const mantissa_end =
      std::find_if(number, stop, [](char c) { return c == 'e' || c == 'E'; });
  const bool zero = std::all_of(number, mantissa_end, [](char c) { return c == '0' || c == '.'; });
  if (std::isinf(found) || (found == 0 && !zero)) {
    return {stop, std::errc::result_out_of_range};
  }
  value = found;
  return {stop, std::errc()};
}

}  // namespace

char* write_shortest(char* begin, char* /*end*/, double value) {
  return write_any(begin, value);
}

char* write_shortest(char* begin, char* /*end*/, float value) {
  return write_any(begin, value);
}

char* write_fixed(char* begin, char* end, double value, int digits) {
  return print(begin, end, "%.*f", digits, value);
}

char* write_significant(char* begin, char* end, double value, int digits) {
  return print(begin, end, "%.*g", digits, value);
}

std::from_chars_result read_decimal(const char* begin, const char* end, double& value) {
  return read_any(begin, end, value);
}

std::from_chars_result read_decimal(const char* begin, const char* end, float& value) {
  return read_any(begin, end, value);
}

}  // namespace soms::detail
