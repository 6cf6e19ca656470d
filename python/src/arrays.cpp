#include "python/src/arrays.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace soms::python {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_trivially_copyable_v<Vec3>);
static_assert(sizeof(TrianglePair) == 2 * sizeof(TriangleId));
static_assert(sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::uint32_t));

/// \errors ErrorKind::usage for an array of numpy.ma whose mask leaves numbers out.
void check_mask(py::handle given, const char* what) {
  const auto* const plain = py::detail::npy_api::get().PyArray_Type_;
  const bool is_subclass = py::isinstance<py::array>(given) && Py_TYPE(given.ptr()) != plain;
  if (is_subclass && py::hasattr(given, "mask") &&
      py::module_::import("numpy").attr("any")(given.attr("mask")).cast<bool>()) {
    throw usage(std::string(what) + ": numbers are masked", "give an array without a mask");
  }
}

py::array any_array(py::handle given, const char* what) {
  check_mask(given, what);
  py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw usage(std::string(what) + ": no array of numbers",
                "give numbers in rows of equal length");
  }
  return array;
}

[[noreturn]] void refuse_type(const py::array& given, const char* what, const char* wanted) {
  throw usage(std::string(what) + ": type " + py::str(given.dtype()).cast<std::string>(),
              std::string("give ") + wanted);
}

py::ssize_t rows(std::size_t count) {
  return static_cast<py::ssize_t>(count);
}

template <class T>
py::array pairs_view(const std::vector<T>& values, py::ssize_t columns, const py::dtype& type,
                     py::handle owner) {
  return view(type, {rows(values.size()), columns}, {rows(sizeof(T)), rows(sizeof(T)) / columns},
              values.data(), owner);
}

/// Integers as int64; those of uint64 must fit.
py::array_t<std::int64_t> integers_of(py::handle given, const char* what) {
  const py::array array = any_array(given, what);
  const char kind = array.dtype().kind();
  const bool is_empty = array.size() == 0;  // an empty list is an array of floats
  if (kind != 'i' && kind != 'u' && !is_empty) {
    refuse_type(array, what, "integers");
  }
  if (kind == 'u' && array.itemsize() == 8 && !is_empty &&
      array.attr("max")().cast<std::uint64_t>() >= std::uint64_t{1} << 63U) {
    throw Error(ErrorKind::out_of_range, std::string(what) + ": a number of 2^63 or more",
                "give numbers below 2^32");
  }
  return py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
}

std::uint32_t index_of(std::int64_t value, std::size_t row, const char* what) {
  if (value < 0 || value > 0xffffffffLL) {
    throw Error(
        ErrorKind::out_of_range,
        std::string(what) + ": index " + std::to_string(value) + " in row " + std::to_string(row),
        "count from 0; negative numbers do not count from the end");
  }
  return static_cast<std::uint32_t>(value);
}

constexpr std::int64_t kExact = std::int64_t{1} << 53;

[[noreturn]] void refuse_integer(const char* what) {
  throw Error(ErrorKind::out_of_range,
              std::string(what) + ": an integer beyond 2^53, which a double may not hold",
              "give floats");
}

/// Looks at the integers themselves: the double of 2^53 + 1 is 2^53.
template <class Integer>
void check_integers(const py::array& array, const char* what) {
  const py::array_t<Integer, py::array::c_style | py::array::forcecast> integers(array);
  for (py::ssize_t i = 0; i < integers.size(); ++i) {
    const Integer value = integers.data()[i];
    if (std::cmp_greater(value, kExact) || std::cmp_less(value, -kExact)) {
      refuse_integer(what);
    }
  }
}

/// The integers of nested lists, of which numpy makes floats where one number is a float.
void check_listed(py::handle given, const char* what) {
  if (PyLong_Check(given.ptr()) != 0) {
    check_number(given, what);
  } else if (PyList_Check(given.ptr()) != 0 || PyTuple_Check(given.ptr()) != 0) {
    for (const py::handle one : py::reinterpret_borrow<py::sequence>(given)) {
      check_listed(one, what);
    }
  }
}

/// \errors ErrorKind::out_of_range for lists with an integer that was rounded.
void check_rounded(py::handle given, const Doubles& doubles, const char* what) {
  for (py::ssize_t i = 0; i < doubles.size(); ++i) {
    if (std::abs(doubles.data()[i]) >= static_cast<double>(kExact)) {
      check_listed(given, what);
      return;
    }
  }
}

}  // namespace

void check_number(py::handle given, const char* what) {
  if (PyLong_Check(given.ptr()) == 0) {
    return;
  }
  int overflow = 0;
  const long long value = PyLong_AsLongLongAndOverflow(given.ptr(), &overflow);
  if (overflow != 0 || value > kExact || value < -kExact) {
    refuse_integer(what);
  }
}

Doubles doubles_of(py::handle given, const char* what) {
  const py::array array = any_array(given, what);
  const char kind = array.dtype().kind();
  const bool is_float = kind == 'f' && array.itemsize() <= 8;
  const bool is_integer = kind == 'i' || kind == 'u';
  if (!is_float && !is_integer) {
    refuse_type(array, what, "floats of 4 or 8 bytes, or integers");
  }
  if (kind == 'i' && array.itemsize() == 8) {
    check_integers<std::int64_t>(array, what);
  } else if (kind == 'u' && array.itemsize() == 8) {
    check_integers<std::uint64_t>(array, what);
  }
  Doubles doubles(array);
  if (is_float && !py::isinstance<py::array>(given)) {
    check_rounded(given, doubles, what);
  }
  return doubles;
}

