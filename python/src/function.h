/// \file
/// Functions of the module whose calls cost little.
///
/// pybind11 makes a string for each parameter that may be named, in each call that names one: half
/// a microsecond for a query with six options, which itself takes less. Here names are compared as
/// the pointers that interned strings are, by CPython's own vectorcall.
#pragma once

#include "python/src/arrays.h"
#include "python/src/errors.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::python {

/// A parameter of a function.
struct Parameter {
  const char* name;
  py::object fallback = {};        ///< in place of what is not given; none for one that is required
  bool is_named_only = false;      ///< never by its place
  const char* old_name = nullptr;  ///< accepted with a DeprecationWarning
};

using Parameters = std::vector<Parameter>;

/// Those parameters, then the ones that every query takes: timeout, threads, progress.
[[nodiscard]] Parameters with_limits(Parameters parameters);

/// A DeprecationWarning. \errors What Python makes of it: an exception, where warnings are errors.
void warn_of_old_name(const std::string& function, const char* old_name, const char* name);

/// Most parameters of a function.
inline constexpr std::size_t kMostParameters = 16;

/// What was passed for each parameter, or its fallback.
using Passed = std::array<PyObject*, kMostParameters>;

/// Adds a function to the module. `body` gets what was passed, in the order of the parameters.
void add_function(py::module_& module, const char* name, std::string doc, Parameters parameters,
                  std::function<py::object(const Passed&)> body);

/// Makes the module's other functions ones that are pickled by their names, as those of
/// `add_function` are. Once, when all are there.
void name_functions(const py::module_& module);

/// \errors py::type_error, always: an argument that is of another type.
[[noreturn]] void refuse_argument(const char* function, const char* parameter, PyObject* given);

/// The argument as a T.
template <class T>
[[nodiscard]] T argument(const char* function, const char* parameter, PyObject* given) {
  if constexpr (std::is_same_v<T, py::object>) {
    return py::reinterpret_borrow<py::object>(given);
  } else {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
      check_number(given, parameter);
    }
    py::detail::make_caster<T> caster;
    if (!caster.load(given, true)) {
      refuse_argument(function, parameter, given);
    }
    return py::detail::cast_op<T>(caster);
  }
}

namespace detail {

template <class... Arguments, std::size_t... I>
void def_typed(py::module_& module, const char* name,
               std::function<py::object(Arguments...)> function, std::string doc,
               Parameters parameters, std::index_sequence<I...>) {
  static_assert(sizeof...(Arguments) <= kMostParameters);
  const std::array<const char*, sizeof...(Arguments)> names{parameters.at(I).name...};
  add_function(module, name, std::move(doc), std::move(parameters),
               [name, names, function = std::move(function)](const Passed& passed) {
                 return function(argument<std::decay_t<Arguments>>(name, names[I], passed[I])...);
               });
}

template <class... Arguments>
void def_typed(py::module_& module, const char* name,
               std::function<py::object(Arguments...)> function, std::string doc,
               Parameters parameters) {
  def_typed(module, name, std::move(function), std::move(doc), std::move(parameters),
            std::index_sequence_for<Arguments...>());
}

}  // namespace detail

/// Adds a function of C++ that returns a py::object, whose arguments the parameters are.
template <class Function>
void def_function(py::module_& module, const char* name, const Function& function, std::string doc,
                  Parameters parameters) {
  detail::def_typed(module, name, std::function(function), std::move(doc), std::move(parameters));
}

}  // namespace soms::python
