#include "apps/support/verb.h"

#include "apps/support/parse.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace soms::command {

namespace {

/// Says behind an option's meaning with which others it cannot stand, in words.
class HelpText : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_option_text().empty() && !option->get_excludes().empty()
               ? std::string()
               : CLI::Formatter::make_option_opts(option);
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    std::vector<std::string> others;
    for (const CLI::Option* other : option->get_excludes()) {
      others.push_back(other->get_name());
    }
    std::sort(others.begin(), others.end());
    for (std::size_t i = 0; i < others.size(); ++i) {
      text += (i == 0 ? "; not with " : i + 1 == others.size() ? " or " : ", ") + others[i];
    }
    return text;
  }
};

}  // namespace

ParsedVerb::ParsedVerb(std::string_view program, const Verb& verb)
    : app_(std::string(verb.question), std::string(program) + " " + std::string(verb.name)) {
  app_.allow_extras();   // reported by program.cpp, with a suggestion
  app_.set_help_flag();  // none before the verb's own options
  app_.formatter(std::make_shared<HelpText>());
  app_.get_formatter()->column_width(30);
  app_.get_formatter()->label("Positionals", "Arguments");
  app_.get_formatter()->label("REQUIRED", "");
  action_ = verb.add(app_, shared_);
  app_.set_help_flag("-h,--help", "print this help")->group(kSharedGroup);
  add_shared_options(app_, shared_);
}

std::string ParsedVerb::help() const {
  std::string text = app_.help();
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) {
    text.erase(at, 1);
  }
  return text;
}

std::vector<OptionWords> ParsedVerb::options() const {
  std::vector<OptionWords> options;
  for (const CLI::Option* option : app_.get_options()) {
    OptionWords words{{}, {}, option->get_items_expected_max() > 0};
    for (const std::string& name : option->get_lnames()) {
      words.names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      words.names.push_back("-" + name);
    }
    if (option->get_option_text() == kChoiceText) {
      words.values = listed_words(option->get_description());
    }
    if (!words.names.empty()) {
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
