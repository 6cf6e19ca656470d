// Tables 5.3 and 5.9: nodes with one triangle.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/count_charts.h"
#include "thesis/trees/open_options.h"

#include <fmt/format.h>

#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 12> kSingleLeafColumns{
    "model",      "origin", "triangles", "rule",   "midpoint", "axis_from",
    "empty_side", "level",  "nodes",     "leaves", "one",      "one_percent"};

Result tables_of(const std::string& id, std::span<const Model> models, int level,
                 std::span<const Counted> counts) {
  const std::string note = note_on_stand_ins(models);
  const std::string caption = fmt::format(
      "Nodes with one triangle at level {}; one_percent is the share of all triangles that are "
      "alone "
      "in a leaf.{}",
      level, note);
  return {.tables = {count_table(id, caption, kSingleLeafColumns, counts)},
          .figures = {{.id = id,
                       .caption = fmt::format("Triangles alone in a leaf at level {}.{}{}", level,
                                              kComparedOptions, note),
                       .svg = bars_of("Triangles that are alone in a leaf", "% of all triangles",
                                      with_usual_options(counts), one_percent)}}};
}

}  // namespace

Result table_5_3(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  const std::vector<Counted> counts =
      count_all(objects, with_each(all_builds_and_axes(kObjectLevel), kEmptySides), context.limits);
  return tables_of("table_5_3", objects, kObjectLevel, counts);
}

Result table_5_9(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  const std::vector<Counted> counts = count_all(
      scenes, with_each(all_builds_and_axes(kSceneLevel), kAllEmptySides), context.limits);
  return tables_of("table_5_9", scenes, kSceneLevel, counts);
}

}  // namespace soms::reproduce
