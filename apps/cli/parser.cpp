#include "apps/cli/parser.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace soms::command {

Parser::Parser(std::string question, std::string name)
    : question_(std::move(question)), name_(std::move(name)) {
}

Option* Parser::add(const std::string& names, Takes takes, const std::string& meaning,
                    Option::Set set) {
  options_.push_back(std::make_unique<Option>(names, takes, meaning));
  options_.back()->set_ = std::move(set);
  return options_.back().get();
}

Option* Parser::add_option(const std::string& names, std::string& target,
                           const std::string& meaning) {
  return add(names, Takes::one, meaning,
             [&target](const std::vector<std::string>& words) { target = words.front(); });
}

Option* Parser::add_option(const std::string& names, std::optional<std::string>& target,
                           const std::string& meaning) {
  return add(names, Takes::one, meaning, [&target](const std::vector<std::string>& words) {
    if (!words.front().empty()) {
      target = words.front();
    }
  });
}

Option* Parser::add_option(const std::string& names, std::vector<std::string>& target,
                           const std::string& meaning) {
  return add(names, Takes::several, meaning,
             [&target](const std::vector<std::string>& words) { target = words; });
}

Option* Parser::add_option_function(const std::string& names,
                                    std::function<void(const std::string&)> set,
                                    const std::string& meaning) {
  return add(names, Takes::one, meaning,
             [set = std::move(set)](const std::vector<std::string>& words) { set(words.front()); });
}

Option* Parser::add_each_time(const std::string& names, std::function<void(const std::string&)> set,
                              const std::string& meaning) {
  return add(names, Takes::one_each_time, meaning,
             [set = std::move(set)](const std::vector<std::string>& words) {
               std::for_each(words.begin(), words.end(), set);
             });
}

Option* Parser::add_flag(const std::string& names, bool& target, const std::string& meaning) {
  Option* const option = add(names, Takes::nothing, meaning, {});
  option->flag_ = &target;
  return option;
}

Option* Parser::add_flag_callback(const std::string& names, std::function<void()> set,
                                  const std::string& meaning) {
  return add(names, Takes::nothing, meaning,
             [set = std::move(set)](const std::vector<std::string>&) { set(); });
}

Option* Parser::add_list(const std::string& name, const std::string& meaning) {
  Option* const list = add(name, Takes::one_each_time, meaning, [](const auto&) {});
  return list->option_text("KEY=VALUE,...");
}

Option* Parser::add_help(const std::string& names, const std::string& meaning) {
  return add(names, Takes::help, meaning, {});
}

std::vector<const Option*> Parser::options() const {
  std::vector<const Option*> options;
  for (const auto& option : options_) {
    options.push_back(option.get());
  }
  return options;
}

Option* Parser::option(std::string_view name) {
  return found(name);
}

const Option* Parser::option(std::string_view name) const {
  return found(name);
}

bool Parser::has_option(std::string_view name) const {
  return std::any_of(options_.begin(), options_.end(),
                     [&](const auto& option) { return option->is_named(name); });
}

Option* Parser::found(std::string_view name) const {
  const auto at = std::find_if(options_.begin(), options_.end(),
                               [&](const auto& option) { return option->is_named(name); });
  if (at == options_.end()) {
    throw std::logic_error("there is no option " + std::string(name));
  }
  return at->get();
}

std::vector<const Option*> Parser::keys_of(const Option* list) const {
  std::vector<const Option*> keys;
  for (const auto& option : options_) {
    if (option->list_ == list) {
      keys.push_back(option.get());
    }
  }
  return keys;
}

std::string Parser::lines_of(std::string_view group) const {
  std::string lines;
  for (const auto& option : options_) {
    if (option->group_ == group) {
      const std::string names =
          option->names_ + (option->option_text_.empty() ? "" : " ") + option->option_text_;
      lines += "  " + names + std::string(names.size() < 26 ? 26 - names.size() : 1, ' ') +
               option->description_ + "\n";
    }
  }
  return lines;
}

void Parser::remove_option(const Option* option) {
  std::erase_if(options_, [&](const auto& own) { return own.get() == option; });
}

}  // namespace soms::command
