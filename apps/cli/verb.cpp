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

namespace {

std::vector<OptionWords> words_of(const Parser& parser) {
  std::vector<OptionWords> options;
  for (const Option* option : parser.options()) {
    OptionWords words{option->dashed_names(), {}, option->has_value()};
    if (option->option_text() == kChoiceText &&
        option->description().find('|') != std::string::npos) {
      words.values = listed_words(option->description());
    }
    if (!option->is_argument() && option->list() == nullptr) {
      options.push_back(std::move(words));
    }
  }
  return options;
}

}  // namespace

std::vector<OptionWords> shared_option_words() {
  Parser parser("", "");
  Shared values;
  add_help_option(parser);
  add_shared_options(parser, values);
  return words_of(parser);
}

std::vector<OptionWords> ParsedVerb::options() const {
  return words_of(parser_);
}

std::vector<std::string> ParsedVerb::option_names() const {
  std::vector<std::string> names;
  for (const OptionWords& option : options()) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

}  // namespace soms::command
