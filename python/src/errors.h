/// \file
/// Errors of soms in Python, and the few that the binding itself throws.
#pragma once

#include "soms/base/error.h"

#include <pybind11/pybind11.h>

#include <string>

namespace soms::python {

namespace py = pybind11;

/// An argument that makes no sense: what it is, and what to give in its place.
[[nodiscard]] inline Error usage(std::string place, std::string remedy) {
  return {ErrorKind::usage, std::move(place), std::move(remedy)};
}

/// The same as a soms.Error.
[[nodiscard]] py::object error_object(const Error& error);

/// Raises it as soms.Error.
void set_error(const Error& error);

/// Makes soms::Error arrive as soms.Error.
void translate_errors();

}  // namespace soms::python
