#include "apps/cli/verb.h"

#include <utility>

namespace soms::command {

ParsedVerb::ParsedVerb(std::string_view program, const Verb& verb)
    : parser_(std::string(verb.question), std::string(program) + " " + std::string(verb.name)) {
  action_ = verb.add(parser_, shared_);
  add_help_option(parser_);
  add_shared_options(parser_, shared_);
}

std::vector<std::string> ParsedVerb::option_names() const {
  std::vector<std::string> names;
  for (const Option* const option : parser_.options()) {
    if (option->new_form().empty()) {
      const std::vector<std::string> dashed = option->dashed_names();
      names.insert(names.end(), dashed.begin(), dashed.end());
    }
  }
  return names;
}

}  // namespace soms::command
