// Figures 4.30 and 4.44: trees as boxes, level by level.
#include "soms/tree/build.h"

#include "thesis/experiments/experiments.h"
#include "thesis/pictures/tree_pictures.h"
#include "thesis/run/counts.h"
#include "thesis/trips/contenders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace soms::reproduce {

namespace {

constexpr std::array<int, 4> kObjectLevels{1, 3, 5, 6};
constexpr std::array<int, 4> kSceneLevels{1, 3, 5, 7};

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

/// The boxes of a tree at some levels, which go into the table too.
Figure levels_figure(std::string id, const Model& model, const Contender& rule, const Tree& tree,
                     Drawing drawing, std::span<const int> levels, Table& table) {
  drawing.keys = level_keys();
  std::string alt;
  std::string names;
  for (const int level : levels) {
    drawing.panels.push_back(
        level_panel(*model.mesh, tree, level,
                    fmt::format("Level {}{}", level, level == 1 ? ": one big box" : "")));
    alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
    names += fmt::format("{}{}",
                         names.empty()            ? ""
                         : level == levels.back() ? " and "
                                                  : ", ",
                         level);
    add_row(table, model, rule, level, count_level(tree, level));
  }
  return {.id = std::move(id),
          .caption = fmt::format("Boxes of the tree of {} at levels {}.", rule.title, names),
          .svg = draw(drawing),
          .alt = alt};
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
    check_stop(context.limits);
    const Tree tree = build(*bunny.mesh, rule.options);
    const bool of_soms = rule.options.rule == Rule::soms;
    result.figures.push_back(
        levels_figure(of_soms ? "figure_4_30" : "figure_4_30_" + rule.name, bunny, rule, tree,
                      {.title = fmt::format("Tree of {}, {}", rule.title, bunny.name),
                       .view = axonometric(UpAxis::y)},
                      kObjectLevels, result.tables[0]));
  }
  return result;
}

Result figure_4_44(const Context& context) {
  const Model& city = context.models.scenes.front();
  Result result;
  result.tables = {levels_table(
      "figure_4_44_levels", "Boxes of the city's trees at levels 1, 3, 5 and 7, thesis' options.")};
  // SOMS, which the thesis draws, and spatial median to compare with.
  for (const Rule drawn : {Rule::soms, Rule::spatial_median}) {
    for (const Contender& rule : thesis_rules(kSceneLevel)) {
      check_stop(context.limits);
      if (rule.options.rule == drawn) {
        const Tree tree = build(*city.mesh, rule.options);
        result.figures.push_back(levels_figure(
            drawn == Rule::soms ? "figure_4_44" : "figure_4_44_" + rule.name, city, rule, tree,
            {.title = fmt::format("Tree of {}, {}", rule.title, short_title(city)),
             .view = axonometric(UpAxis::z)},
            kSceneLevels, result.tables[0]));
      }
    }
  }
  result.remarks = {
      "Which levels the thesis' figure 4.44 shows is not known. Levels 1, 3, 5 and 7 are ours: 7 "
      "is "
      "the level that the caption of figure 5.5 names. Dashed boxes are leaves that ended above "
      "the level."};
  return result;
}

}  // namespace soms::reproduce
