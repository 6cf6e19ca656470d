/// \file
/// Arrays of numpy in and out. What goes in is copied, as another thread may change it while a
/// query runs; what comes out is a view of the answer wherever its memory allows that.
#pragma once

#include "soms/base/box.h"
#include "soms/base/bracket.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/describe/fields.h"
#include "soms/geometry/mesh.h"
#include "soms/query/answer.h"
#include "soms/query/contains_parts.h"

#include "python/src/errors.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::python {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// Sizes along each axis, or steps in bytes.
using Extents = std::vector<py::ssize_t>;

/// Rows of doubles as T's, read where they lie in an array of numpy.
template <class T>
class Rows {
 public:
  /// \pre Its numbers are those of any number of T's.
  explicit Rows(Doubles numbers) : numbers_(std::move(numbers)) {}

  /// The same in memory that no other thread can write to, so that it may be read without the lock:
  /// a copy, unless nobody else has the array. numpy's memory of many rows is of huge pages, which
  /// makes a copy five times as fast as one into a vector.
  [[nodiscard]] Rows owned() && {
    const bool is_ours = numbers_.ref_count() == 1 && numbers_.owndata() && !numbers_.base();
    return Rows(is_ours ? std::move(numbers_) : Doubles(numbers_.attr("copy")()));
  }

  [[nodiscard]] std::span<const T> get() const {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
    const auto bytes = static_cast<std::size_t>(numbers_.size()) * sizeof(double);
    return {std::launder(reinterpret_cast<const T*>(numbers_.data())), bytes / sizeof(T)};
  }

  [[nodiscard]] std::vector<T> copied() const { return {get().begin(), get().end()}; }

 private:
  Doubles numbers_;
};

/// \errors ErrorKind::out_of_range for an integer beyond 2^53, of which a double may be another.
void check_number(py::handle given, const char* what);

/// Numbers of an array or nested lists, as doubles. Floats of up to 8 bytes and integers are taken,
/// which doubles hold exactly. \errors ErrorKind::usage for other types; as `check_number`.
[[nodiscard]] Doubles doubles_of(py::handle given, const char* what);

/// "(4, 2)".
[[nodiscard]] std::string shape_text(const py::array& array);

/// \errors ErrorKind::usage, always: the shape given, and the one wanted.
[[noreturn]] void refuse_shape(const py::array& given, const char* what, const char* wanted);

/// n points. \shape (n, 3). \errors ErrorKind::usage.
[[nodiscard]] Rows<Vec3> points_of(Doubles numbers, const char* what);

[[nodiscard]] inline Rows<Vec3> points_of(py::handle given, const char* what) {
  return points_of(doubles_of(given, what), what);
}

/// True for three numbers, false for rows of them.
[[nodiscard]] bool is_point(const Doubles& numbers);
[[nodiscard]] Vec3 point_of(const Doubles& numbers, const char* what);

/// Corners of triangles, each 0 to 2^32 - 1. \shape (n, 3).
/// \errors ErrorKind::usage for another shape or type; out_of_range for a negative index, which
///         would count from the end elsewhere.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangles_of(py::handle given);

/// Numbers of triangles. \shape Any; `shape` gets it.
[[nodiscard]] std::vector<TriangleId> ids_of(py::handle given, const char* what, Extents& shape);

/// An array of named fields: their names, types of numpy, and places in a row.
struct Field {
  const char* name;
  const char* type;
  std::size_t offset;
};

[[nodiscard]] py::dtype structured(const std::vector<Field>& fields, std::size_t row);

/// A view that cannot be written and keeps `owner`.
[[nodiscard]] py::array view(const py::dtype& type, const Extents& shape, const Extents& strides,
                             const void* data, py::handle owner);

/// A point as an array of its own. \shape (3,).
[[nodiscard]] py::array array_of(const Vec3& point);

/// Its least and its greatest corner. \shape (2, 3).
[[nodiscard]] py::array array_of(const Box& box);

/// Numbers of triangles, -1 for none. \shape (n,), a copy.
[[nodiscard]] py::array column_of(const std::vector<std::optional<TriangleId>>& values,
                                  py::handle owner);
/// \shape (n, 2), a copy; -1, -1 for none.
[[nodiscard]] py::array column_of(const std::vector<std::optional<TrianglePair>>& values,
                                  py::handle owner);
/// \shape (n, 3), a copy; NaN for none.
[[nodiscard]] py::array column_of(const std::vector<std::optional<Vec3>>& values, py::handle owner);
/// Flags, as bool. \shape (n,).
[[nodiscard]] py::array column_of(const std::vector<std::uint8_t>& values, py::handle owner);
/// \shape (n, 3).
[[nodiscard]] py::array column_of(const std::vector<Vec3>& values, py::handle owner);
/// \shape (n, 3, 4).
[[nodiscard]] py::array column_of(const std::vector<Pose>& values, py::handle owner);
/// \shape (n, 2).
[[nodiscard]] py::array column_of(const std::vector<TrianglePair>& values, py::handle owner);
/// \shape (n, 3).
[[nodiscard]] py::array column_of(const std::vector<std::array<std::uint32_t, 3>>& values,
                                  py::handle owner);

/// The type of numpy for one number, or one enumerator.
template <class T>
[[nodiscard]] const char* number_type() {
  if constexpr (std::is_same_v<T, bool>) {
    return "?";
  } else if constexpr (std::is_same_v<T, double>) {
    return "f8";
  } else if constexpr (std::is_enum_v<T>) {
    return number_type<std::underlying_type_t<T>>();
  } else {
    static_assert(std::is_integral_v<T> && std::is_unsigned_v<T>, "say its type here");
    return sizeof(T) == 8 ? "u8" : sizeof(T) == 4 ? "u4" : "u1";
  }
}

/// The type of numpy for a structure, by the list of its fields.
template <Described T>
[[nodiscard]] py::dtype structured_of() {
  std::vector<Field> fields;
  const T sample{};
  for_each_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    const auto offset = static_cast<std::size_t>(reinterpret_cast<const char*>(&field.of(sample)) -
                                                 reinterpret_cast<const char*>(&sample));
    if constexpr (std::is_same_v<Value, Bracket>) {
      fields.push_back({"lower", "f8", offset + offsetof(Bracket, lower)});
      fields.push_back({"upper", "f8", offset + offsetof(Bracket, upper)});
    } else if constexpr (std::is_same_v<Value, Vec3>) {
      fields.push_back({field.name, "3f8", offset});
    } else {
      fields.push_back({field.name, number_type<Value>(), offset});
    }
  });
  return structured(fields, sizeof(T));
}

/// The type of numpy for a row of T. Structures without a list of fields have specializations.
template <class T>
struct RowType {
  static py::dtype get() {
    if constexpr (Described<T>) {
      return structured_of<T>();
    } else if constexpr (std::is_enum_v<T>) {
      return py::dtype::of<std::underlying_type_t<T>>();
    } else {
      return py::dtype::of<T>();
    }
  }
};

/// lower, upper.
template <>
struct RowType<Bracket> {
  static py::dtype get();
};

/// A column of values that are numbers, enumerations (as integers) or structures. \shape (n,).
template <class T>
struct Column {
  static py::array make(const std::vector<T>& values, py::handle owner) {
    return view(RowType<T>::get(), {static_cast<py::ssize_t>(values.size())}, {sizeof(T)},
                values.data(), owner);
  }
};

template <class T>
[[nodiscard]] py::array column_of(const std::vector<T>& values, py::handle owner) {
  return Column<T>::make(values, owner);
}

}  // namespace soms::python
