// Rows of the questions about points and rays beside a body, loops over their tables.
#include "tests/golden/golden.h"
#include "tests/support/truth/probe_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace soms::golden {

namespace {

/// What the questions about one kind of probe say of a model at all its poses.
template <class Probe>
void add_probed_model(std::span<const ProbedModel> poses, const Inputs& inputs,
                      const Limits& limits, Rows& rows) {
  const std::string& name = poses.front().model;
  const std::array layouts{Layout::wide, Layout::compact};
  for (const Layout layout : layouts) {
    const Shape shape(inputs.models.at(name), {.layout = layout}, limits);
    for (const test::ProbeRow<Probe>& row : test::probe_table<Probe>(Body(shape))) {
      Answered answered(row);
      for (const ProbedModel& at : poses) {
        const test::BatchAnswer batch =
            row.ask_batch(Body(shape, at.pose), test::of_kind<Probe>(at.probes), {}, limits);
        for (const test::Answer& answer : batch.answers) {
          answered.add(answer);
        }
      }
      answered.write(layout == Layout::wide ? "" : " compact", name, rows);
    }
  }
}

}  // namespace

void add_probe_answers(const Inputs& inputs, const Limits& limits, Rows& rows) {
  for (auto first = inputs.probed.begin(); first != inputs.probed.end();) {
    const auto behind = std::find_if(first, inputs.probed.end(), [&](const ProbedModel& at) {
      return at.model != first->model;
    });
    const std::span<const ProbedModel> poses(&*first, static_cast<std::size_t>(behind - first));
    add_probed_model<Vec3>(poses, inputs, limits, rows);
    add_probed_model<Ray>(poses, inputs, limits, rows);
    first = behind;
  }
}

}  // namespace soms::golden
