/// \file
/// Names from files, which may be bytes of any encoding, as strings of Python and back.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

namespace soms::python {

/// Bytes that are UTF-8, or not: Python has the others as surrogates, as it has them in paths.
struct Text {
  std::string bytes;
};

[[nodiscard]] inline std::vector<Text> texts_of(const std::vector<std::string>& all) {
  std::vector<Text> texts;
  for (const std::string& one : all) {
    texts.push_back({one});
  }
  return texts;
}

[[nodiscard]] inline std::vector<std::string> bytes_of_texts(std::vector<Text> all) {
  std::vector<std::string> bytes;
  for (Text& one : all) {
    bytes.push_back(std::move(one.bytes));
  }
  return bytes;
}

}  // namespace soms::python

namespace pybind11::detail {

template <>
struct type_caster<soms::python::Text> {
  PYBIND11_TYPE_CASTER(soms::python::Text, const_name("str"));

  bool load(handle given, bool) {
    if (PyUnicode_Check(given.ptr()) == 0) {
      return false;
    }
    const auto encoded = reinterpret_steal<bytes>(
        PyUnicode_AsEncodedString(given.ptr(), "utf-8", "surrogateescape"));
    if (!encoded) {
      PyErr_Clear();
      return false;
    }
    value.bytes = encoded;
    return true;
  }

  static handle cast(const soms::python::Text& text, return_value_policy, handle) {
    return PyUnicode_DecodeUTF8(text.bytes.data(), static_cast<ssize_t>(text.bytes.size()),
                                "surrogateescape");
  }
};

}  // namespace pybind11::detail
