// The claim that SOMS builds the tree of the urban scene in less time.
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "reproduce/build_race.h"
#include "reproduce/counts.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/interval_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kLess{.above = 0};

constexpr std::array kPolicies{EmptySide::stop, EmptySide::next_axis, EmptySide::object_median};

constexpr std::array kRules{Rule::spatial_median, Rule::soms};

constexpr int kRounds = 150;
constexpr int kQuickRounds = 25;

/// A level that the thesis times the city at.
struct Occasion {
  int level = 0;  ///< 0: the balanced level of spatial median
  std::string_view words = {};
};

constexpr std::array kOccasions{Occasion{0, "balanced level of spatial median (figure 5.4)"},
                                Occasion{7, "level 7 (figure 5.5)"},
                                Occasion{12, "level 12 (table 5.8)"},
                                Occasion{kSceneLevel, "level 13 (table 5.9)"}};

std::string_view words_of(EmptySide empty_side) {
  switch (empty_side) {
    case EmptySide::next_axis:
      return "other axes where a side is empty";
    case EmptySide::object_median:
      return "object median where a side is empty";
    default:
      return "a node stays whole where a side is empty";
  }
}

Contender contender_of(Rule rule, int level, EmptySide empty_side) {
  BuildOptions options = thesis_options(rule, level);
  options.empty_side = empty_side;
  return {std::string(entry(rule).name), std::string(entry(rule).name), true, options};
}

int level_of(const Occasion& occasion, const Model& scene, EmptySide empty_side,
             const Parallel& parallel) {
  return occasion.level > 0
             ? occasion.level
             : balanced_level(scene, contender_of(Rule::spatial_median, kSceneLevel, empty_side),
                              parallel);
}

/// True if a rule leaves a side empty somewhere: else the readings of it give the same trees.
bool has_empty_sides(const Model& scene, int level, const Parallel& parallel) {
  return std::any_of(kRules.begin(), kRules.end(), [&](Rule rule) {
    return count(scene, contender_of(rule, level, EmptySide::stop), parallel).counts.undividable >
           0;
  });
}

/// A race, with the figure or table that it stands for.
struct Entrant {
  const Occasion* occasion = nullptr;
  RaceTask task = {};
};

std::vector<Entrant> entrants_of(std::span<const Model> scenes, const Parallel& parallel) {
  std::vector<Entrant> entrants;
  for (const Model& scene : scenes) {
    for (const Occasion& occasion : kOccasions) {
      for (const EmptySide empty_side : kPolicies) {
        const int level = level_of(occasion, scene, empty_side, parallel);
        if (empty_side == EmptySide::stop || has_empty_sides(scene, level, parallel)) {
          entrants.push_back({&occasion, {&scene, level, empty_side}});
        }
      }
    }
  }
  return entrants;
}

std::vector<ClaimRow> rows_of(std::span<const Entrant> entrants, std::span<const Race> races) {
  std::vector<ClaimRow> rows;
  for (const Entrant& one : entrants) {
    const std::string reading =
        fmt::format("{}; {}", one.occasion->words, words_of(one.task.empty_side));
    const std::string subject = label_of(*one.task.model);
    const Race& counted = *find_race(races, one.task, Builder::in_place);
    rows.push_back(counted_row(reading, "midpoints compared with planes, saved by SOMS", subject,
                               "%", kLess, gain_in_work(counted)));
    rows.back().unjudged =
        "comparisons are a part of the work and not its time; they are the same on every machine";
    for (const Builder builder : kBuilders) {
      rows.push_back(measured_row(
          reading, fmt::format("time of the tree, saved by SOMS, {}", title_of(builder)), subject,
          "%", kLess, gain(*find_race(races, one.task, builder))));
    }
  }
  return rows;
}

/// Nodes and triangles of the trees, depth by depth.
Table depths_table(std::span<const Model> scenes, const std::string& note) {
  Table table{
      "build_city_depths",
      fmt::format("Where the work is: nodes of each depth and the triangles in them, of all "
                  "nodes and of those that a plane was tried on, at level {}.{}",
                  kSceneLevel, note)};
  for (const char* const column : {"model", "rule", "empty_side", "depth", "nodes", "triangles",
                                   "nodes_tried", "triangles_tried"}) {
    table.columns.push_back({column});
  }
  for (const Model& scene : scenes) {
    for (const Rule rule : kRules) {
      for (const EmptySide empty_side : kPolicies) {
        std::array<std::array<std::int64_t, 4>, kSceneLevel> of_depth = {};
        const Tree tree = build(*scene.mesh, contender_of(rule, kSceneLevel, empty_side).options);
        for (const Node& node : tree.nodes) {
          auto& [nodes, triangles, tried, triangles_tried] = of_depth.at(node.depth);
          const bool was_tried = !node.is_leaf() || node.undividable;
          nodes += 1;
          triangles += node.count;
          tried += was_tried ? 1 : 0;
          triangles_tried += was_tried ? node.count : 0;
        }
        for (std::size_t depth = 0; depth < of_depth.size() && of_depth[depth][0] > 0; ++depth) {
          std::vector<Cell>& row = table.rows.emplace_back(
              std::vector<Cell>{scene.name, std::string(entry(rule).name),
                                std::string(name(empty_side)), static_cast<std::int64_t>(depth)});
          row.insert(row.end(), of_depth[depth].begin(), of_depth[depth].end());
        }
      }
    }
  }
  return table;
}

