#include "apps/cli/option.h"

#include <algorithm>
#include <utility>

namespace soms::command {

namespace {

/// "-o" and "--output" of "-o,--output".
std::vector<std::string> separate_names(std::string_view names) {
  std::vector<std::string> separate;
  for (std::size_t at = 0; at <= names.size();) {
    const std::size_t end = std::min(names.find(',', at), names.size());
    separate.emplace_back(names.substr(at, end - at));
    at = end + 1;
  }
  return separate;
}

}  // namespace

Option::Option(const std::string& names, Takes takes, std::string meaning)
    : names_(names), description_(std::move(meaning)), takes_(takes) {
}

Option* Option::group(std::string heading) {
  group_ = std::move(heading);
  return this;
}

Option* Option::option_text(std::string text) {
  option_text_ = std::move(text);
  return this;
}

Option* Option::description(std::string meaning) {
  description_ = std::move(meaning);
  return this;
}

Option* Option::purpose(const std::string& meaning) {
  const std::size_t list = description_.rfind(": ");
  description_ = meaning + (list == std::string::npos ? "" : description_.substr(list));
  return this;
}

Option* Option::required() {
  required_ = true;
  return this;
}

Option* Option::excludes(const Option* other) {
  excluded_.push_back(other);
  return this;
}

Option* Option::check(Check check) {
  check_ = std::move(check);
  return this;
}

Option* Option::key_of(const Option* list) {
  list_ = list;
  return this;
}

Option* Option::old_name(std::string name, std::function<bool(const std::string&)> fits) {
  old_names_.push_back({std::move(name), std::move(fits)});
  return this;
}

Option* Option::old_name_of(std::string form) {
  replaced_by_ = std::move(form);
  return this;
}

Option* Option::shown_with(Option* first, std::string meaning) {
  first_ = first;
  first->shown_meaning_ = std::move(meaning);
  return this;
}

Option* Option::choices(std::vector<std::string> words) {
  choices_ = std::move(words);
  return this;
}

std::string Option::new_form() const {
  return list_ == nullptr ? replaced_by_
                          : list_->name() + " " + name().substr(2) + "=" + option_text_;
}

std::string Option::name() const {
  const std::vector<std::string> dashed = dashed_names();
  return dashed.empty() ? names_ : dashed.front();
}

std::vector<std::string> Option::dashed_names() const {
  std::vector<std::string> dashed = separate_names(names_);
  std::erase_if(dashed, [](const std::string& name) { return !name.starts_with("-"); });
  std::stable_partition(dashed.begin(), dashed.end(),
                        [](const std::string& name) { return name.starts_with("--"); });
  return dashed;
}

bool Option::is_named(std::string_view name) const {
  const std::vector<std::string> all = separate_names(names_);
  return std::any_of(all.begin(), all.end(), [&](std::string_view own) {
    return own == name || own.substr(std::min(own.find_first_not_of('-'), own.size())) == name;
  });
}

}  // namespace soms::command
