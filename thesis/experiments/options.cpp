// What options that the thesis leaves open do to the counts of spatial median and SOMS.
#include "soms/tree/option_names.h"

#include "apps/draw/grouped_bars.h"
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/count_charts.h"
#include "thesis/run/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 19> kOptionColumns{
    "model",       "origin",    "triangles",    "rule",          "midpoint",
    "c_vertex",    "axis_from", "empty_side",   "root_level",    "level",
    "per_leaf",    "nodes",     "leaves",       "one",           "lt5",
    "undividable", "empty",     "largest_leaf", "balanced_level"};

/// One option with a value other than the thesis'.
struct Change {
  std::string_view option;
  std::string_view value;
  void (*apply)(BuildOptions& options);
};

constexpr std::array kChanges{
    Change{"none", "thesis", [](BuildOptions&) {}},
    Change{"midpoint", "centroid", [](BuildOptions& o) { o.midpoint = Midpoint::centroid; }},
    Change{"midpoint", "aabb", [](BuildOptions& o) { o.midpoint = Midpoint::aabb; }},
    Change{"c_vertex", "0", [](BuildOptions& o) { o.c_vertex = 0; }},
    Change{"c_vertex", "1", [](BuildOptions& o) { o.c_vertex = 1; }},
    Change{"axis_from", "outer", [](BuildOptions& o) { o.axis_from = AxisFrom::outer; }},
    Change{"axis_from", "inner", [](BuildOptions& o) { o.axis_from = AxisFrom::inner; }},
    Change{"empty_side", "next_axis", [](BuildOptions& o) { o.empty_side = EmptySide::next_axis; }},
    Change{"empty_side", "object_median",
           [](BuildOptions& o) { o.empty_side = EmptySide::object_median; }},
    Change{"empty_side", "chain", [](BuildOptions& o) { o.empty_side = EmptySide::chain; }},
    Change{"root_level", "0", [](BuildOptions& o) { o.root_level = 0; }},
    Change{"per_leaf", "2", [](BuildOptions& o) { o.per_leaf = 2; }},
    Change{"per_leaf", "5", [](BuildOptions& o) { o.per_leaf = 5; }},
};

/// Options that no combination has.
bool stands_alone(const Change& change) {
  return change.option == "c_vertex" || change.option == "root_level" ||
         change.option == "per_leaf";
}

/// Spatial median and SOMS, which the thesis compares.
std::vector<Contender> both(int level) {
  std::vector<Contender> rules = thesis_rules(level);
  std::erase_if(rules, [](const Contender& one) {
    return one.options.rule != Rule::spatial_median && one.options.rule != Rule::soms;
  });
  return rules;
}

Contender changed(Contender contender, const Change& change) {
  change.apply(contender.options);
  return contender;
}

/// Every midpoint with every axis and every empty side, then the options that stand alone.
std::vector<Contender> combinations(int level) {
  std::vector<Contender> result;
  for (const Contender& rule : both(level)) {
    for (const Midpoint midpoint : {Midpoint::thesis, Midpoint::centroid, Midpoint::aabb}) {
      for (const AxisFrom axis_from : {AxisFrom::outer, AxisFrom::inner}) {
        for (const EmptySide empty_side :
             {EmptySide::stop, EmptySide::next_axis, EmptySide::object_median, EmptySide::chain}) {
          Contender one = rule;
          one.options.midpoint = midpoint;
          one.options.axis_from = axis_from;
          one.options.empty_side = empty_side;
          result.push_back(one);
        }
      }
    }
    for (const Change& change : kChanges) {
      if (stands_alone(change)) {
        result.push_back(changed(rule, change));
      }
    }
  }
  return result;
}

/// Both rules after one change.
struct Effect {
  const Model* model = nullptr;
  const Change* change = nullptr;
  Counted spatial = {};
  Counted soms = {};
};

std::vector<Cell> row_of(const Effect& effect) {
  const TreeStatistics& spatial = effect.spatial.counts;
  const TreeStatistics& soms = effect.soms.counts;
  const auto integer = [](std::uint64_t value) { return Cell{static_cast<std::int64_t>(value)}; };
  const double base = static_cast<double>(spatial.one);
  return {effect.model->name,
          std::string(effect.change->option),
          std::string(effect.change->value),
          integer(spatial.one),
          integer(soms.one),
          spatial.one == 0 ? Cell{} : Cell{100 * (static_cast<double>(soms.one) / base - 1)},
          integer(spatial.undividable),
          integer(soms.undividable),
          integer(spatial.balanced_level),
          integer(soms.balanced_level)};
}

