#include "apps/cli/option_lists.h"

#include "soms/base/error.h"

#include "apps/cli/suggest.h"

#include <fmt/format.h>

#include <algorithm>

namespace soms::command {

namespace {

std::string key_name(const Option& option) {
  return option.name().substr(2);
}

/// "rule, levels, leaf".
std::string key_names(const std::vector<const Option*>& keys) {
  std::string names;
  for (const Option* const key : keys) {
    names += (names.empty() ? "" : ", ") + key_name(*key);
  }
  return names;
}

bool is_part_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

/// The word that begins here, as a value that an option can have: "N", or one of its words.
std::string_view value_at(const Option& option, std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() &&
         (is_part_of_name(text[end]) || (text[end] >= 'A' && text[end] <= 'Z'))) {
    ++end;
  }
  const std::string_view word = text.substr(0, end);
  const std::string listed =
      "|" + option.description().substr(option.description().rfind(' ') + 1) + "|";
  const bool fits =
      word == option.option_text() || listed.find(fmt::format("|{}|", word)) != std::string::npos;
  return fits ? word : std::string_view();
}

}  // namespace

Parser::Expanded::Expanded(const Parser& parser, const std::vector<std::string>& words)
    : parser_(parser) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") {
      words_.insert(words_.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
      return;
    }
    const std::string name = words[i].substr(0, words[i].find('='));
    const auto list =
        std::find_if(parser.options_.begin(), parser.options_.end(), [&](const auto& option) {
          return option->name() == name && !parser.keys_of(option.get()).empty();
        });
    if (list == parser.options_.end() || (name == words[i] && i + 1 == words.size())) {
      add_word(words[i]);  // a list without a word is refused as any option is
    } else if (name == words[i]) {
      add_list(**list, words[++i]);
    } else {
      add_list(**list, std::string_view(words[i]).substr(name.size() + 1));
    }
  }
}

void Parser::Expanded::add_list(const Option& list, std::string_view text) {
  if (text == "help") {
    keys_ = meanings_of(list);
    return;
  }
  for (;;) {
    const std::size_t end = std::min(text.find(','), text.size());
    add_key(list, text.substr(0, end));
    if (end == text.size()) {
      return;
    }
    text.remove_prefix(end + 1);
  }
}

void Parser::Expanded::add_key(const Option& list, std::string_view item) {
  const std::string_view name = item.substr(0, item.find('='));
  const std::vector<const Option*> keys = parser_.keys_of(&list);
  const auto key = std::find_if(keys.begin(), keys.end(),
                                [&](const Option* one) { return key_name(*one) == name; });
  if (key == keys.end()) {
    std::vector<std::string> known;
    for (const Option* const one : keys) {
      known.push_back(key_name(*one));
    }
    const std::string near = nearest_words(name, known);
    throw Error(ErrorKind::usage,
                fmt::format("{}: unknown key {}", list.name(), name.empty() ? "\"\"" : name),
                near.empty() ? "use " + key_names(keys) : fmt::format("did you mean {}?", near));
  }
  if (name.size() == item.size()) {
    throw Error(ErrorKind::usage, fmt::format("{}: {} has no value", list.name(), name),
                fmt::format("write {} {}=VALUE ({} help lists the values)", list.name(), name,
                            list.name()));
  }
  words_.push_back("--" + std::string(item));
}

void Parser::Expanded::add_word(const std::string& word) {
  words_.push_back(word);
  const std::string name = word.substr(0, word.find('='));
  for (const auto& option : parser_.options_) {
    if (option->list_ != nullptr && option->name() == name) {
      remarks_.push_back(fmt::format("{} is now {} {}={}; the old form ends with the next release",
                                     name, option->list_->name(), name.substr(2),
                                     option->option_text_));
    }
  }
}

std::string Parser::Expanded::meanings_of(const Option& list) const {
  std::string text = fmt::format("Keys of {}:\n", list.name());
  for (const Option* const key : parser_.keys_of(&list)) {
    std::string meaning = key->description();
    for (std::size_t at = meaning.find('\n'); at != std::string::npos;
         at = meaning.find('\n', at)) {
      meaning.replace(at, 1, "\n" + std::string(27, ' '));
      at += 28;
    }
    text += fmt::format("  {:<25}{}\n", key_name(*key) + "=" + key->option_text(), meaning);
  }
  return parser_.with_keys(text);
}

std::string Parser::with_keys(std::string text) const {
  for (const auto& option : options_) {
    if (option->list_ == nullptr) {
      continue;
    }
    const std::string name = option->name();
    const std::string with = fmt::format("{} {}", option->list_->name(), name.substr(2));
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
      const std::size_t end = at + name.size();
      if (end < text.size() && is_part_of_name(text[end])) {
        at = end;
        continue;
      }
      const bool has_value = end < text.size() && text[end] == ' ' &&
                             !value_at(*option, std::string_view(text).substr(end + 1)).empty();
      text.replace(at, name.size() + (has_value ? 1 : 0), has_value ? with + "=" : with);
      at += with.size();
    }
  }
  return text;
}

}  // namespace soms::command
