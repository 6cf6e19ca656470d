// Tables 5.5 and 5.11: nodes that a rule cannot divide.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/count_charts.h"

#include <fmt/format.h>

#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 12> kUndividableColumns{
    "model",      "origin", "triangles", "rule",        "midpoint", "axis_from",
    "empty_side", "level",  "nodes",     "undividable", "empty",    "largest_leaf"};

constexpr std::array kStopAndChain{EmptySide::stop, EmptySide::chain};

std::vector<Contender> stop_and_chain(int level) {
  return with_each(all_builds(level), kStopAndChain);
}

}  // namespace

Result table_5_5(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  const std::vector<Counted> counts =
      count_all(objects, at_every_level(kObjectLevel, stop_and_chain), context.limits);
  const Model& bunny = objects.front();
  return {.tables = {count_table(
              "table_5_5",
              "Nodes that cannot be divided by greatest level: undividable is the nodes whose rule "
              "left one side empty; with chain, empty is the nodes without triangles." +
                  note_on_stand_ins(objects),
              kUndividableColumns, counts)},
          .figures = {{.id = "table_5_5",
                       .caption = fmt::format("Nodes that cannot be divided, {}, empty side stop.",
                                              label_of(bunny)),
                       .svg = lines_by_level("Nodes that cannot be divided", "nodes", bunny, counts,
                                             undividable)}}};
}

Result table_5_11(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  const std::vector<Counted> counts = count_all(
      scenes, with_each(all_builds_and_axes(kSceneLevel), kAllEmptySides), context.limits);
  const std::string note = note_on_stand_ins(scenes);
  return {.tables = {count_table("table_5_11",
                                 fmt::format("Nodes that cannot be divided, urban scenes at level "
                                             "{}.{}",
                                             kSceneLevel, note),
                                 kUndividableColumns, counts)},
          .figures = {
              {.id = "table_5_11",
               .caption = fmt::format(
                   "Nodes that cannot be divided at level {}. One near the root is worse than a "
                   "thousand at the bottom: see column largest_leaf.{}{}",
                   kSceneLevel, kComparedOptions, note),
               .svg = bars_of("Nodes that cannot be divided", "nodes", with_usual_options(counts),
                              undividable)}}};
}

}  // namespace soms::reproduce