Table effect_table(std::span<const Effect> effects, const std::string& note) {
  Table table{.id = "options_one_by_one",
              .caption = fmt::format(
                  "Each option changed alone, the others as in the thesis, one triangle a "
                  "leaf among them: nodes with one triangle, nodes that cannot be "
                  "divided and balanced level of both rules. Objects at level {}, "
                  "scenes at {}.{}",
                  kObjectLevel, kSceneLevel, note),
              .columns = {{"model"},
                          {"option"},
                          {"value"},
                          {"spatial_median_one"},
                          {"soms_one"},
                          {"soms_more", "%"},
                          {"spatial_median_undividable"},
                          {"soms_undividable"},
                          {"spatial_median_balanced_level"},
                          {"soms_balanced_level"}}};
  for (const Effect& effect : effects) {
    table.rows.push_back(row_of(effect));
  }
  return table;
}

Figure chart_of(const Model& model, std::span<const Effect> effects) {
  std::vector<Datum> data;
  for (const Effect& effect : effects) {
    if (effect.model == &model) {
      const std::string group =
          effect.change->option == "none"
              ? "thesis' options"
              : fmt::format("{} {}", effect.change->option, effect.change->value);
      data.push_back({group, effect.spatial.contender.title, one_percent(effect.spatial)});
      data.push_back({group, effect.soms.contender.title, one_percent(effect.soms)});
    }
  }
  return {.id = "options_one_by_one",
          .caption = fmt::format("What one option alone changes: triangles alone in a leaf, {} at "
                                 "level {}.",
                                 label_of(model), kObjectLevel),
          .svg = draw(grouped_bars("What one option alone changes",
                                   "% of triangles alone in a leaf", data))};
}

/// Least and greatest gain of SOMS on a model, with the options that give it.
std::string range_of_gain(const Model& model, std::span<const Effect> effects) {
  const auto gain = [](const Effect* effect) {
    return 100 * (static_cast<double>(effect->soms.counts.one) /
                      static_cast<double>(effect->spatial.counts.one) -
                  1);
  };
  std::vector<const Effect*> of_model;
  for (const Effect& effect : effects) {
    if (effect.model == &model && effect.spatial.counts.one > 0) {
      of_model.push_back(&effect);
    }
  }
  if (of_model.empty()) {
    return fmt::format("On {} spatial median has no leaf with one triangle, with each option.",
                       label_of(model));
  }
  const auto [least, most] =
      std::minmax_element(of_model.begin(), of_model.end(),
                          [&](const Effect* a, const Effect* b) { return gain(a) < gain(b); });
  return fmt::format(
      "On {} SOMS' leaves with one triangle are {:+.0f} % ({} {}) to {:+.0f} % ({} {}) against "
      "spatial median's, where that makes any, one option changed at a time.",
      model.name, gain(*least), (*least)->change->option, (*least)->change->value, gain(*most),
      (*most)->change->option, (*most)->change->value);
}

/// Scenes on which SOMS by the middle of triangles' boxes leaves no triangle alone.
std::string box_center_trap(std::span<const Effect> effects) {
  std::string names;
  for (const Effect& effect : effects) {
    if (effect.change->value == "aabb" && effect.soms.counts.one == 0) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", effect.model->name);
    }
  }
  return names.empty() ? ""
                       : fmt::format(
                             "With midpoint aabb SOMS leaves no triangle alone on {}: the "
                             "two triangles of a rectangle share the middle of their box.",
                             names);
}

}  // namespace

Result options(const Context& context) {
  std::vector<std::pair<const Model*, int>> models{{&context.models.objects.front(), kObjectLevel}};
  for (const Model& scene : context.models.scenes) {
    models.emplace_back(&scene, kSceneLevel);
  }
  std::vector<Counted> counts;
  std::vector<Effect> effects;
  Steps steps(context.limits, models.size() * (combinations(1).size() + kChanges.size()));
  for (const auto& [model, level] : models) {
    for (const Contender& contender : combinations(level)) {
      counts.push_back(count(*model, contender, steps.quiet()));
      steps.done_one();
    }
    const std::vector<Contender> rules = both(level);
    for (const Change& change : kChanges) {
      effects.push_back({model, &change,
                         count(*model, changed(rules.front(), change), steps.quiet()),
                         count(*model, changed(rules.back(), change), steps.quiet())});
      steps.done_one();
    }
  }
  std::string note = note_on_stand_ins(std::span(models.front().first, 1));
  note += note_on_stand_ins(context.models.scenes);
  Result result{.tables = {effect_table(effects, note),
                           count_table("options",
                                       "Every combination of midpoint, axis and empty side; vertex "
                                       "C, root level and leaf size (per_leaf) one at a time." +
                                           note,
                                       kOptionColumns, counts)},
                .figures = {chart_of(*models.front().first, effects)}};
  for (const auto& [model, level] : models) {
    result.remarks.push_back(range_of_gain(*model, effects));
  }
  if (const std::string trap = box_center_trap(effects); !trap.empty()) {
    result.remarks.push_back(trap);
  }
  return result;
}

}  // namespace soms::reproduce
