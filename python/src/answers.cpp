// What all answers share.
#include "soms/query/answer.h"
#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/bind.h"

namespace soms::python {

void bind_answers(py::module_& module) {
  AnswerClass<Cost> cost(module, "Cost",
                         "Work done by a query: counts, the same on every machine.");
  cost.field("node_tests", &Cost::node_tests, "Boxes, or pairs of boxes, tested.")
      .field("triangle_tests", &Cost::triangle_tests, "Triangles, or pairs of them, tested.")
      .field("exact_tests", &Cost::exact_tests, "Of these, those that needed exact arithmetic.");
}

}  // namespace soms::python
