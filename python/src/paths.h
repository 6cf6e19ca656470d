/// \file
/// Arguments that stand for files.
#pragma once

#include "python/src/errors.h"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace soms::python {

/// A path as open() takes it. Raises TypeError for anything else, ValueError for a path with a zero
/// byte.
[[nodiscard]] std::filesystem::path path_of(const py::object& given);

/// The bytes of an object that has them, a copy: another thread may change them.
[[nodiscard]] std::vector<std::byte> bytes_of(const py::object& given);

}  // namespace soms::python
