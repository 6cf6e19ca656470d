#include "python/src/errors.h"

#include "python/src/text.h"

#include <exception>
#include <string>

namespace soms::python {

namespace {

/// soms.Error, never given back: modules are not unloaded.
PyObject* error_class = nullptr;

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    set_error(error);
  }
}

}  // namespace

py::object error_object(const Error& error) {
  const std::string kind(name(error.kind()));
  return py::reinterpret_borrow<py::object>(error_class)(kind, Text{error.place()},
                                                         Text{error.remedy()});
}

void set_error(const Error& error) {
  PyErr_SetObject(error_class, error_object(error).ptr());
}

void translate_errors() {
  error_class = py::object(py::module_::import("soms._error").attr("Error")).release().ptr();
  py::register_exception_translator(&translate);
}

}  // namespace soms::python
