// Tables 5.4 and 5.10: leaves with fewer than five triangles, which the thesis calls balance mode.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/count_charts.h"

#include <fmt/format.h>

#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 12> kLeafSizeColumns{
    "model",      "origin", "triangles", "rule", "midpoint",    "axis_from",
    "empty_side", "level",  "leaves",    "lt5",  "lt5_percent", "largest_leaf"};

}  // namespace

Result table_5_4(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  const std::vector<Counted> counts =
      count_all(objects, at_every_level(kObjectLevel, all_builds), context.limits);
  const Model& bunny = objects.front();
  return {.tables = {count_table(
              "table_5_4",
              "Leaves with fewer than five triangles by greatest level; lt5_percent is their share "
              "of the leaves." +
                  note_on_stand_ins(objects),
              kLeafSizeColumns, counts)},
          .figures = {{.id = "table_5_4",
                       .caption = fmt::format("Share of leaves with fewer than five triangles, {}.",
                                              label_of(bunny)),
                       .svg = lines_by_level("Leaves with fewer than five triangles",
                                             "% of all leaves", bunny, counts, lt5_percent)}}};
}

Result table_5_10(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  const std::vector<Counted> counts = count_all(
      scenes, with_each(all_builds_and_axes(kSceneLevel), kAllEmptySides), context.limits);
  const std::string note = note_on_stand_ins(scenes);
  return {
      .tables = {count_table(
          "table_5_10",
          fmt::format("Leaves with fewer than five triangles, urban scenes at level {}; "
                      "lt5_percent is their share of the leaves.{}",
                      kSceneLevel, note),
          kLeafSizeColumns, counts)},
      .figures = {{.id = "table_5_10",
                   .caption = fmt::format("Leaves with fewer than five triangles at level {}.{}{}",
                                          kSceneLevel, kComparedOptions, note),
                   .svg = bars_of("Leaves with fewer than five triangles", "leaves",
                                  with_usual_options(counts), lt5)}}};
}

}  // namespace soms::reproduce
