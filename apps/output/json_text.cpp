// The one source of what programs share that sees nlohmann/json.
#include "apps/output/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace soms::command {

/// Appends JSON to a text as nlohmann::ordered_json::dump writes it.
class JsonText {
 public:
  explicit JsonText(std::string& text) : text_(&text) {}

  void add(const Json& json) const {
    std::visit([this](const auto& value) { add_value(value); }, json.value_);
  }

 private:
  void add_value(std::nullptr_t) const { *text_ += "null"; }

  void add_value(bool value) const { *text_ += value ? "true" : "false"; }

  void add_value(std::int64_t value) const { *text_ += fmt::format_int(value).c_str(); }

  void add_value(std::uint64_t value) const { *text_ += fmt::format_int(value).c_str(); }

  void add_value(double value) const {
    if (!std::isfinite(value)) {
      *text_ += "null";
      return;
    }
    std::array<char, 64> digits;
    const char* const end =
        nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
    text_->append(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }

  void add_value(const std::string& value) const {
    const bool is_plain = std::all_of(value.begin(), value.end(), [](char c) {
      return c >= ' ' && c < 0x7f && c != '"' && c != '\\';
    });
    if (is_plain) {
      (*text_ += '"').append(value) += '"';
    } else {
      add_escaped(
          nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
  }

  void add_value(const Json::Array& values) const {
    char before = '[';
    for (const Json& value : values) {
      *text_ += before;
      add(value);
      before = ',';
    }
    *text_ += values.empty() ? "[]" : "]";
  }

  void add_value(const Json::Members& members) const {
    char before = '{';
    for (const auto& [name, value] : members) {
      *text_ += before;
      add_value(name);
      *text_ += ':';
      add(value);
      before = ',';
    }
    *text_ += members.empty() ? "{}" : "}";
  }

  /// With the control characters beyond ASCII, and DEL, escaped as those of ASCII are.
  void add_escaped(const std::string& text) const {
    for (std::size_t k = 0; k < text.size(); ++k) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
      if (byte(k) == 0x7f) {
        *text_ += "\\u007f";
      } else if (byte(k) == 0xc2 && k + 1 < text.size() && byte(k + 1) < 0xa0) {
        *text_ += fmt::format("\\u{:04x}", byte(++k));
      } else {
        *text_ += text[k];
      }
    }
  }

  std::string* text_;
};

namespace {

/// Reads a text and leaves behind how far it came, which the parser says of its own errors alone.
class CountedByte {
 public:
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;
  using iterator_category = std::forward_iterator_tag;

  CountedByte(const char* at, const char** read) : at_(at), read_(read) {}

  const char& operator*() const { return *at_; }

  CountedByte& operator++() {
    *read_ = ++at_;
    return *this;
  }

  CountedByte operator++(int) {
    const CountedByte before = *this;
    ++*this;
    return before;
  }

  friend bool operator==(const CountedByte& a, const CountedByte& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** read_;
};

using Events = nlohmann::json_sax<nlohmann::ordered_json>;

}  // namespace

/// Builds a value from what the parser meets.
class JsonBuilder final : public Events {
 public:
  explicit JsonBuilder(int deepest) : deepest_(deepest) {}

  [[nodiscard]] ParsedJson& parsed() { return parsed_; }

  bool null() override { return add(nullptr); }

  bool boolean(bool value) override { return add(value); }

  bool number_integer(number_integer_t value) override { return add(value); }

  bool number_unsigned(number_unsigned_t value) override { return add(value); }

  bool number_float(number_float_t value, const string_t&) override { return add(value); }

  bool string(string_t& value) override { return add(std::move(value)); }

  bool binary(binary_t&) override { return false; }

  bool start_object(std::size_t) override { return open(Json::object()); }

  bool key(string_t& name) override {
    key_ = std::move(name);
    return is_shallow();
  }

  bool end_object() override { return close(); }

  bool start_array(std::size_t) override { return open(Json::array()); }

  bool end_array() override { return close(); }

  bool parse_error(std::size_t byte, const std::string&,
                   const nlohmann::detail::exception&) override {
    parsed_.fault = std::max<std::size_t>(byte, 1);
    return false;
  }

 private:
  /// An object or array that is not closed yet.
  struct Level {
    Json* value;
    std::map<std::string, std::size_t, std::less<>> places = {};  ///< of many members, by name
  };

  /// The member named last, the same one if it is repeated.
  Json& member(Level& level) const {
    constexpr std::size_t kFew = 32;
    Json::Members& members = std::get<Json::Members>(level.value->value_);
    if (members.size() < kFew) {
      return (*level.value)[key_];
    }
    for (std::size_t k = level.places.empty() ? 0 : members.size(); k < members.size(); ++k) {
      level.places.emplace(members[k].first, k);
    }
    const auto [place, is_new] = level.places.emplace(key_, members.size());
    return is_new ? members.emplace_back(key_, nullptr).second : members[place->second].second;
  }

  Json& placed(Json value) {
    if (open_.empty()) {
      return parsed_.value = std::move(value);
    }
    Json& holder = *open_.back().value;
    if (holder.is_object()) {
      return member(open_.back()) = std::move(value);
    }
    holder.push_back(std::move(value));
    return holder.back();
  }

  bool is_shallow() {
    parsed_.too_deep = parsed_.too_deep || static_cast<int>(open_.size()) > deepest_;
    return !parsed_.too_deep;
  }

  bool add(Json value) {
    if (is_shallow()) {
      placed(std::move(value));
    }
    return !parsed_.too_deep;
  }

  bool open(Json value) {
    if (is_shallow()) {
      open_.push_back({&placed(std::move(value))});
    }
    return !parsed_.too_deep;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  ParsedJson parsed_;
  std::vector<Level> open_;
  std::string key_;
  int deepest_;
};

ParsedJson parse_json(std::string_view text, int deepest) {
  JsonBuilder builder(deepest);
  const char* read = text.data();
  const char* const end = text.data() + text.size();
  if (!nlohmann::ordered_json::sax_parse(CountedByte(read, &read), CountedByte(end, &read),
                                         &builder)) {
    builder.parsed().value = nullptr;
  }
  if (builder.parsed().too_deep) {
    // A number has been read to the byte behind it, which may be the end of its line.
    const std::string_view seen(text.data(), static_cast<std::size_t>(read - text.data()));
    builder.parsed().fault = seen.find_last_not_of(" \t\r\n") + 1;
  }
  return std::move(builder.parsed());
}

std::string json_text(const Json& value) {
  std::string text;
  JsonText(text).add(value);
  return text;
}

std::string json_line(const Json& value) {
  return json_text(value) + "\n";
}

}  // namespace soms::command
