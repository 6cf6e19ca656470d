#include "apps/cli/option_lists.h"

#include "soms/base/error.h"

#include "apps/cli/parse.h"
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

/// True if a value of the option begins here, and no more than that: "N", or one of its words.
bool begins_with_value(const Option& option, std::string_view text) {
  const std::string_view word = text.substr(0, text.find_first_of(" ;,.)"));
  const std::string_view rest = text.substr(word.size());
  const std::vector<std::string>& words = option.choices();
  const bool fits =
      word == option.option_text() || std::find(words.begin(), words.end(), word) != words.end();
  return fits && (!rest.starts_with(',') || rest.starts_with(", "));
}

/// True if `name`, which stands here, is a part of another name, or of one of a file.
bool is_part(std::string_view text, std::size_t at, std::size_t end) {
  const bool begins = at == 0 || std::string_view(" \n(\"'`").find(text[at - 1]) != text.npos;
  const bool ends =
      end == text.size() || !(is_part_of_name(text[end]) || text[end] == '/' || text[end] == '.');
  return !begins || !ends;
}

/// "--leaf 4", and nothing else: a fault of the value.
bool is_word_alone(std::string_view text) {
  return !text.empty() && text.find_first_of(" ,;") == text.npos;
}

}  // namespace

Parser::Expanded::Expanded(const Parser& parser, std::vector<std::string> words) : parser_(parser) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    rename(words, i);
    if (words[i] == "--") {
      words_.insert(words_.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
      return;
    }
    if (takes_next(words[i]) && i + 1 < words.size()) {
      add_word(words[i]);
      words_.push_back(words[++i]);
      continue;
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

/// Gives the option that stands at `i` by an old name its name of today.
void Parser::Expanded::rename(std::vector<std::string>& words, std::size_t i) {
  const std::size_t end = std::min(words[i].find('='), words[i].size());
  const std::string name = words[i].substr(0, end);
  const bool with_value = end < words[i].size();
  const std::string next = i + 1 < words.size() ? words[i + 1] : std::string();
  const std::string value = with_value ? words[i].substr(end + 1) : next;
  for (const auto& option : parser_.options_) {
    for (const Option::OldName& old : option->old_names_) {
      if (old.name == name && (!old.fits || old.fits(value))) {
        words[i] = option->name() + words[i].substr(end);
        const std::string shown =
            option->option_text_.empty() ? std::string() : " " + option->option_text_;
        remarks_.push_back(
            fmt::format("{0}{2} is now {1}{2}; the old form ends with the next release", name,
                        option->name(), shown));
        return;
      }
    }
  }
}

/// True of an option whose value is the next word, whatever that looks like; lists are none.
bool Parser::Expanded::takes_next(const std::string& word) const {
  return std::any_of(parser_.options_.begin(), parser_.options_.end(), [&](const auto& option) {
    const std::vector<std::string> names = option->dashed_names();
    return (option->takes_ == Takes::one || option->takes_ == Takes::one_each_time) &&
           parser_.keys_of(option.get()).empty() &&
           std::find(names.begin(), names.end(), word) != names.end();
  });
}

void Parser::Expanded::add_list(const Option& list, std::string_view text) {
  if (text == "help") {
    keys_ = parser_.keys();
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
    refuse(Error(ErrorKind::usage,
                 fmt::format("{}: unknown key {}", list.name(), name.empty() ? "\"\"" : name),
                 near.empty() ? "use " + key_names(keys) : fmt::format("did you mean {}?", near)));
  } else if (name.size() == item.size()) {
    refuse(Error(ErrorKind::usage, fmt::format("{}: {} has no value", list.name(), name),
                 fmt::format("write {} {}=VALUE ({} help lists the values)", list.name(), name,
                             list.name())));
  } else {
    words_.push_back("--" + std::string(item));
  }
}

void Parser::Expanded::refuse(Error fault) {
  if (!fault_) {
    fault_ = std::move(fault);
  }
}

void Parser::Expanded::add_word(const std::string& word) {
  words_.push_back(word);
  const std::string name = word.substr(0, word.find('='));
  for (const auto& option : parser_.options_) {
    const std::string form = option->new_form();
    if (!form.empty() && option->name() == name) {
      remarks_.push_back(
          fmt::format("{} is now {}; the old form ends with the next release", name, form));
    }
  }
}

std::string Parser::keys() const {
  const auto list = std::find_if(options_.begin(), options_.end(), [&](const auto& option) {
    return !keys_of(option.get()).empty();
  });
  if (list == options_.end()) {
    return {};
  }
  std::string text = fmt::format("Keys of {}:\n", (*list)->name());
  for (const Option* const key : keys_of(list->get())) {
    std::string meaning = key->description();
    for (std::size_t at = meaning.find('\n'); at != std::string::npos;
         at = meaning.find('\n', at)) {
      meaning.replace(at, 1, "\n" + std::string(27, ' '));
      at += 28;
    }
    text += fmt::format("  {:<25}{}\n", key_name(*key) + "=" + key->option_text(), meaning);
  }
  return with_keys(text);
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
      if (is_part(text, at, end)) {
        at = end;
        continue;
      }
      const std::string_view rest = std::string_view(text).substr(std::min(end + 1, text.size()));
      const bool has_value = end < text.size() && text[end] == ' ' &&
                             ((at == 0 && is_word_alone(rest)) || begins_with_value(*option, rest));
      text.replace(at, name.size() + (has_value ? 1 : 0), has_value ? with + "=" : with);
      at += with.size();
    }
  }
  return text;
}

}  // namespace soms::command
