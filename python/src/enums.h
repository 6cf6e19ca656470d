/// \file
/// Enumerations: integers in arrays, members of soms._enums elsewhere, and words where one is
/// given.
#pragma once

#include "soms/base/words.h"

#include "python/src/errors.h"

#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::python {

/// The members of an enumeration of Python, by value from 0 on.
struct EnumMembers {
  std::string name;
  std::vector<std::string> words;
  std::vector<PyObject*> names;    ///< interned strings of the words; never given back
  std::vector<PyObject*> members;  ///< never given back
};

/// Reads an enumeration from soms._enums. \errors py::error_already_set.
[[nodiscard]] const EnumMembers* load_enum(std::string_view name,
                                           std::span<const std::string_view> words);

/// Those of the enumeration E, read where it is first used. \pre The interpreter's lock is held.
template <Worded E>
[[nodiscard]] const EnumMembers& enum_members() {
  static const EnumMembers* found = nullptr;
  if (found == nullptr) {
    found = load_enum(kWords<E>.type, kWords<E>.names);
  }
  return *found;
}

/// The member of Python for a value.
template <class E>
[[nodiscard]] py::object member(E value) {
  return py::reinterpret_borrow<py::object>(
      enum_members<E>().members.at(static_cast<std::size_t>(value)));
}

/// The value of a member or of its name. \errors ErrorKind::usage, which lists the names; `what` is
/// the argument.
[[nodiscard]] std::size_t enum_value(py::handle given, const EnumMembers& members,
                                     const char* what);

template <class E>
[[nodiscard]] E enum_of(py::handle given, const char* what) {
  return static_cast<E>(enum_value(given, enum_members<E>(), what));
}

}  // namespace soms::python
