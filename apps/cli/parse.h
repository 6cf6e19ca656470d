/// \file
/// Options with checked values: each error is one sentence that names the option.
#pragma once

#include "soms/base/error.h"
#include "soms/base/vector.h"

#include "apps/cli/parser.h"
#include "apps/cli/suggest.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::command {

/// A whole number in plain digits. \errors ErrorKind::usage naming `option` and the range.
[[nodiscard]] std::uint64_t parse_count(std::string_view option, std::string_view text,
                                        std::uint64_t least, std::uint64_t most);

/// A finite number. \errors ErrorKind::usage naming `option`.
[[nodiscard]] double parse_number(std::string_view option, std::string_view text);

/// A finite number greater than 0. \errors ErrorKind::usage naming `option`.
[[nodiscard]] double parse_positive(std::string_view option, std::string_view text);

/// Three finite numbers with commas or spaces between. \errors ErrorKind::usage naming `option`.
[[nodiscard]] Vec3 parse_point(std::string_view option, std::string_view text);

/// A size in bytes: digits, then nothing, K, M, G or T (powers of 1024; "B" or "iB" may follow), in
/// either case.
/// \errors ErrorKind::usage.
[[nodiscard]] std::uint64_t parse_bytes(std::string_view option, std::string_view text);

/// Adds an option that is a whole number from `least` to `most`.
template <class T>
Option* add_count(Parser& parser, const std::string& name, T& target, std::uint64_t least,
                  std::uint64_t most, const std::string& text) {
  return parser
      .add_option_function(
          name,
          [=, &target](const std::string& value) {
            target = static_cast<T>(parse_count(name, value, least, most));
          },
          text)
      ->option_text("N");
}

/// Adds an option that is a finite number greater than 0.
Option* add_positive(Parser& parser, const std::string& name, double& target,
                     const std::string& text);

/// Adds an option that is a finite length, 0 or more.
Option* add_length(Parser& parser, const std::string& name, double& target,
                   const std::string& text);

/// Adds an option that is a number of seconds, 0 or more.
Option* add_seconds(Parser& parser, const std::string& name, std::optional<double>& target,
                    const std::string& text);

/// Adds an option that is a level of detail, a number that is 0 or more.
Option* add_level(Parser& parser, const std::string& name, std::optional<double>& target,
                  const std::string& text);

/// Adds an option that is a size in bytes.
Option* add_bytes(Parser& parser, const std::string& name, std::uint64_t& target,
                  const std::string& text);

/// Adds an option that names what is written, `kind` of it ("FILE"). An empty name, as of a
/// variable that is not set, is an error: it would pass for an option that is not given.
Option* add_output(Parser& parser, const std::string& name, std::string& target,
                   const std::string& text, const std::string& kind = "FILE");

/// Adds an option that may be repeated and takes one value each time: what follows the value is no
/// second one.
Option* add_repeatable(Parser& parser, const std::string& name, std::vector<std::string>& target,
                       const std::string& text, const std::string& kind);

/// True of "A,B": tells pairs from patterns, for an option that had both (`Option::old_name`).
[[nodiscard]] bool has_comma(const std::string& value);

/// Names and the values they stand for.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// "one|two|three", on several lines if it is long.
[[nodiscard]] std::string word_list(const std::vector<std::string>& words);

/// What stands for the value of an option that is one of a few words.
inline constexpr const char* kChoiceText = "NAME";

/// The error of a word that is none of `names`: it lists them.
[[nodiscard]] Error unknown_choice(std::string_view option, std::string_view word,
                                   const std::vector<std::string>& names);

/// The value a word stands for. \errors ErrorKind::usage listing the names.
template <class T>
[[nodiscard]] T parse_choice(std::string_view option, std::string_view word,
                             const Choices<T>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == word) {
      return value;
    }
    names.push_back(name);
  }
  throw unknown_choice(option, word, names);
}

/// Adds an option that is one of a few words.
template <class T, class Target>
Option* add_choice(Parser& parser, const std::string& name, Target& target, Choices<T> choices,
                   const std::string& text) {
  std::vector<std::string> words;
  for (const auto& choice : choices) {
    words.push_back(choice.first);
  }
  return parser
      .add_option_function(
          name,
          [name, &target, choices = std::move(choices)](const std::string& value) {
            target = parse_choice(name, value, choices);
          },
          text + ": " + word_list(words))
      ->option_text(kChoiceText)
      ->choices(words);
}

}  // namespace soms::command
