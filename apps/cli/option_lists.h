/// \file
/// Lists of keys with values among the words of a command line.
#pragma once

#include "apps/cli/parser.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Takes the lists of a parser apart.
class Parser::Expanded {
 public:
  /// \errors ErrorKind::usage for an unknown key, and for one without a value.
  Expanded(const Parser& parser, const std::vector<std::string>& words);

  /// The words; each key as an option of its own.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

  /// About keys that are given as options.
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

  /// What `LIST help` asks for; empty if nothing does.
  [[nodiscard]] const std::string& keys() const { return keys_; }

 private:
  void add_list(const Option& list, std::string_view text);
  void add_key(const Option& list, std::string_view item);
  void add_word(const std::string& word);
  [[nodiscard]] std::string meanings_of(const Option& list) const;

  const Parser& parser_;
  std::vector<std::string> words_;
  std::vector<std::string> remarks_;
  std::string keys_;
};

}  // namespace soms::command
