#include "thesis/trees/open_options.h"

#include "soms/tree/build.h"
#include "soms/tree/option_names.h"

#include "thesis/trips/levels.h"

#include <fmt/format.h>

namespace soms::reproduce {

BuildOptions options_of(Rule rule, int level, const OpenOptions& open) {
  BuildOptions options = thesis_options(rule, level);
  options.empty_side = open.empty_side;
  options.midpoint = open.midpoint;
  if (rule == Rule::soms) {
    options.axis_from = open.soms_axis;
  }
  return without_idle(options);
}

std::string words_of(EmptySide empty_side) {
  return std::string(name(empty_side));
}

std::string words_of(EmptySide empty_side, AxisFrom soms_axis) {
  return fmt::format("{}, {} axis", words_of(empty_side), name(soms_axis));
}

std::string axis_unjudged(AxisFrom soms_axis) {
  return soms_axis == AxisFrom::inner
             ? std::string()
             : "the abstract in Malay takes the axis between the midpoints";
}

std::vector<Leveled> at_greatest_level(const Models& models) {
  std::vector<Leveled> leveled;
  for (const Model& object : models.objects) {
    leveled.push_back({&object, kObjectLevel});
  }
  for (const Model& scene : models.scenes) {
    leveled.push_back({&scene, kSceneLevel});
  }
  return leveled;
}

TreeStatistics counts_of(const Mesh& mesh, Rule rule, int level, const OpenOptions& open,
                         const Limits& limits) {
  const BuildOptions options = options_of(rule, level, open);
  return statistics(build(mesh, options, {.threads = 1, .stop = limits.stop}), options);
}

}  // namespace soms::reproduce
