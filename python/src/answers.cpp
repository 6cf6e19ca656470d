// What all answers share.
#include "soms/query/answer.h"
#include "soms/query/print.h"

#include "python/src/described.h"

#include <utility>

namespace soms::python {

void def_property(py::object of_class, const char* name, Getter get, const char* doc) {
  const py::cpp_function getter(std::move(get), py::is_method(of_class));
  const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
  of_class.attr(name) = property(getter, py::none(), py::none(), doc);
}

void bind_answers(py::module_& module) {
  bind_answer<Cost>(module);
}

}  // namespace soms::python
