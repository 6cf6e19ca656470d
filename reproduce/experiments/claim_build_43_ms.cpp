// The claim that the tree of 948 triangles is built in 43 ms.
#include "reproduce/build_race.h"
#include "reproduce/counts.h"
#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

#include <utility>

namespace soms::reproduce {

namespace {

constexpr double kClaimedBuildMs = 43;

/// 43 ms is a rounded number.
constexpr Demand kRounded{.above = kClaimedBuildMs - 0.5, .below = kClaimedBuildMs + 0.5};

int soms_balanced_level(const Model& model, const Parallel& parallel) {
  return balanced_level(model, thesis_rules(kObjectLevel).back(), parallel);
}

std::vector<ClaimRow> rows_of(std::span<const Race> races, const Model& object) {
  const std::string trouble = not_the_object_of_948(object);
  std::vector<ClaimRow> rows;
  for (const Race& one : races) {
    rows.push_back(measured_row(fmt::format("{}, level {}", title_of(one.builder), one.level),
                                "time of the tree by SOMS", label_of(object), "ms", kRounded,
                                estimate(one.soms.timing.rounds, one.soms.timing.processes)));
    rows.back().unjudged =
        fmt::format("a time of a program on a machine of its time, and neither is available{}{}",
                    trouble.empty() ? "" : "; ", trouble);
  }
  return rows;
}

}  // namespace

Result claim_build_43_ms(const Context& context) {
  const Model* const given = original_of(context.models.objects, 948);
  const Model& object = given != nullptr ? *given : context.models.objects.front();
  const int rounds = context.quick ? 20 : 100;
  Steps steps(context.parallel, 2 * race_steps(*context.races, rounds));
  std::vector<Race> races;
  for (const int level : {soms_balanced_level(object, steps.quiet()), kObjectLevel}) {
    const std::vector<Race> of_level = race(*context.races, {&object, level}, rounds, steps);
    races.insert(races.end(), of_level.begin(), of_level.end());
  }
  return {.claims = {{.id = "build_43_ms",
                      .statement = "SOMS builds the tree of 948 triangles in 43 ms",
                      .source = "abstract",
                      .rows = rows_of(races, object),
                      .why = "Builds are timed at SOMS' balanced level and at the greatest; the "
                             "thesis says neither the level nor what the time includes.",
                      .settles = "the thesis' program on a machine of its time"}}};
}

}  // namespace soms::reproduce
