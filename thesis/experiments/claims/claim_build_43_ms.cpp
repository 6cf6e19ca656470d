// The claim that the tree of 948 triangles is built in 43 ms.
#include "thesis/claims/judged_subjects.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/trees/build_race.h"

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

std::string reading_of(Builder builder, int level) {
  return fmt::format("{}, level {}", title_of(builder), level);
}

std::vector<ClaimRow> rows_of(std::span<const Race> races, const Model& object) {
  std::vector<ClaimRow> rows;
  for (const Race& one : races) {
    rows.push_back(measured_row(reading_of(one.builder, one.level), "time of the tree by SOMS", {},
                                "ms", kRounded,
                                estimate(one.soms.timing.rounds, one.soms.timing.processes)));
    set_subject(rows.back(), object);
    rows.back().unjudged = "a time of a program on a machine of its time, and neither is available";
  }
  return rows;
}

}  // namespace

Result claim_build_43_ms(const Context& context) {
  const Model* const given = named_model(context.models.objects, kObjectTriangles);
  const Model& object = given != nullptr ? *given : context.models.objects.front();
  const int rounds = context.quick ? 20 : 100;
  Steps steps(context.parallel, 2 * race_steps(*context.races, rounds));
  std::vector<Race> races;
  const int balanced = soms_balanced_level(object, steps.quiet());
  for (const int level : {balanced, kObjectLevel}) {
    const std::vector<Race> of_level = race(*context.races, {&object, level}, rounds, steps);
    races.insert(races.end(), of_level.begin(), of_level.end());
  }
  Claim claim{.id = "build_43_ms",
              .statement = "SOMS builds the tree of 948 triangles in 43 ms",
              .source = "abstract",
              .rows = rows_of(races, object),
              .scope = Scope::figure,
              .named_triangles = kObjectTriangles,
              .nearest = reading_of(Builder::thesis_like, balanced),
              .why_nearest =
                  "The captions of chapter 4 describe a builder that copies lists, and figure 5.3 "
                  "times the objects at SOMS' balanced level.",
              .why =
                  "Builds are timed at SOMS' balanced level and at the greatest; the thesis says "
                  "neither the level nor what the time includes.",
              .settles = "the thesis' program on a machine of its time"};
  judge_subjects(claim);
  return {.claims = {std::move(claim)}};
}

}  // namespace soms::reproduce
