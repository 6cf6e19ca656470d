// Figures 4.30 and 4.41 to 4.44: trees as boxes, level by level.
#include "soms/tree/build.h"

#include "reproduce/contenders.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/tree_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<int, 4> kLevels{1, 3, 5, 6};
constexpr int kObjectLevel = 15;
constexpr int kSceneLevel = 13;

Table levels_table(std::string id, std::string caption) {
  return {.id = std::move(id),
          .caption = std::move(caption),
          .columns = {{"model"},
                      {"rule"},
                      {"level"},
                      {"nodes"},
                      {"leaves_above"},
                      {"fewest_triangles"},
                      {"most_triangles"}}};
}

void add_row(Table& table, const Model& model, const Contender& rule, int level,
             const LevelCount& count) {
  table.rows.push_back({model.name, rule.name, static_cast<std::int64_t>(level), count.nodes,
                        count.ended, count.fewest, count.most});
}

/// The title without what stands in brackets.
std::string short_title(const Model& model) {
  return model.title.substr(0, model.title.find(" ("));
}

/// Spatial median and SOMS on each scene, their boxes at one level side by side.
Result scene_trees(const Context& context, const std::string& number, int level) {
  std::vector<Contender> rules = thesis_rules(kSceneLevel);
  std::erase_if(rules, [](const Contender& rule) {
    return rule.options.rule != Rule::spatial_median && rule.options.rule != Rule::soms;
  });
  Drawing drawing{.title = fmt::format("Trees of the urban scenes at level {}", level),
                  .view = axonometric(UpAxis::z)};
  drawing.same_scale = false;
  drawing.keys = level_keys();
  Table table =
      levels_table(fmt::format("figure_{}_levels", number),
                   fmt::format("Boxes at level {} of trees with the thesis' options.", level));
  std::string alt;
  double done = 0;
  for (const Model& model : context.models.scenes) {
    for (const Contender& rule : rules) {
      check_stop(context.parallel);
      const Tree tree = build(*model.mesh, rule.options);
      drawing.panels.push_back(level_panel(*model.mesh, tree, level,
                                           fmt::format("{}, {}", short_title(model), rule.title)));
      alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
      add_row(table, model, rule, level, count_level(tree, level));
      done += 0.5 / static_cast<double>(context.models.scenes.size());
      if (context.parallel.progress) {
        context.parallel.progress(done);
      }
    }
  }
  Result result;
  result.figures = {{.id = "figure_" + number,
                     .caption = fmt::format("Boxes at level {}: spatial median beside SOMS. Dashed "
                                            "boxes are leaves that ended above the level.",
                                            level),
                     .svg = draw(drawing),
                     .alt = alt}};
  result.tables = {std::move(table)};
  return result;
}

}  // namespace

Result figure_4_30(const Context& context) {
  const Model& bunny = context.models.objects.front();
  Result result;
  result.tables = {
      levels_table("figure_4_30_levels",
                   "Boxes of the bunny's trees at levels 1, 3, 5 and 6, thesis' options.")};
  std::vector<Contender> rules = thesis_rules(kObjectLevel);
  // The thesis draws the tree of SOMS: it comes first.
  std::rotate(rules.begin(), rules.end() - 1, rules.end());
  for (const Contender& rule : rules) {
    check_stop(context.parallel);
    const Tree tree = build(*bunny.mesh, rule.options);
    Drawing drawing{.title = fmt::format("Tree of {}, {}", rule.title, bunny.name),
                    .view = axonometric(UpAxis::y)};
    drawing.keys = level_keys();
    std::string alt;
    for (const int level : kLevels) {
      drawing.panels.push_back(
          level_panel(*bunny.mesh, tree, level,
                      fmt::format("Level {}{}", level, level == 1 ? ": one big box" : "")));
      alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
      add_row(result.tables[0], bunny, rule, level, count_level(tree, level));
    }
    const bool of_soms = rule.options.rule == Rule::soms;
    result.figures.push_back(
        {.id = of_soms ? "figure_4_30" : "figure_4_30_" + rule.name,
         .caption = fmt::format("Boxes of the tree of {} at levels 1, 3, 5 and 6.", rule.title),
         .svg = draw(drawing),
         .alt = alt});
  }
  return result;
}

Result figure_4_41(const Context& context) {
  return scene_trees(context, "4_41", 1);
}

Result figure_4_42(const Context& context) {
  return scene_trees(context, "4_42", 3);
}

Result figure_4_43(const Context& context) {
  return scene_trees(context, "4_43", 5);
}

Result figure_4_44(const Context& context) {
  Result result = scene_trees(context, "4_44", 7);
  result.remarks = {
      "The thesis' figures 4.41 to 4.44 show its city and the city's tree; at which levels is not "
      "known. Levels 1, 3, 5 and 7 are ours: 7 is the level that the caption of figure 5.5 names."};
  return result;
}

}  // namespace soms::reproduce
