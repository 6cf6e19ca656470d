#include "python/src/paths.h"

#include <string>

namespace soms::python {

std::filesystem::path path_of(const py::object& given) {
  PyObject* converted = nullptr;
  if (PyUnicode_FSConverter(given.ptr(), &converted) == 0) {
    throw py::error_already_set();
  }
  return static_cast<std::string>(py::reinterpret_steal<py::bytes>(converted));
}

std::vector<std::byte> bytes_of(const py::object& given) {
  Py_buffer view{};
  if (PyObject_GetBuffer(given.ptr(), &view, PyBUF_SIMPLE) != 0) {
    throw py::error_already_set();
  }
  const auto* const first = static_cast<const std::byte*>(view.buf);
  std::vector<std::byte> bytes(first, first + view.len);
  PyBuffer_Release(&view);
  return bytes;
}

}  // namespace soms::python