std::string shape_text(const py::array& array) {
  return py::str(array.attr("shape")).cast<std::string>();
}

void refuse_shape(const py::array& given, const char* what, const char* wanted) {
  throw usage(std::string(what) + ": shape " + shape_text(given), std::string("give ") + wanted);
}

Rows<Vec3> points_of(Doubles numbers, const char* what) {
  if (numbers.ndim() != 2 || numbers.shape(1) != 3) {
    refuse_shape(numbers, what, "shape (n, 3)");
  }
  return Rows<Vec3>(std::move(numbers));
}

bool is_point(const Doubles& numbers) {
  return numbers.ndim() == 1 && numbers.shape(0) == 3;
}

Vec3 point_of(const Doubles& numbers, const char* what) {
  if (!is_point(numbers)) {
    refuse_shape(numbers, what, "three numbers");
  }
  return {numbers.data()[0], numbers.data()[1], numbers.data()[2]};
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(py::handle given) {
  const auto numbers = integers_of(given, "triangles");
  const bool is_empty_list = numbers.ndim() == 1 && numbers.size() == 0;
  if (!is_empty_list && (numbers.ndim() != 2 || numbers.shape(1) != 3)) {
    refuse_shape(numbers, "triangles", "shape (n, 3)");
  }
  std::vector<std::array<std::uint32_t, 3>> triangles(static_cast<std::size_t>(numbers.shape(0)));
  const std::int64_t* from = numbers.data();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::uint32_t& corner : triangles[i]) {
      corner = index_of(*from++, i, "triangles");
    }
  }
  return triangles;
}

std::vector<TriangleId> ids_of(py::handle given, const char* what, Extents& shape) {
  const auto numbers = integers_of(given, what);
  shape.assign(numbers.shape(), numbers.shape() + numbers.ndim());
  std::vector<TriangleId> ids(static_cast<std::size_t>(numbers.size()));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] = index_of(numbers.data()[i], i, what);
  }
  return ids;
}

py::dtype structured(const std::vector<Field>& fields, std::size_t row) {
  py::list names;
  py::list formats;
  py::list offsets;
  for (const Field& field : fields) {
    names.append(field.name);
    formats.append(field.type);
    offsets.append(field.offset);
  }
  return {names, formats, offsets, static_cast<py::ssize_t>(row)};
}

py::array view(const py::dtype& type, const Extents& shape, const Extents& strides,
               const void* data, py::handle owner) {
  py::array array(type, shape, strides, data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::array array_of(const Vec3& point) {
  py::array_t<double> array(3);
  array.mutable_data()[0] = point.x;
  array.mutable_data()[1] = point.y;
  array.mutable_data()[2] = point.z;
  return array;
}

py::array array_of(const Box& box) {
  py::array_t<double> array({2, 3});
  for (py::ssize_t axis = 0; axis < 3; ++axis) {
    array.mutable_at(0, axis) = box.lower[static_cast<std::size_t>(axis)];
    array.mutable_at(1, axis) = box.upper[static_cast<std::size_t>(axis)];
  }
  return array;
}

py::array column_of(const std::vector<std::optional<TriangleId>>& values, py::handle) {
  py::array_t<std::int64_t> array(rows(values.size()));
  std::int64_t* to = array.mutable_data();
  for (const auto& value : values) {
    *to++ = value ? std::int64_t{*value} : -1;
  }
  return array;
}

py::array column_of(const std::vector<std::optional<TrianglePair>>& values, py::handle) {
  py::array_t<std::int64_t> array({rows(values.size()), py::ssize_t{2}});
  std::int64_t* to = array.mutable_data();
  for (const auto& value : values) {
    *to++ = value ? std::int64_t{value->a} : -1;
    *to++ = value ? std::int64_t{value->b} : -1;
  }
  return array;
}

py::array column_of(const std::vector<std::optional<Vec3>>& values, py::handle) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  py::array_t<double> array({rows(values.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const auto& value : values) {
    const Vec3 v = value.value_or(Vec3{kNone, kNone, kNone});
    *to++ = v.x;
    *to++ = v.y;
    *to++ = v.z;
  }
  return array;
}

py::array column_of(const std::vector<std::uint8_t>& values, py::handle owner) {
  return view(py::dtype("?"), {rows(values.size())}, {1}, values.data(), owner);
}

py::array column_of(const std::vector<Vec3>& values, py::handle owner) {
  return pairs_view(values, 3, py::dtype::of<double>(), owner);
}

py::array column_of(const std::vector<Pose>& values, py::handle owner) {
  constexpr py::ssize_t kNumber = sizeof(double);
  return view(py::dtype::of<double>(), {rows(values.size()), 3, 4},
              {12 * kNumber, 4 * kNumber, kNumber}, values.data(), owner);
}

py::array column_of(const std::vector<TrianglePair>& values, py::handle owner) {
  return pairs_view(values, 2, py::dtype::of<std::uint32_t>(), owner);
}

py::array column_of(const std::vector<std::array<std::uint32_t, 3>>& values, py::handle owner) {
  return pairs_view(values, 3, py::dtype::of<std::uint32_t>(), owner);
}

py::dtype RowType<Bracket>::get() {
  return structured(
      {{"lower", "f8", offsetof(Bracket, lower)}, {"upper", "f8", offsetof(Bracket, upper)}},
      sizeof(Bracket));
}

}  // namespace soms::python
