/// \file
/// The options of a verb as a list, and how a command line fills what they set.
#pragma once

#include "apps/cli/option.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// What a parsed command line left.
struct ParsedWords {
  bool wants_help = false;
  /// Words that no option took: options that do not exist, and arguments too many.
  std::vector<std::string> rest;
  /// What is wrong with the words, in one line; empty if nothing is.
  std::string fault;
  /// The keys of a list with their meanings, if `LIST help` asks for them.
  std::string keys;
  /// About old forms of options, a sentence each.
  std::vector<std::string> remarks;
};

/// The options of a verb, in the order in which --help lists them and in which they are heeded. The
/// only source that knows the library behind it is cli11.cpp (docs/decisions/0086).
class Parser {
 public:
  /// `name` is that of usage lines, such as "soms ray"; `question` the first line of the help.
  Parser(std::string question, std::string name);

  /// An option of one word.
  Option* add_option(const std::string& names, std::string& target, const std::string& meaning);

  /// The same; an empty word leaves it as it is.
  Option* add_option(const std::string& names, std::optional<std::string>& target,
                     const std::string& meaning);

  /// An option that takes all words that follow, or the arguments that are left.
  Option* add_option(const std::string& names, std::vector<std::string>& target,
                     const std::string& meaning);

  /// An option of one word that `set` takes.
  Option* add_option_function(const std::string& names,
                              std::function<void(const std::string& word)> set,
                              const std::string& meaning);

  /// The same, as often as it is given. What follows the word is no second one.
  Option* add_each_time(const std::string& names, std::function<void(const std::string& word)> set,
                        const std::string& meaning);

  /// An option without a word.
  Option* add_flag(const std::string& names, bool& target, const std::string& meaning);

  /// The same; it calls `set`.
  Option* add_flag_callback(const std::string& names, std::function<void()> set,
                            const std::string& meaning);

  /// A list of keys with values: `--tree rule=soms,leaf=1`. Its keys are options of this parser
  /// (`Option::key_of`).
  Option* add_list(const std::string& name, const std::string& meaning);

  /// The option that prints the help.
  Option* add_help(const std::string& names, const std::string& meaning);

  /// What the help says below the options.
  void footer(std::string text) { footer_ = std::move(text); }

  [[nodiscard]] const std::string& name() const { return name_; }

  [[nodiscard]] const std::string& question() const { return question_; }

  [[nodiscard]] const std::string& footer() const { return footer_; }

  [[nodiscard]] std::vector<const Option*> options() const;

  /// By any of its names. \pre There is one.
  [[nodiscard]] Option* option(std::string_view name);
  [[nodiscard]] const Option* option(std::string_view name) const;

  [[nodiscard]] bool has_option(std::string_view name) const;

  /// How often the last parsed command line has an option. \pre There is one of this name.
  [[nodiscard]] std::size_t count(std::string_view name) const { return option(name)->count(); }

  void remove_option(const Option* option);

  /// Sets what the words say. \errors Those of what the options call; ErrorKind::usage for an
  /// option with too many words, or too few.
  ParsedWords parse(const std::vector<std::string>& words);

  /// The text of --help: without the shared options, which it only names.
  [[nodiscard]] std::string help() const;

  /// "Keys of --tree:" and their meanings; empty if no option is a list.
  [[nodiscard]] std::string keys() const;

  /// Names and meanings of the options under a heading, a line each.
  [[nodiscard]] std::string lines_of(std::string_view group) const;

  /// A message about options, with keys of lists as they are written: `--leaf` as `--tree leaf`.
  [[nodiscard]] std::string with_keys(std::string text) const;

 private:
  /// The library's parser, with these options; in cli11.cpp.
  class Built;
  /// Words with the keys of lists as options of their own; in option_lists.cpp.
  class Expanded;

  [[nodiscard]] Option* found(std::string_view name) const;
  [[nodiscard]] std::vector<const Option*> keys_of(const Option* list) const;
  Option* add(const std::string& names, Takes takes, const std::string& meaning, Option::Set set);

  std::string question_;
  std::string name_;
  std::string footer_;
  std::vector<std::unique_ptr<Option>> options_;
};

}  // namespace soms::command
