// What a step of a scene finds.
#include "soms/scene/step_report.h"

#include "soms/scene/print.h"

#include "python/src/scene/scene.h"
#include "python/src/scene/scene_columns.h"

namespace soms::python {

void bind_step_report(py::module_& module) {
  AnswerClass<StepReport> report(module, "StepReport",
                                 "What a step of a scene found: sorted arrays with named fields.");
  report
      .column("environment", &StepReport::environment,
              "(n,) with fields mover, part (number of a body), i (triangle of the mover), j.")
      .column("movers", &StepReport::movers, "(n,) with fields a, b (a < b), i, j.")
      .column("environment_gaps", &StepReport::environment_gaps,
              "(n,) with fields mover, part, i, j, lower, upper, point_a, point_b.")
      .column("mover_gaps", &StepReport::mover_gaps,
              "(n,) with fields a, b, i, j, lower, upper, point_a, point_b.")
      .derived(
          "touching_movers",
          [](const StepReport& r) {
            const std::vector<MoverId> ids = r.touching_movers();
            return py::array_t<std::uint32_t>(static_cast<py::ssize_t>(ids.size()), ids.data());
          },
          "(n,) uint32: movers that touch anything, ascending; a copy.")
      .field("coverage", &StepReport::coverage, "Coverage.")
      .field("scope", &StepReport::scope, "StepScope that was requested.")
      .field("mover_mover", &StepReport::mover_mover, "Movers were compared with each other.")
      .field("clearance", &StepReport::clearance, "That was requested.")
      .field("queries", &StepReport::queries, "Pairs of bodies that were compared.")
      .field("box_pairs", &StepReport::box_pairs, "Pairs of bodies whose boxes meet.")
      .field("gap_queries", &StepReport::gap_queries,
             "Pairs of bodies whose distance was computed; not in queries.")
      .field("cost", &StepReport::cost, "Cost.");
  report.def("hash", &StepReport::hash, "hash() -> int\n\nFNV-1a 64 over both lists of contacts.");
}

}  // namespace soms::python
