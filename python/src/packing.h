/// \file
/// Values of C++ as bytes and back, for pickles. A structure is packed field by field as C++ lists
/// them, so an answer that gets a new field needs nothing here.
#pragma once

#include "soms/describe/field_count.h"

#include "python/src/errors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::python {

/// How a T is packed whose fields do not tell: has `put(Packer&, const T&)` and `get(Unpacker&)`.
template <class T>
struct Packing;

/// \errors ErrorKind::bad_file, always: bytes that no answer was packed as.
[[noreturn]] void refuse_pickle();

/// (version of soms, bytes)
[[nodiscard]] py::tuple pickle_state(const std::string& bytes);

/// The bytes, which live as long as the state. \errors ErrorKind::bad_file for another version.
[[nodiscard]] std::string_view pickled_bytes(const py::tuple& state);

namespace detail {

template <class T>
concept PackedApart = requires {
  sizeof(Packing<T>);
};

template <class T, template <class...> class Of>
inline constexpr bool kIs = false;
template <template <class...> class Of, class... Arguments>
inline constexpr bool kIs<Of<Arguments...>, Of> = true;

template <class T>
inline constexpr bool kIsArray = false;
template <class T, std::size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;

/// `function(field...)` of the fields of an aggregate without a base class.
template <class T, class Function>
decltype(auto) with_fields(T& value, Function&& function) {
  constexpr std::size_t kCount = field_count<std::remove_const_t<T>>();
  static_assert(kCount > 0 && kCount < 18, "more fields than there are cases here");
  // clang-format off
  if constexpr (kCount == 1) { auto& [a] = value; return function(a); }
  else if constexpr (kCount == 2) { auto& [a, b] = value; return function(a, b); }
  else if constexpr (kCount == 3) { auto& [a, b, c] = value; return function(a, b, c); }
  else if constexpr (kCount == 4) { auto& [a, b, c, d] = value; return function(a, b, c, d); }
  else if constexpr (kCount == 5) { auto& [a, b, c, d, e] = value; return function(a, b, c, d, e); }
  else if constexpr (kCount == 6) { auto& [a, b, c, d, e, f] = value; return function(a, b, c, d, e, f); }
  else if constexpr (kCount == 7) { auto& [a, b, c, d, e, f, g] = value; return function(a, b, c, d, e, f, g); }
  else if constexpr (kCount == 8) { auto& [a, b, c, d, e, f, g, h] = value; return function(a, b, c, d, e, f, g, h); }
  else if constexpr (kCount == 9) { auto& [a, b, c, d, e, f, g, h, i] = value; return function(a, b, c, d, e, f, g, h, i); }
  else if constexpr (kCount == 10) { auto& [a, b, c, d, e, f, g, h, i, j] = value; return function(a, b, c, d, e, f, g, h, i, j); }
  else if constexpr (kCount == 11) { auto& [a, b, c, d, e, f, g, h, i, j, k] = value; return function(a, b, c, d, e, f, g, h, i, j, k); }
  else if constexpr (kCount == 12) { auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l); }
  else if constexpr (kCount == 13) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l, m); }
  else if constexpr (kCount == 14) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l, m, n); }
  else if constexpr (kCount == 15) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o); }
  else if constexpr (kCount == 16) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p); }
  else if constexpr (kCount == 17) { auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = value; return function(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q); }
  // clang-format on
}

}  // namespace detail

/// Makes bytes of values, in the order in which they are put.
class Packer {
 public:
  template <class T>
  void put(const T& value) {
    if constexpr (detail::PackedApart<T>) {
      Packing<T>::put(*this, value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof(T));
    } else if constexpr (std::is_same_v<T, std::string>) {
      put<std::uint64_t>(value.size());
      raw(value.data(), value.size());
    } else if constexpr (detail::kIs<T, std::optional>) {
      put(value.has_value());
      if (value) {
        put(*value);
      }
    } else if constexpr (detail::kIs<T, std::pair>) {
      put(value.first);
      put(value.second);
    } else if constexpr (detail::kIsArray<T>) {
      for (const auto& one : value) {
        put(one);
      }
    } else if constexpr (detail::kIs<T, std::vector>) {
      put<std::uint64_t>(value.size());
      for (const auto& one : value) {
        put(one);
      }
    } else {
      detail::with_fields(value, [&](const auto&... fields) { (put(fields), ...); });
    }
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void raw(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }

  std::string bytes_;
};

/// Takes values out of bytes, in the order in which they were put.
class Unpacker {
 public:
  /// \pre The bytes outlive it.
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  /// \errors ErrorKind::bad_file where bytes are missing.
  template <class T>
  [[nodiscard]] T get() {
    if constexpr (detail::PackedApart<T>) {
      return Packing<T>::get(*this);
    } else if constexpr (std::is_same_v<T, bool>) {
      return get<std::uint8_t>() != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      T value{};
      std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
      return value;
    } else if constexpr (std::is_same_v<T, std::string>) {
      return std::string(take(get<std::uint64_t>()));
    } else if constexpr (detail::kIs<T, std::optional>) {
      return get<bool>() ? T(get<typename T::value_type>()) : T();
    } else if constexpr (detail::kIs<T, std::pair>) {
      auto first = get<typename T::first_type>();
      return T(std::move(first), get<typename T::second_type>());
    } else if constexpr (detail::kIsArray<T>) {
      T value{};
      for (auto& one : value) {
        one = get<typename T::value_type>();
      }
      return value;
    } else if constexpr (detail::kIs<T, std::vector>) {
      return get_vector<T>();
    } else {
      T value{};
      detail::with_fields(value, [&](auto&... fields) { (set(fields), ...); });
      return value;
    }
  }

  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  template <class T>
  void set(T& value) {
    value = get<T>();
  }

  /// Every value has a byte or more, so a damaged count asks for no more memory than the bytes do.
  template <class T>
  T get_vector() {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size()) {
      refuse_pickle();
    }
    T values;
    values.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      values.push_back(get<typename T::value_type>());
    }
    return values;
  }

  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) {
      refuse_pickle();
    }
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
};

/// A structure with a base class and one field more, as answers about many bodies are.
template <class T, class Base, auto Field>
struct ExtendedPacking {
  static void put(Packer& to, const T& value) {
    to.put(static_cast<const Base&>(value));
    to.put(value.*Field);
  }

  static T get(Unpacker& from) {
    T value;
    static_cast<Base&>(value) = from.get<Base>();
    value.*Field = from.get<std::decay_t<decltype(value.*Field)>>();
    return value;
  }
};

/// What pickles keep of a value: the version of soms, and its bytes, whose numbers are
/// little-endian as on every machine that soms is built for.
template <class T>
[[nodiscard]] py::tuple packed(const T& value) {
  Packer packer;
  packer.put(value);
  return pickle_state(packer.bytes());
}

/// \errors ErrorKind::bad_file for what another version packed, and for damaged bytes.
template <class T>
[[nodiscard]] T unpacked(const py::tuple& state) {
  Unpacker unpacker(pickled_bytes(state));
  T value = unpacker.get<T>();
  if (!unpacker.at_end()) {
    refuse_pickle();
  }
  return value;
}

}  // namespace soms::python