/// Counts of every scene at the greatest level.
std::string why(std::span<const Model> scenes, std::span<const Race> races) {
  std::string text = fmt::format(
      "A build takes as long as the nodes that it divides are large and many. Where a node stays "
      "whole when a side is empty, spatial median stops at its first large triangle: what it saves "
      "is a tree not built. Chapter 1 speaks of a heuristic that others need to go on, and that "
      "takes time; so the readings with a fallback are the ones it may mean, and they are given to "
      "both rules. Where trees of both rules divide as much, a neutral builder shows the price of "
      "the box of the midpoints, and the library's builder that of the outer boxes which it grows "
      "for spatial median in a pass of their own. Nodes, and midpoints compared with planes, at "
      "level {}, spatial median and SOMS:",
      kSceneLevel);
  std::string_view mark = " ";
  for (const Race& one : races) {
    if (one.level == kSceneLevel && one.builder == Builder::in_place) {
      const Racer& s = one.spatial_median;
      const Racer& o = one.soms;
      text += fmt::format("{}{}, {}, nodes {} and {}, comparisons {} and {}", mark, one.model->name,
                          name(one.empty_side), words(s.counts.nodes), words(o.counts.nodes),
                          words(s.work.compared), words(o.work.compared));
      mark = "; ";
    }
  }
  return scenes.empty() ? "" : text + ".";
}

std::string draw_ratios(std::span<const Race> races) {
  IntervalChart chart{
      .title = fmt::format("Build time of the urban scenes at level {}", kSceneLevel),
      .x_label = "time of SOMS / spatial median",
      .scale = Scale::log,
      .below = 1};
  for (const Race& one : races) {
    if (one.level == kSceneLevel) {
      const Estimate ratio = paired_ratio(one.soms.timing.rounds, one.spatial_median.timing.rounds);
      chart.marks.push_back({one.model->name, std::string(name(one.empty_side)),
                             std::string(title_of(one.builder)), ratio.value, ratio.interval});
    }
  }
  return draw(chart);
}

}  // namespace

Result claim_build_city(const Context& context) {
  const std::vector<Model>& scenes = context.models.scenes;
  const std::vector<Entrant> entrants = entrants_of(scenes, {1, context.parallel.stop, {}});
  const int rounds = context.quick ? kQuickRounds : kRounds;
  Steps steps(context.parallel, entrants.size() * race_steps(rounds));
  std::vector<Race> races;
  for (const Entrant& one : entrants) {
    if (find_race(races, one.task, Builder::library) != nullptr) {
      continue;  // the balanced level is one of the others
    }
    const std::vector<Race> of_task = race(one.task, rounds, steps);
    races.insert(races.end(), of_task.begin(), of_task.end());
  }
  const std::string note = note_on_stand_ins(scenes);
  return {
      .tables = {race_table("build_city",
                            fmt::format("SOMS against spatial median on the urban scenes, builder "
                                        "by builder: midpoints compared with planes, boxes grown, "
                                        "and the median time of a build with its 95 % interval; "
                                        "gain is the time that SOMS saves.{}",
                                        note),
                            races),
                 depths_table(scenes, note)},
      .figures = {{.id = "build_city",
                   .caption =
                       fmt::format("Build time of SOMS over that of spatial median on the "
                                   "urban scenes at level {}, by what happens where a side "
                                   "is empty, with 95 % intervals: above 1 SOMS is slower.{}",
                                   kSceneLevel, note),
                   .svg = draw_ratios(races),
                   .timed = true}},
      .claims = {
          {.id = "build_city",
           .statement = "SOMS builds the tree of the urban scene in less time than spatial "
                        "median",
           .source = "chapter 1, 1.2; figures 5.4 and 5.5 and table 5.8 by their captions",
           .rows = rows_of(entrants, races),
           .nearest = "level 7 (figure 5.5); a node stays whole",
           .why = why(scenes, races),
           .settles = "the thesis' scene, and what its program does where a side is empty"}}};
}

}  // namespace soms::reproduce
