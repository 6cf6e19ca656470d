// The one source that sees CLI11, whose header alone takes seconds to compile.
#include "soms/base/error.h"

#include "apps/cli/option_lists.h"
#include "apps/cli/parser.h"
#include "apps/cli/shared.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// CLI11's error about an option with too many values, or with none, as an error of ours.
Error mismatch(const CLI::ArgumentMismatch& error, const std::string& help) {
  const std::string_view text = error.what();
  const std::string option(text.substr(0, text.find(':')));
  const bool twice = text.find("At Most") != std::string_view::npos;
  return Error(ErrorKind::usage, option + (twice ? " is given more than once" : " needs a value"),
               "see " + help);
}

}  // namespace

class Parser::Built {
 public:
  /// `shown`: for --help alone, without what that does not show.
  Built(const Parser& parser, bool shown)
      : app_(parser.question_, parser.name_), parser_(&parser), shown_(shown) {
    app_.allow_extras();   // reported by program.cpp, with a suggestion
    app_.set_help_flag();  // added where it stands among the options
    app_.formatter(std::make_shared<HelpText>());
    app_.get_formatter()->column_width(30);
    app_.get_formatter()->label("Positionals", "Arguments");
    app_.get_formatter()->label("REQUIRED", "");
    app_.footer(shown ? named_shared(parser) + parser.footer_ : parser.footer_);
    for (const auto& option : parser.options_) {
      if (!shown || is_shown(*option)) {
        add(*option);
      }
    }
    for (const auto& [option, own] : made_) {
      for (const Option* const other : option->excluded_) {
        if (CLI::Option* const made = made_of(other)) {
          own->excludes(made);
        }
      }
    }
  }

  [[nodiscard]] CLI::App& app() { return app_; }

  /// Keeps in each option what the words gave it.
  void keep_results() const {
    for (const auto& [option, own] : made_) {
      option->results_ = own->results();
    }
  }

 private:
  static bool is_shown(const Option& option) {
    return option.new_form().empty() && option.first_ == nullptr && option.group_ != kSharedGroup;
  }

  /// "Shared options, explained by soms --help: --json, --threads N".
  static std::string named_shared(const Parser& parser) {
    std::string names;
    for (const auto& option : parser.options_) {
      if (option->group_ == kSharedGroup) {
        const std::string value =
            option->option_text_.empty() ? std::string() : " " + option->option_text_;
        names += (names.empty() ? "" : ", ") + option->name() + value;
      }
    }
    const std::string program = parser.name_.substr(0, parser.name_.find(' '));
    return names.empty() ? names
                         : "Shared options (" + program + " --help): " + names +
                               (parser.footer_.empty() ? "" : "\n\n");
  }

  /// Its names, in --help with those of the options on its line.
  [[nodiscard]] std::string names_of(const Parser& parser, const Option& option) const {
    std::string names = option.names_;
    for (const auto& other : parser.options_) {
      if (shown_ && other->first_ == &option) {
        names += "," + other->names_;
      }
    }
    return names;
  }

  void add(Option& option) {
    CLI::Option* const own = made(option);
    own->group(option.group_)->required(option.required_)->option_text(option.option_text_);
    if (option.takes_ == Takes::one_each_time) {
      own->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
      own->allow_extra_args(false);  // a list would swallow the names of models that follow
    }
    if (option.is_argument()) {
      own->type_name("");
    }
    if (option.check_) {
      own->check(CLI::Validator([&](std::string& word) { return option.check_(word); }, ""));
    }
    made_.emplace_back(&option, own);
  }

  CLI::Option* made(Option& option) {
    const std::string& meaning = shown_ ? option.shown_meaning() : option.description_;
    const std::string names = names_of(*parser_, option);
    switch (option.takes_) {
      case Takes::help:
        return app_.set_help_flag(names, meaning);
      case Takes::nothing:
        return option.flag_ != nullptr ? app_.add_flag(names, *option.flag_, meaning)
                                       : app_.add_flag_callback(
                                             names, [&option] { option.set_({}); }, meaning);
      case Takes::one:
        return app_.add_option_function<std::string>(
            names, [&option](const std::string& word) { option.set_({word}); }, meaning);
      case Takes::one_each_time:
      case Takes::several:
        break;
    }
    return app_.add_option_function<std::vector<std::string>>(
        names, [&option](const std::vector<std::string>& words) { option.set_(words); }, meaning);
  }

  CLI::Option* made_of(const Option* option) const {
    const auto found = std::find_if(made_.begin(), made_.end(),
                                    [&](const auto& made) { return made.first == option; });
    return found == made_.end() ? nullptr : found->second;
  }

  CLI::App app_;
  const Parser* parser_;
  bool shown_;
  std::vector<std::pair<Option*, CLI::Option*>> made_;
};

ParsedWords Parser::parse(const std::vector<std::string>& words) {
  const Expanded expanded(*this, words);
  ParsedWords parsed;
  parsed.keys = expanded.keys();
  parsed.remarks = expanded.remarks();
  Built built(*this, false);
  try {
    const std::vector<std::string>& all = expanded.words();
    built.app().parse(std::vector<std::string>(all.rbegin(), all.rend()));
  } catch (const CLI::Success&) {
    parsed.wants_help = true;
  } catch (const CLI::ArgumentMismatch& error) {
    throw mismatch(error, name_ + " --help");
  } catch (const CLI::ParseError& error) {
    parsed.fault = error.what();
  }
  if (expanded.fault() && !parsed.wants_help) {
    throw *expanded.fault();
  }
  built.keep_results();
  parsed.rest = built.app().remaining();
  return parsed;
}

std::string Parser::help() const {
  std::string text = with_keys(Built(*this, true).app().help());
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n")) {
    text.erase(at, 1);
  }
  return text;
}

}  // namespace soms::command
