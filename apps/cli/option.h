/// \file
/// An option of a verb, or an argument, as data: its names, what it means, and what its words set.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The words that belong to an option each time it is given.
enum class Takes : unsigned char {
  nothing,        ///< a flag
  help,           ///< nothing, and the verb prints its help instead of answering
  one,            ///< one word; the option is given once
  one_each_time,  ///< one word, as often as the option is given
  several         ///< all words that follow
};

/// An option or an argument (which has no dashes). Setters return the option itself, so that they
/// can be chained.
class Option {
 public:
  /// Gets the words of the command line that belong to the option.
  using Set = std::function<void(const std::vector<std::string>& words)>;
  /// Says what is wrong with a word; nothing if it is right.
  using Check = std::function<std::string(const std::string& word)>;

  /// A name of an earlier release. It works for one release more, with a remark.
  struct OldName {
    std::string name;
    std::function<bool(const std::string& value)> fits;  ///< no function: any value
  };

  /// `names` are separated by commas: "-o,--output", or "FILE" for an argument.
  Option(const std::string& names, Takes takes, std::string meaning);

  /// Heading under which --help lists it.
  Option* group(std::string heading);
  /// What stands for its value in --help: "FILE".
  Option* option_text(std::string text);
  /// What --help says of it.
  Option* description(std::string meaning);
  /// The same but for the words of which its value is one, which stay.
  Option* purpose(const std::string& meaning);
  /// The command line must have it.
  Option* required();
  /// It cannot stand beside `other`.
  Option* excludes(const Option* other);
  /// Its word must pass this check.
  Option* check(Check check);
  /// It is a key of a list, `--tree rule=soms`. --help shows the list alone; its own name is the
  /// old form, which still works.
  Option* key_of(const Option* list);
  /// `name` ("--within") had its meaning in an earlier release. Where another option has that name
  /// today, `fits` tells the values that are meant for this one. --help does not show it.
  Option* old_name(std::string name, std::function<bool(const std::string& value)> fits = {});
  /// It is an old name that still works, and stands neither in --help nor in man pages. `form` is
  /// what replaces it: "-o FILE.csv".
  Option* old_name_of(std::string form);
  /// --help shows it on the line of `first`, which then has this meaning.
  Option* shown_with(Option* first, std::string meaning);
  /// The words of which its value is one.
  Option* choices(std::vector<std::string> words);

  /// The first name with two dashes; else the first with one; else the name of the argument.
  [[nodiscard]] std::string name() const;

  /// Names with two dashes, then those with one; none of an argument.
  [[nodiscard]] std::vector<std::string> dashed_names() const;

  /// The names as they were given.
  [[nodiscard]] const std::string& names() const { return names_; }

  /// True of "output", "--output", "-o" and the name of an argument.
  [[nodiscard]] bool is_named(std::string_view name) const;

  [[nodiscard]] bool is_argument() const { return dashed_names().empty(); }

  [[nodiscard]] Takes takes() const { return takes_; }

  [[nodiscard]] bool has_value() const { return takes_ != Takes::nothing && takes_ != Takes::help; }

  [[nodiscard]] const std::string& group() const { return group_; }

  [[nodiscard]] const std::string& option_text() const { return option_text_; }

  [[nodiscard]] const std::string& description() const { return description_; }

  [[nodiscard]] bool is_required() const { return required_; }

  [[nodiscard]] const std::vector<const Option*>& excluded() const { return excluded_; }

  [[nodiscard]] const Check& check() const { return check_; }

  /// The list that it is a key of; nullptr for most options.
  [[nodiscard]] const Option* list() const { return list_; }

  [[nodiscard]] const std::vector<OldName>& old_names() const { return old_names_; }

  [[nodiscard]] bool is_old_name() const { return !replaced_by_.empty(); }

  /// What is written in place of its own name: "-o FILE.csv" of an old name, "--tree rule=NAME" of
  /// a key; empty for most options.
  [[nodiscard]] std::string new_form() const;

  [[nodiscard]] const std::vector<std::string>& choices() const { return choices_; }

  /// The option on whose line --help shows it; nullptr for most options.
  [[nodiscard]] const Option* shown_on() const { return first_; }

  /// What --help says of it, and of the options on its line.
  [[nodiscard]] const std::string& shown_meaning() const {
    return shown_meaning_.empty() ? description_ : shown_meaning_;
  }

  /// The words that the last parsed command line gave it.
  [[nodiscard]] const std::vector<std::string>& results() const { return results_; }

  /// How often the last parsed command line has it, or the number of its words.
  [[nodiscard]] std::size_t count() const { return results_.size(); }

 private:
  friend class Parser;

  std::string names_;
  std::string group_ = "Options";
  std::string option_text_;
  std::string description_;
  std::vector<const Option*> excluded_;
  std::vector<std::string> choices_;
  std::vector<OldName> old_names_;
  Check check_;
  std::string replaced_by_;  ///< of an old name
  const Option* list_ = nullptr;
  const Option* first_ = nullptr;  ///< on whose line --help shows it
  std::string shown_meaning_;      ///< in --help, if others are shown on its line
  Set set_;                        ///< of an option with a value
  bool* flag_ = nullptr;           ///< of a flag with a target
  std::vector<std::string> results_;
  Takes takes_;
  bool required_ = false;
};

}  // namespace soms::command
