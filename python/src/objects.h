/// \file
/// Objects of C++ in objects of Python, and back: as pybind11 does it, but a class is looked up
/// once in the life of the process and not, by a hash of its name, in each call.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <typeinfo>
#include <utility>

namespace soms::python {

namespace py = pybind11;

/// What pybind11 knows of the class T. \pre The class is bound.
template <class T>
[[nodiscard]] const py::detail::type_info* class_info() {
  static const py::detail::type_info* const info = py::detail::get_type_info(typeid(T), true);
  return info;
}

/// The object of C++ in one of Python, or null if it is no T.
template <class T>
[[nodiscard]] const T* inside(py::handle given) {
  py::detail::type_caster_generic caster(class_info<T>());
  return caster.load(given, false) ? static_cast<const T*>(caster.value) : nullptr;
}

/// A new object of Python that owns the value.
template <class T>
[[nodiscard]] py::object made(T&& value) {
  auto owned = std::make_unique<T>(std::forward<T>(value));
  const py::handle object = py::detail::type_caster_generic::cast(
      owned.get(), py::return_value_policy::take_ownership, {}, class_info<T>(), nullptr, nullptr);
  static_cast<void>(owned.release());
  return py::reinterpret_steal<py::object>(object);
}

}  // namespace soms::python
