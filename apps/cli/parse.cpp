#include "apps/cli/parse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

namespace soms::command {

namespace {

Error not_this(std::string_view option, std::string_view text, std::string remedy) {
  return Error(ErrorKind::usage, fmt::format("{} {}", option, text), std::move(remedy));
}

/// The number at the start of `text`, and what follows it.
template <class T>
std::optional<std::pair<T, std::string_view>> leading_number(std::string_view text) {
  T value{};
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if constexpr (std::is_floating_point_v<T>) {
    if (error == std::errc::result_out_of_range) {
      value = std::strtod(std::string(text).c_str(), nullptr);  // 0 where it is too small
    } else if (error != std::errc()) {
      return std::nullopt;
    }
  } else if (error != std::errc()) {
    return std::nullopt;
  }
  return std::pair(value, text.substr(static_cast<std::size_t>(end - text.data())));
}

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    c = 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return upper;
}

/// Adds an option that is a finite number for which `fits` holds; where it does not, the error has
/// this remedy.
template <class Target>
Option* add_number(Parser& parser, const std::string& name, Target& target, const std::string& text,
                   bool (*fits)(double), const char* remedy) {
  return parser.add_option_function(
      name,
      [name, &target, fits, remedy](const std::string& value) {
        const double number = parse_number(name, value);
        if (!fits(number)) {
          throw not_this(name, value, remedy);
        }
        target = number;
      },
      text);
}

}  // namespace

std::uint64_t parse_count(std::string_view option, std::string_view text, std::uint64_t least,
                          std::uint64_t most) {
  const auto number = leading_number<std::uint64_t>(text);
  if (!number || !number->second.empty() || number->first < least || number->first > most) {
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
    const std::string range = most == std::numeric_limits<std::uint64_t>::max() && !digits
                                  ? fmt::format("of at least {}", least)
                                  : fmt::format("from {} to {}", least, most);
    throw not_this(option, text, fmt::format("give a whole number {}", range));
  }
  return number->first;
}

double parse_number(std::string_view option, std::string_view text) {
  auto number = leading_number<double>(text);
  if (number && std::abs(number->first) == 0) {
    number->first = 0;  // of either sign
  }
  if (!number || !number->second.empty() || !std::isfinite(number->first)) {
    const bool comma = text.find(',') != text.npos && text.find('.') == text.npos;
    throw not_this(
        option, text,
        comma ? "give a finite number, with a decimal point, not a comma" : "give a finite number");
  }
  return number->first;
}

double parse_positive(std::string_view option, std::string_view text) {
  const double number = parse_number(option, text);
  if (!(number > 0)) {
    throw not_this(option, text, "give a number greater than 0");
  }
  return number;
}

Vec3 parse_point(std::string_view option, std::string_view text) {
  std::vector<double> numbers;
  const std::string_view between = ", ";
  for (std::size_t at = text.find_first_not_of(between); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    numbers.push_back(parse_number(option, text.substr(at, end - at)));
    at = text.find_first_not_of(between, end);
  }
  if (numbers.size() != 3) {
    throw not_this(option, text, "give three numbers, such as 10,20,1.7");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::uint64_t parse_bytes(std::string_view option, std::string_view text) {
  constexpr std::string_view kUnits = "KMGT";
  const auto number = leading_number<std::uint64_t>(text);
  std::size_t power = 0;
  bool good = number && number->first > 0;
  if (good && !number->second.empty()) {
    const std::string unit = upper_case(number->second);
    const std::string_view rest = std::string_view(unit).substr(1);
    power = kUnits.find(unit[0]) + 1;
    good = power != 0 && (rest.empty() || rest == "B" || rest == "IB");  // npos + 1 is 0
  }
  if (!good || number->first > (std::numeric_limits<std::uint64_t>::max() >> (10 * power))) {
    throw not_this(option, text,
                   "give a number of bytes, or a size such as 500M, with K, M, G or T");
  }
  return number->first << (10 * power);
}

Option* add_positive(Parser& parser, const std::string& name, double& target,
                     const std::string& text) {
  return parser
      .add_option_function(
          name, [name, &target](const std::string& value) { target = parse_positive(name, value); },
          text)
      ->option_text("X");
}

Option* add_length(Parser& parser, const std::string& name, double& target,
                   const std::string& text) {
  return add_number(
             parser, name, target, text, [](double x) { return x >= 0; },
             "give a length of 0 or more")
      ->option_text("D");
}

Option* add_seconds(Parser& parser, const std::string& name, std::optional<double>& target,
                    const std::string& text) {
  return add_number(
             parser, name, target, text, [](double x) { return x >= 0 && x <= 1e9; },
             "give a number of seconds from 0 to 1e9")
      ->option_text("SECONDS");
}

Option* add_level(Parser& parser, const std::string& name, std::optional<double>& target,
                  const std::string& text) {
  return add_number(
             parser, name, target, text, [](double x) { return x >= 0 && x <= 100; },
             "give a level of detail, as in --lod 1.2")
      ->option_text("LEVEL");
}

Option* add_bytes(Parser& parser, const std::string& name, std::uint64_t& target,
                  const std::string& text) {
  return parser
      .add_option_function(
          name, [name, &target](const std::string& value) { target = parse_bytes(name, value); },
          text)
      ->option_text("SIZE");
}

Option* add_output(Parser& parser, const std::string& name, std::string& target,
                   const std::string& text, const std::string& kind) {
  return parser
      .add_option_function(
          name,
          [name, &target](const std::string& value) {
            if (value.empty()) {
              const std::string own = name.substr(name.find(',') + 1);  // npos + 1 is 0
              throw Error(ErrorKind::usage, own + ": the name is empty",
                          "give a name, or leave it out");
            }
            target = value;
          },
          text)
      ->option_text(kind);
}

Option* add_repeatable(Parser& parser, const std::string& name, std::vector<std::string>& target,
                       const std::string& text, const std::string& kind) {
  return parser
      .add_each_time(
          name, [&target](const std::string& word) { target.push_back(word); }, text)
      ->option_text(kind);
}

bool has_comma(const std::string& value) {
  return value.find(',') != std::string::npos;
}

std::string word_list(const std::vector<std::string>& words) {
  constexpr std::size_t kWidth = 64;
  std::string text;
  std::size_t begin = 0;
  for (const std::string& word : words) {
    if (text.size() - begin + word.size() > kWidth) {
      text += "|\n";
      begin = text.size();
    } else if (!text.empty()) {
      text += "|";
    }
    text += word;
  }
  return text;
}

Error unknown_choice(std::string_view option, std::string_view word,
                     const std::vector<std::string>& names) {
  const std::string near = nearest_words(word, names);
  return not_this(
      option, word,
      fmt::format("{}choose one of {}", near.empty() ? "" : fmt::format("did you mean {}? ", near),
                  fmt::join(names, ", ")));
}

}  // namespace soms::command
