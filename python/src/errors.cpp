#include "python/src/errors.h"

#include "python/src/text.h"

#include <cctype>
#include <cstddef>
#include <exception>
#include <string>
#include <string_view>

namespace soms::python {

namespace {

/// soms.Error, never given back: modules are not unloaded.
PyObject* error_class = nullptr;

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Text of the library in Python's names: `WindingOptions::width` is the argument `width`, and
/// `StepScope::first_contact` is `StepScope.first_contact`.
std::string in_python(std::string text) {
  constexpr std::string_view kOptions = "Options";
  for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at)) {
    std::size_t begin = at;
    while (begin > 0 && is_word(text[begin - 1])) {
      --begin;
    }
    const bool is_name = begin != at && at + 2 < text.size() && is_word(text[at + 2]);
    if (!is_name || std::isupper(static_cast<unsigned char>(text[begin])) == 0) {
      at += 2;
    } else if (std::string_view(text).substr(begin, at - begin).ends_with(kOptions)) {
      text.erase(begin, at + 2 - begin);
      at = begin;
    } else {
      text.replace(at, 2, ".");
    }
  }
  return text;
}

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
  // Places of other kinds are of files and of names in them, which stay as they are.
  const bool is_usage = error.kind() == ErrorKind::usage;
  const std::string place = is_usage ? in_python(error.place()) : error.place();
  return py::reinterpret_borrow<py::object>(error_class)(kind, Text{place},
                                                         Text{in_python(error.remedy())});
}

void set_error(const Error& error) {
  PyErr_SetObject(error_class, error_object(error).ptr());
}

void translate_errors() {
  error_class = py::object(py::module_::import("soms._error").attr("Error")).release().ptr();
  py::register_exception_translator(&translate);
}

}  // namespace soms::python
