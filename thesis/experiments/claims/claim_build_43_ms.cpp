// The claim that the tree of 948 triangles is built in 43 ms.
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/trees/build_race.h"

#include <fmt/format.h>

#include <utility>

namespace soms::reproduce {

namespace {

int soms_balanced_level(const Model& model, const Limits& limits) {
  return balanced_level(model, thesis_rules(kObjectLevel).back(), limits);
}

std::string reading_of(Builder builder, int level) {
  return fmt::format("{}, level {}", title_of(builder), level);
}

std::vector<ClaimRow> rows_of(std::span<const Race> races, const Model& object) {
  std::vector<ClaimRow> rows;
  for (const Race& one : races) {
    rows.push_back(
        on_model(measured_row(reading_of(one.builder, one.level), "time of the tree by SOMS", {},
                              "ms", demand_of("build_43_ms"),
                              estimate(one.soms.timing.rounds, one.soms.timing.processes)),
                 object, "a time of a program on a machine of its time, and neither is available"));
  }
  return rows;
}

}  // namespace

Result claim_build_43_ms(const Context& context) {
  const Model* const given = named_model(context.models.objects, kObjectTriangles);
  const Model& object = given != nullptr ? *given : context.models.objects.front();
  const int rounds = context.quick ? 20 : 100;
  Steps steps(context.limits, 2 * race_steps(*context.races, rounds));
  std::vector<Race> races;
  const int balanced = soms_balanced_level(object, steps.quiet());
  for (const int level : {balanced, kObjectLevel}) {
    const std::vector<Race> of_level = race(*context.races, {&object, level}, rounds, steps);
    races.insert(races.end(), of_level.begin(), of_level.end());
  }
  Claim claim = judged(thesis_claim("build_43_ms"), rows_of(races, object),
                       reading_of(Builder::thesis_like, balanced));
  claim.why =
      "Builds are timed at SOMS' balanced level and at the greatest; the thesis says neither the "
      "level nor what the time includes.";
  return {.claims = {std::move(claim)}};
}

}  // namespace soms::reproduce
