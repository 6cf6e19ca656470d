#include "apps/support/verb.h"

namespace soms::command {

ParsedVerb::ParsedVerb(std::string_view program, const Verb& verb)
    : app_(std::string(verb.question), std::string(program) + " " + std::string(verb.name)) {
  app_.allow_extras();   // told by program.cpp, with a suggestion
  app_.set_help_flag();  // none before the verb's own options
  app_.get_formatter()->column_width(30);
  app_.get_formatter()->label("Positionals", "Arguments");
  app_.get_formatter()->label("REQUIRED", "");
  action_ = verb.add(app_, shared_);
  app_.set_help_flag("-h,--help", "this text")->group(kSharedGroup);
  add_shared_options(app_, shared_);
}

std::string ParsedVerb::help() const {
  std::string text = app_.help();
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) {
    text.erase(at, 1);
  }
  return text;
}

std::vector<std::string> ParsedVerb::option_names() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

}  // namespace soms::command
