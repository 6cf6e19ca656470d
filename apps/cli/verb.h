/// \file
/// Verbs of a program: their options, and what they do.
#pragma once

#include "apps/cli/parser.h"
#include "apps/cli/shared.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;

/// What a parsed verb does; returns the exit status.
using Action = std::function<int(Console&)>;

/// A verb: `add` gives the parser its options and returns what to do once they are parsed.
struct Verb {
  std::string_view name;
  std::string_view question;  ///< one line of the program's --help
  Action (*add)(Parser& parser, Shared& shared);
  /// Set for a verb of another program, whose `add` is null: hands it the words after the verb.
  int (*pass_on)(std::string_view verb, const std::vector<std::string>& words) = nullptr;
};

/// A verb's parser with the values that it fills. The shared options are added after the verb's
/// own.
class ParsedVerb {
 public:
  /// `program` is the first word of usage lines.
  ParsedVerb(std::string_view program, const Verb& verb);
  ParsedVerb(const ParsedVerb&) = delete;
  ParsedVerb& operator=(const ParsedVerb&) = delete;

  [[nodiscard]] Parser& parser() { return parser_; }

  [[nodiscard]] const Parser& parser() const { return parser_; }

  [[nodiscard]] const Shared& shared() const { return shared_; }

  [[nodiscard]] const Action& action() const { return action_; }

  /// The text of --help.
  [[nodiscard]] std::string help() const { return parser_.help(); }

  /// Every name of every option, with its dashes.
  [[nodiscard]] std::vector<std::string> option_names() const;

 private:
  Parser parser_;
  Shared shared_;
  Action action_;
};

}  // namespace soms::command
