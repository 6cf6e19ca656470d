// What all answers share.
#include "soms/query/answer.h"
#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/bind.h"

#include <utility>

namespace soms::python {

void def_property(py::object of_class, const char* name, Getter get, const char* doc) {
  const py::cpp_function getter(std::move(get), py::is_method(of_class));
  const py::handle property(reinterpret_cast<PyObject*>(&PyProperty_Type));
  of_class.attr(name) = property(getter, py::none(), py::none(), doc);
}

void bind_answers(py::module_& module) {
  AnswerClass<Cost> cost(module, "Cost",
                         "Work done by a query: counts, the same on every machine.");
  cost.field("node_tests", &Cost::node_tests, "Boxes, or pairs of boxes, tested.")
      .field("triangle_tests", &Cost::triangle_tests, "Triangles, or pairs of them, tested.")
      .field("exact_tests", &Cost::exact_tests, "Of these, those that needed exact arithmetic.");
}

}  // namespace soms::python
