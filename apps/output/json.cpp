#include "apps/output/json.h"

#include <algorithm>
#include <memory>

namespace soms::command {

Json::Json() noexcept : value_(nullptr) {
}

Json::Json(std::nullptr_t) noexcept : value_(nullptr) {
}

Json::Json(bool value) noexcept : value_(value) {
}

Json::Json(const char* text) : value_(std::string(text)) {
}

Json::Json(std::string text) : value_(std::move(text)) {
}

Json::Json(std::string_view text) : value_(std::string(text)) {
}

Json::Json(Array values) : value_(std::move(values)) {
}

Json::Json(Number number) noexcept : value_(nullptr) {
  std::visit([this](auto one) { value_ = one; }, number);
}

Json::Json(const Json&) = default;

Json::Json(Json&& other) noexcept : value_(std::move(other.value_)) {
  other.value_ = nullptr;
}

Json& Json::operator=(const Json&) = default;

Json& Json::operator=(Json&& other) noexcept {
  if (this != &other) {
    value_ = std::move(other.value_);
    other.value_ = nullptr;
  }
  return *this;
}

Json::~Json() = default;

Json::Json(std::initializer_list<JsonPart> parts) {
  const bool are_members = std::all_of(parts.begin(), parts.end(), [](const JsonPart& part) {
    const Json& value = part.value();
    return value.is_array() && value.size() == 2 && value.front().is_string();
  });
  *this = are_members ? object(parts) : array(parts);
}

JsonPart::JsonPart(std::initializer_list<JsonPart> parts) : value_(parts) {
}

Json Json::array(std::initializer_list<JsonPart> parts) {
  Array values;
  values.reserve(parts.size());
  for (const JsonPart& part : parts) {
    values.push_back(part.taken());
  }
  return Json(std::move(values));
}

Json Json::object(std::initializer_list<JsonPart> parts) {
  Json made;
  Members& members = made.value_.emplace<Members>();
  members.reserve(parts.size());
  for (const JsonPart& part : parts) {
    Json pair = part.taken();
    Array& both = std::get<Array>(pair.value_);
    auto& name = std::get<std::string>(both[0].value_);
    if (made.found(name) == nullptr) {
      members.emplace_back(std::move(name), std::move(both[1]));
    }
  }
  return made;
}

Json::Number Json::number() const {
  if (const auto* const natural = std::get_if<std::uint64_t>(&value_)) {
    return *natural;
  }
  if (const auto* const whole = std::get_if<std::int64_t>(&value_)) {
    return *whole;
  }
  if (const auto* const real = std::get_if<double>(&value_)) {
    return *real;
  }
  throw exception();
}

const std::string& Json::text() const {
  if (!is_string()) {
    throw exception();
  }
  return std::get<std::string>(value_);
}

bool Json::truth() const {
  if (!is_boolean()) {
    throw exception();
  }
  return std::get<bool>(value_);
}

std::size_t Json::size() const {
  if (const auto* const values = std::get_if<Array>(&value_)) {
    return values->size();
  }
  const auto* const members = std::get_if<Members>(&value_);
  return members == nullptr ? 0 : members->size();
}

const Json* Json::found(std::string_view key) const {
  if (const auto* const members = std::get_if<Members>(&value_)) {
    for (const auto& [name, value] : *members) {
      if (name == key) {
        return &value;
      }
    }
  }
  return nullptr;
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) {
    value_.emplace<Members>();
  }
  if (!is_object()) {
    throw exception();
  }
  Members& members = std::get<Members>(value_);
  const auto at = std::find_if(members.begin(), members.end(),
                               [&](const auto& member) { return member.first == key; });
  return at != members.end() ? at->second : members.emplace_back(key, nullptr).second;
}

Json& Json::operator[](std::size_t index) {
  if (index >= size() || !is_array()) {
    throw exception();
  }
  return std::get<Array>(value_)[index];
}

const Json& Json::at(std::string_view key) const {
  const Json* const value = found(key);
  if (value == nullptr) {
    throw exception();
  }
  return *value;
}

const Json& Json::at(std::size_t index) const {
  if (index >= size() || !is_array()) {
    throw exception();
  }
  return std::get<Array>(value_)[index];
}

bool Json::contains(std::string_view key) const {
  return found(key) != nullptr;
}

Json Json::value(std::string_view key, Json other) const {
  const Json* const value = found(key);
  return value == nullptr ? std::move(other) : *value;
}

void Json::push_back(Json value) {
  if (is_null()) {
    value_.emplace<Array>();
  }
  if (!is_array()) {
    throw exception();
  }
  std::get<Array>(value_).push_back(std::move(value));
}

void Json::update(const Json& other) {
  for (const auto& [name, value] : other.items()) {
    (*this)[name] = value;
  }
}

void Json::erase(std::string_view key) {
  std::erase_if(std::get<Members>(value_), [&](const auto& member) { return member.first == key; });
}

const Json::Members& Json::items() const {
  if (!is_object()) {
    throw exception();
  }
  return std::get<Members>(value_);
}

Json::Iterator Json::begin() const {
  if (const auto* const members = std::get_if<Members>(&value_)) {
    return Iterator(members->data());
  }
  const auto* const values = std::get_if<Array>(&value_);
  return values == nullptr ? Iterator() : Iterator(values->data());
}

Json::Iterator Json::end() const {
  if (const auto* const members = std::get_if<Members>(&value_)) {
    return Iterator(members->data() + members->size());
  }
  const auto* const values = std::get_if<Array>(&value_);
  return values == nullptr ? Iterator() : Iterator(values->data() + values->size());
}

Json::Iterator Json::find(std::string_view key) const {
  if (const auto* const members = std::get_if<Members>(&value_)) {
    return Iterator(
        std::to_address(std::find_if(members->begin(), members->end(),
                                     [&](const auto& member) { return member.first == key; })));
  }
  return end();
}

const Json& Json::Iterator::operator*() const {
  return member_ != nullptr ? member_->second : *value_;
}

Json::Iterator& Json::Iterator::operator++() {
  if (member_ != nullptr) {
    ++member_;
  } else {
    ++value_;
  }
  return *this;
}

Json::Iterator Json::Iterator::operator++(int) {
  const Iterator before = *this;
  ++*this;
  return before;
}

bool operator==(const Json& a, const Json& b) {
  return a.value_ == b.value_;
}

Json json_box(const Box& box) {
  if (box.empty()) {
    return nullptr;
  }
  return Json::array(
      {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}});
}

}  // namespace soms::command
