// What a step of a scene finds.
#include "soms/scene/step_report.h"

#include "soms/scene/print.h"

#include "python/src/described.h"
#include "python/src/scene/scene.h"
#include "python/src/scene/scene_columns.h"

namespace soms::python {

void bind_step_report(py::module_& module) {
  AnswerClass<StepReport> report = bind_answer<StepReport>(module);
  report.derived(
      "touching_movers",
      [](const StepReport& r) {
        const std::vector<MoverId> ids = r.touching_movers();
        return py::array_t<std::uint32_t>(static_cast<py::ssize_t>(ids.size()), ids.data());
      },
      "(n,) uint32: movers that touch anything, ascending; a copy.");
  report.def("hash", &StepReport::hash, "hash() -> int\n\nFNV-1a 64 over both lists of contacts.");
}

}  // namespace soms::python
