/// \file
/// Answers as classes of Python: named properties, one line of `repr`, equality. A query's file
/// lists its fields and is done.
#pragma once

#include "soms/base/print_fields.h"
#include "soms/describe/fields.h"
#include "soms/query/answer.h"

#include "python/src/arrays.h"
#include "python/src/enums.h"
#include "python/src/packing.h"
#include "python/src/text.h"

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::python {

// A field of a single answer, as Python has it.
[[nodiscard]] inline py::object to_python(const Vec3& value) {
  return array_of(value);
}

[[nodiscard]] inline py::object to_python(const Box& value) {
  return array_of(value);
}

[[nodiscard]] inline py::object to_python(const TrianglePair& value) {
  return py::make_tuple(value.a, value.b);
}

[[nodiscard]] inline py::object to_python(const std::string& value) {
  return py::cast(Text{value});
}

/// Whether a structure is a tuple of its fields in Python.
template <class T>
inline constexpr bool kIsTuple = false;

/// How Python has a structure that is neither a class nor such a tuple: `make(value)` says it.
template <class T>
struct OwnForm;

template <class T>
[[nodiscard]] py::object to_python(const T& value) {
  if constexpr (requires { OwnForm<T>::make(value); }) {
    return OwnForm<T>::make(value);
  } else if constexpr (std::is_enum_v<T>) {
    return member(value);
  } else if constexpr (detail::kIs<T, std::optional>) {
    return value ? to_python(*value) : py::none();
  } else if constexpr (kIsTuple<T>) {
    return std::apply(
        [&](const auto&... fields) { return py::make_tuple(to_python(fields.of(value))...); },
        Fields<T>::kList);
  } else {
    return py::cast(value);
  }
}

/// What a property of an object is.
using Getter = std::function<py::object(const py::object& self)>;

/// Adds a property to a class. All have one type in C++: pybind11 would make code for each.
void def_property(py::object of_class, const char* name, Getter get, const char* doc);

/// Whether a class says itself how it is pickled, as it refers to other objects of Python.
template <class T>
inline constexpr bool kPicklesItself = false;

/// Binds an answer: T must print and compare. It is pickled by its fields.
template <class T, class... Bases>
class AnswerClass : public py::class_<T, Bases...> {
 public:
  AnswerClass(const py::module_& module, const char* name, const char* doc)
      : py::class_<T, Bases...>(module, name, doc) {
    this->def("__repr__", &printed<T>);
    this->def(
        "__eq__", [](const T& a, const T& b) { return a == b; }, py::is_operator());
    this->attr("__hash__") = py::none();
    const std::string refusal =
        std::string(name) + " is neither true nor false: look at one of its fields";
    this->def("__bool__", [refusal](const T&) -> bool { throw py::type_error(refusal); });
    if constexpr (!kPicklesItself<T>) {
      this->def(py::pickle(&packed<T>, &unpacked<T>));
    }
  }

  /// A field of a single answer.
  template <class C, class V>
  AnswerClass& field(const char* name, V C::*place, const char* doc) {
    return property(
        name, [place](const py::object& self) { return to_python(of(self).*place); }, doc);
  }

  /// What a function says of an answer.
  template <class F>
  AnswerClass& derived(const char* name, F function, const char* doc) {
    return property(
        name,
        [function](const py::object& self) -> py::object {
          using Result = std::invoke_result_t<F, const T&>;
          if constexpr (std::is_base_of_v<py::handle, Result>) {
            return py::object(std::invoke(function, of(self)));
          } else {
            return py::object(py::cast(std::invoke(function, of(self))));
          }
        },
        doc);
  }

  /// The flag that an answer is about, which is also its truth. \errors ErrorKind::timed_out where
  /// false means that it is not known.
  AnswerClass& truth(const char* name, bool T::*place, const char* doc) {
    field(name, place, doc);
    const auto is_true = [place](const T& answer) {
      if (!(answer.*place) && answer.coverage == Coverage::cut) {
        throw Error(ErrorKind::timed_out, "the answer is cut: false means that it is not known",
                    "look at its coverage, or give more time");
      }
      return answer.*place;
    };
    // In place of the refusal: `def` would add to it.
    this->attr("__bool__") = py::cpp_function(is_true, py::name("__bool__"), py::is_method(*this));
    return *this;
  }

  /// A column of a batch: a view that cannot be written, or a copy where some entries are missing.
  template <class C, class V>
  AnswerClass& column(const char* name, std::vector<V> C::*place, const char* doc) {
    return property(
        name, [place](const py::object& self) { return column_of(of(self).*place, self); }, doc);
  }

  /// Rows of any length: `of(i)` is that part of a column which belongs to row i.
  template <class C, class V, class O>
  AnswerClass& rows(std::vector<O> C::*offsets, std::vector<V> C::*values) {
    this->def(
        "of",
        [offsets, values](const py::object& self, std::size_t row) -> py::object {
          const T& answer = of(self);
          const auto& ends = answer.*offsets;
          if (row + 1 >= ends.size()) {
            throw py::index_error("row " + std::to_string(row) + " of " +
                                  std::to_string(ends.size() - 1));
          }
          return column_of(answer.*values, self)[py::slice(
              static_cast<py::ssize_t>(ends[row]), static_cast<py::ssize_t>(ends[row + 1]), 1)];
        },
        py::arg("row"), "of(row) -> numpy.ndarray\n\nThe values of one row, a view.");
    return *this;
  }

  /// The number of entries, and the single answer of each.
  AnswerClass& entries() {
    this->def("__len__", &T::size);
    if constexpr (requires(const T& t) { t.at(std::size_t{}); }) {
      this->def(
          "at",
          [](const T& answer, std::size_t entry) {
            if (entry >= answer.size()) {
              throw py::index_error("entry " + std::to_string(entry) + " of " +
                                    std::to_string(answer.size()));
            }
            return answer.at(entry);
          },
          py::arg("entry"), "at(entry)\n\nThe answer of a single query.");
    }
    return *this;
  }

 private:
  static const T& of(const py::object& self) { return self.cast<const T&>(); }

  AnswerClass& property(const char* name, Getter get, const char* doc) {
    def_property(*this, name, std::move(get), doc);
    return *this;
  }
};

}  // namespace soms::python
