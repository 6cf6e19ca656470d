/// \file
/// Lists of keys with values, and old names of options, among the words of a command line.
#pragma once

#include "soms/base/error.h"

#include "apps/cli/parser.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// Takes the lists of a parser apart, and gives options their names of today.
class Parser::Expanded {
 public:
  Expanded(const Parser& parser, std::vector<std::string> words);

  /// The words; each key as an option of its own, no option by an old name.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

  /// About keys that are given as options, and about old names.
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

  /// About an unknown key, or one without a value: the first of them.
  [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }

  /// What `LIST help` asks for; empty if nothing does.
  [[nodiscard]] const std::string& keys() const { return keys_; }

 private:
  void rename(std::vector<std::string>& words, std::size_t i);
  [[nodiscard]] bool takes_next(const std::string& word) const;
  void add_list(const Option& list, std::string_view text);
  void add_key(const Option& list, std::string_view item);
  void add_word(const std::string& word);
  void refuse(Error fault);

  const Parser& parser_;
  std::vector<std::string> words_;
  std::vector<std::string> remarks_;
  std::optional<Error> fault_;
  std::string keys_;
};

}  // namespace soms::command
