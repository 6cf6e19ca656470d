#include "apps/cli/verb.h"

#include "apps/cli/parse.h"

#include <utility>

namespace soms::command {

ParsedVerb::ParsedVerb(std::string_view program, const Verb& verb)
    : parser_(std::string(verb.question), std::string(program) + " " + std::string(verb.name)) {
  action_ = verb.add(parser_, shared_);
  add_help_option(parser_);
  add_shared_options(parser_, shared_);
}

std::vector<OptionWords> ParsedVerb::options() const {
  std::vector<OptionWords> options;
  for (const Option* option : parser_.options()) {
    OptionWords words{option->dashed_names(), {}, option->has_value()};
    if (option->option_text() == kChoiceText) {
      words.values = listed_words(option->description());
    }
    if (!option->is_argument() && option->list() == nullptr) {
      options.push_back(std::move(words));
    }
  }
  return options;
}

std::vector<std::string> ParsedVerb::option_names() const {
  std::vector<std::string> names;
  for (const OptionWords& option : options()) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

}  // namespace soms::command
