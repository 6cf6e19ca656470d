/// \file
/// JSON as a value and as text. Light to include: only json_text.cpp sees nlohmann/json, which
/// reads text and writes numbers (docs/decisions/0086).
#pragma once

#include "soms/base/box.h"

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace soms::command {

class JsonPart;

/// JSON whose keys keep their order. Built as nlohmann::ordered_json is: braces around pairs that
/// begin with a text are an object, all others an array.
class Json {
 public:
  using Array = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;
  class Iterator;

  /// A value of another type than requested, or no member of that name.
  struct exception : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "JSON of another form"; }
  };

  Json() noexcept;
  Json(std::nullptr_t) noexcept;
  Json(bool value) noexcept;
  Json(const char* text);
  Json(std::string text);
  Json(std::string_view text);
  Json(Array values);
  Json(std::initializer_list<JsonPart> parts);
  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();

  template <std::signed_integral T>
  Json(T value) : Json(Number{static_cast<std::int64_t>(value)}) {}

  template <std::unsigned_integral T>

  requires(!std::same_as<T, bool>) Json(T value)
      : Json(Number{static_cast<std::uint64_t>(value)}) {}

  template <std::floating_point T>
  Json(T value) : Json(Number{static_cast<double>(value)}) {}

  template <class T>

  requires std::constructible_from<Json, T> Json(const std::vector<T>& values)
      : Json(Array(values.begin(), values.end())) {}

  [[nodiscard]] static Json array(std::initializer_list<JsonPart> parts = {});
  [[nodiscard]] static Json object(std::initializer_list<JsonPart> parts = {});

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }

  [[nodiscard]] bool is_boolean() const { return std::holds_alternative<bool>(value_); }

  [[nodiscard]] bool is_string() const { return std::holds_alternative<std::string>(value_); }

  [[nodiscard]] bool is_array() const { return std::holds_alternative<Array>(value_); }

  [[nodiscard]] bool is_object() const { return std::holds_alternative<Members>(value_); }

  [[nodiscard]] bool is_number_unsigned() const {
    return std::holds_alternative<std::uint64_t>(value_);
  }

  [[nodiscard]] bool is_number_float() const { return std::holds_alternative<double>(value_); }

  [[nodiscard]] bool is_number() const {
    return is_number_unsigned() || is_number_float() ||
           std::holds_alternative<std::int64_t>(value_);
  }

  /// \errors Json::exception for another type, and for a number that a whole one cannot hold.
  template <class T>
  [[nodiscard]] T get() const {
    if constexpr (std::same_as<T, std::string>) {
      return text();
    } else if constexpr (std::same_as<T, bool>) {
      return truth();
    } else {
      static_assert(std::integral<T> || std::floating_point<T>);
      return std::visit([](auto number) { return as<T>(number); }, number());
    }
  }

  /// Values of an array, members of an object, or none.
  [[nodiscard]] std::size_t size() const;

  [[nodiscard]] bool empty() const { return size() == 0; }

  /// The member, added where there is none. \pre An object or null.
  Json& operator[](std::string_view key);

  /// \pre There is one.
  [[nodiscard]] const Json& operator[](std::string_view key) const { return at(key); }

  [[nodiscard]] Json& operator[](std::size_t index);

  [[nodiscard]] const Json& operator[](std::size_t index) const { return at(index); }

  /// \errors Json::exception where there is none.
  [[nodiscard]] const Json& at(std::string_view key) const;
  [[nodiscard]] const Json& at(std::size_t index) const;

  /// \pre An array that is not empty.
  [[nodiscard]] Json& back() { return (*this)[size() - 1]; }

  [[nodiscard]] const Json& front() const { return at(std::size_t{0}); }

  [[nodiscard]] bool contains(std::string_view key) const;

  /// The member, or `other` where there is none.
  [[nodiscard]] Json value(std::string_view key, Json other) const;

  /// \pre An array or null.
  void push_back(Json value);

  template <class... Values>
  void emplace_back(Values&&... values) {
    push_back(Json(std::forward<Values>(values)...));
  }

  /// Sets each member of an object. \pre Objects, or null for this one.
  void update(const Json& other);

  void erase(std::string_view key);

  /// The members of an object. \errors Json::exception for another type.
  [[nodiscard]] const Members& items() const;

  /// Over the values of an array or of an object.
  [[nodiscard]] Iterator begin() const;
  [[nodiscard]] Iterator end() const;
  [[nodiscard]] Iterator find(std::string_view key) const;

  friend bool operator==(const Json& a, const Json& b);

 private:
  using Number = std::variant<std::int64_t, std::uint64_t, double>;
  friend class JsonBuilder;
  friend class JsonText;

  template <class T, class Given>
  [[nodiscard]] static T as(Given number) {
    if constexpr (std::integral<T> && std::floating_point<Given>) {
      const auto least = static_cast<double>(std::numeric_limits<T>::min());
      const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
      if (!(number >= least && number < beyond) || number != std::trunc(number)) {
        throw exception();
      }
    } else if constexpr (std::integral<T>) {
      if (!std::in_range<T>(number)) {
        throw exception();
      }
    }
    return static_cast<T>(number);
  }

  explicit Json(Number number) noexcept;
  [[nodiscard]] Number number() const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] const Json* found(std::string_view key) const;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array,
               Members>
      value_;
};

/// A value between braces, from where it is moved.
class JsonPart {
 public:
  JsonPart(std::initializer_list<JsonPart> parts);

  template <class T>

  requires std::constructible_from<Json, T> JsonPart(T&& value) : value_(std::forward<T>(value)) {}

  [[nodiscard]] const Json& value() const { return value_; }

  [[nodiscard]] Json taken() const { return std::move(value_); }

 private:
  mutable Json value_;
};

class Json::Iterator {
 public:
  using value_type = Json;
  using difference_type = std::ptrdiff_t;
  using pointer = const Json*;
  using reference = const Json&;
  using iterator_category = std::forward_iterator_tag;

  Iterator() = default;

  explicit Iterator(const Json* value) : value_(value) {}

  explicit Iterator(const Members::value_type* member) : member_(member) {}

  [[nodiscard]] const Json& operator*() const;

  [[nodiscard]] const Json* operator->() const { return &**this; }

  Iterator& operator++();
  Iterator operator++(int);

  friend bool operator==(const Iterator&, const Iterator&) = default;

 private:
  const Json* value_ = nullptr;
  const Members::value_type* member_ = nullptr;
};

/// A text of JSON, parsed.
struct ParsedJson {
  Json value;
  std::size_t fault = 0;  ///< the byte that is no JSON, from 1 on; 0 where all is
  bool too_deep = false;
};

/// Never throws for what the text says. Nested more than `deepest` levels it is too deep.
[[nodiscard]] ParsedJson parse_json(std::string_view text, int deepest);

/// JSON on one line, without its end. Bytes that are not UTF-8 (of file names) become U+FFFD.
/// Control characters are escaped, those beyond ASCII and DEL too, so that a terminal obeys none.
[[nodiscard]] std::string json_text(const Json& value);

/// `json_text` with a line break.
[[nodiscard]] std::string json_line(const Json& value);

/// The corners of a box, `[[x,y,z],[x,y,z]]`; null for an empty box.
[[nodiscard]] Json json_box(const Box& box);

}  // namespace soms::command
