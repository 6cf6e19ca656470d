/// \file
/// `<<` of whatever has a list of fields, and of its batches: "Within{within: true, ...}".
#pragma once

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/describe/fields.h"

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace soms {

namespace detail {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;

template <class Value>
void print_field(const char* name, const Value& value, PrintedFields& fields) {
  if constexpr (kIsOptional<Value>) {
    if (value) {
      print_field(name, *value, fields);
    }
  } else if constexpr (kIsVector<Value>) {
    const std::string_view many = name;  // a plural
    fields.item(printed_count(value.size(), many.substr(0, many.size() - 1), many));
  } else if constexpr (requires { value.a, value.b; }) {  // two triangles
    fields.item(std::string(name) + " " + std::to_string(value.a) + " and " +
                std::to_string(value.b));
  } else {
    fields.add(name, value);
  }
}

template <Described T>
void print_own_fields(const T& value, PrintedFields& fields) {
  std::apply(
      [&](const auto&... field) {
        ((field.of_triangle && !names_triangle(value)
              ? void()
              : print_field(field.name, field.of(value), fields)),
         ...);
      },
      Fields<T>::kList);
}

}  // namespace detail

/// Lists are counted, not listed; what says nothing is left out. An answer about one of many bodies
/// begins with it.
template <Described T>
std::ostream& operator<<(std::ostream& out, const T& value) {
  PrintedFields fields(Fields<T>::kName);
  detail::print_own_fields(value, fields);
  if constexpr (requires { typename Fields<T>::Base; }) {
    fields.item(printed(static_cast<const typename Fields<T>::Base&>(value)));
  }
  return out << fields;
}

}  // namespace soms
