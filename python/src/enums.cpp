#include "python/src/enums.h"

#include <string>
#include <string_view>

namespace soms::python {

const EnumMembers* load_enum(std::string_view name, std::span<const std::string_view> words) {
  auto* const found = new EnumMembers{std::string(name), {}, {}, {}};  // as long as the process
  const py::object of_python = py::module_::import("soms._enums").attr(found->name.c_str());
  for (const std::string_view word : words) {
    found->words.emplace_back(word);
    found->names.push_back(PyUnicode_InternFromString(found->words.back().c_str()));
    found->members.push_back(
        py::object(of_python.attr(found->words.back().c_str())).release().ptr());
  }
  return found;
}

std::size_t enum_value(py::handle given, const EnumMembers& members, const char* what) {
  for (std::size_t i = 0; i < members.members.size(); ++i) {
    if (given.ptr() == members.members[i] || given.ptr() == members.names[i]) {
      return i;
    }
  }
  if (PyUnicode_Check(given.ptr()) != 0) {
    const char* const word = PyUnicode_AsUTF8(given.ptr());
    if (word == nullptr) {
      throw py::error_already_set();
    }
    for (std::size_t i = 0; i < members.words.size(); ++i) {
      if (members.words[i] == word) {
        return i;
      }
    }
  }
  std::string names;
  for (const std::string& word : members.words) {
    names += (names.empty() ? "" : ", ") + word;
  }
  throw usage(
      std::string(what) + ": " + py::repr(given).cast<std::string>() + " is no " + members.name,
      "give one of " + names);
}

}  // namespace soms::python
