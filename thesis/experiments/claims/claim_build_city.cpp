// The claim that SOMS builds the tree of the urban scene in less time.
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "apps/draw/interval_chart.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/trees/build_race.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr Demand kAnyGain = demand_of("build_city");

constexpr std::array kCityRules{Rule::spatial_median, Rule::soms};

constexpr int kRounds = 150;
constexpr int kQuickRounds = 10;

/// A level that the thesis times the city at.
struct Occasion {
  int level = 0;  ///< 0: the balanced level of spatial median
  std::string_view source = {};
};

constexpr std::string_view kBalancedSource = "figure 5.4";

constexpr std::array kOccasions{Occasion{0, kBalancedSource}, Occasion{7, "figure 5.5"},
                                Occasion{12, "table 5.8"}, Occasion{kSceneLevel, "table 5.9"}};

Contender contender_of(Rule rule, int level, EmptySide empty_side) {
  BuildOptions options = thesis_options(rule, level);
  options.empty_side = empty_side;
  return {std::string(entry(rule).name), std::string(entry(rule).name), true, options};
}

/// A scene with the balanced level of its tree by spatial median.
struct Balanced {
  const Model* scene = nullptr;
  int level = 0;
};

std::vector<Balanced> balanced_of(std::span<const Model> scenes, EmptySide empty_side,
                                  const Limits& limits) {
  std::vector<Balanced> balanced;
  balanced.reserve(scenes.size());
  for (const Model& scene : scenes) {
    balanced.push_back(
        {&scene, balanced_level(scene, contender_of(Rule::spatial_median, kSceneLevel, empty_side),
                                limits)});
  }
  return balanced;
}

bool is_fixed_occasion(int level) {
  return std::any_of(kOccasions.begin(), kOccasions.end(),
                     [level](const Occasion& occasion) { return occasion.level == level; });
}

/// The reading of an occasion. Where it is the balanced level, too, it stands for both; the words
/// are the same for all scenes, whose rows make one line.
std::string occasion_words(const Occasion& occasion, std::span<const Balanced> balanced) {
  const auto same = std::count_if(balanced.begin(), balanced.end(), [&](const Balanced& one) {
    return occasion.level > 0 ? one.level == occasion.level : is_fixed_occasion(one.level);
  });
  if (occasion.level == 0) {
    return fmt::format("balanced level of spatial median{} ({})",
                       same > 0 ? ", where it has no row of its own" : "", occasion.source);
  }
  return same == 0
             ? fmt::format("level {} ({})", occasion.level, occasion.source)
             : fmt::format("level {} ({}; {}, too, where it is spatial median's balanced level)",
                           occasion.level, occasion.source, kBalancedSource);
}

/// A race, with the reading that it stands for.
struct Entrant {
  std::string reading;
  RaceTask task = {};
};

/// The entrants of one empty side, occasion by occasion. One race that two occasions ask for is one
/// entrant; an empty side other than `stop` races only where a side is empty.
void add_entrants(std::span<const Model> scenes, EmptySide empty_side, const Limits& limits,
                  std::vector<Entrant>& entrants) {
  const std::vector<Balanced> balanced = balanced_of(scenes, empty_side, limits);
  for (const Occasion& occasion : kOccasions) {
    const std::string reading =
        fmt::format("{}; {}", occasion_words(occasion, balanced), fallback_words(empty_side));
    for (const Balanced& one : balanced) {
      if (occasion.level == 0 && is_fixed_occasion(one.level)) {
        continue;
      }
      const int level = occasion.level > 0 ? occasion.level : one.level;
      if (empty_side == EmptySide::stop || has_empty_sides(*one.scene, level, limits)) {
        entrants.push_back({reading, {one.scene, level, empty_side}});
      }
    }
  }
}

std::vector<Entrant> entrants_of(std::span<const Model> scenes, const Limits& limits) {
  std::vector<Entrant> entrants;
  for (const EmptySide empty_side : kFallbacks) {
    add_entrants(scenes, empty_side, limits, entrants);
  }
  return entrants;
}

/// Why a race says nothing about rules; empty if it does.
std::string_view unjudged_reason(const Race& race) {
  return race.spatial_median.counts.nodes == 1 && race.soms.counts.nodes == 1
             ? "both trees are the root alone: neither rule has divided anything"
             : "";
}

std::vector<ClaimRow> rows_of(std::span<const Entrant> entrants, std::span<const Race> races) {
  std::vector<ClaimRow> rows;
  for (const Entrant& one : entrants) {
    const Race& counted = *find_race(races, one.task, Builder::in_place);
    rows.push_back(
        on_model(counted_row(one.reading, "midpoints compared with planes, saved by SOMS", {}, "%",
                             kAnyGain, gain_in_work(counted)),
                 *one.task.model,
                 "comparisons are a part of the work and not its time; they are the same on every "
                 "machine"));
    for (const Builder builder : kBuilders) {
      const Race& timed = *find_race(races, one.task, builder);
      rows.push_back(on_model(
          measured_row(one.reading,
                       fmt::format("time of the tree, saved by SOMS, {}", reading_of(builder)), {},
                       "%", kAnyGain, gain(timed)),
          *one.task.model, unjudged_reason(timed)));
    }
  }
  return rows;
}

/// The reading of level 7 in which a node stays whole.
std::string nearest_reading(std::span<const Model> scenes, const Limits& limits) {
  return fmt::format("{}; {}",
                     occasion_words(kOccasions[1], balanced_of(scenes, EmptySide::stop, limits)),
                     fallback_words(EmptySide::stop));
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
    for (const Rule rule : kCityRules) {
      for (const EmptySide empty_side : kFallbacks) {
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
      "Where a node stays whole when a side is empty, spatial median's tree can end at a large "
      "triangle near its root: fewer nodes, fewer comparisons and no tree below. Chapter 1 speaks "
      "of "
      "a heuristic that others need to go on, and that takes time; so the readings with a fallback "
      "are the ones it may mean, and they are given to both rules. A node without triangles is "
      "what "
      "table 5.5 counts: the other child has all of them, and is tried again at every level below. "
      "A "
      "neutral builder grows the boxes of the midpoints for SOMS alone; the library's grows them "
      "for "
      "both rules, and for spatial median the boxes of the corners in a pass of their own. A scene "
      "in which no side is empty up to a level has one row there, for its trees are the same "
      "whatever would become of an empty side. Nodes, and midpoints compared with planes, at level "
      "{}, spatial median and SOMS (build_city.csv has all):",
      kSceneLevel);
  std::string_view mark = " ";
  for (const Race& one : races) {
    const bool extreme =
        one.empty_side == EmptySide::stop || one.empty_side == EmptySide::object_median;
    if (extreme && one.level == kSceneLevel && one.builder == Builder::in_place) {
      const RaceHalf& s = one.spatial_median;
      const RaceHalf& o = one.soms;
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
      const Estimate ratio = paired_ratio(one.soms.timing.rounds, one.spatial_median.timing.rounds,
                                          one.soms.timing.processes);
      chart.marks.push_back({one.model->name, std::string(name(one.empty_side)),
                             std::string(title_of(one.builder)), ratio.value, ratio.interval});
    }
  }
  return draw(chart);
}

Claim claim_of(std::span<const Model> scenes, std::span<const Entrant> entrants,
               std::span<const Race> races, const Limits& quiet) {
  const std::string nearest = nearest_reading(scenes, quiet);
  const std::string_view builder = reading_of(Builder::thesis_like);
  std::vector<ClaimRow> rows = rows_of(entrants, races);
  for (ClaimRow& row : rows) {
    row.is_nearest = row.reading == nearest && row.metric.find(builder) != std::string::npos;
  }
  Claim claim =
      judged(thesis_claim("build_city"), std::move(rows), fmt::format("{}; {}", nearest, builder));
  claim.why = why(scenes, races);
  return claim;
}

}  // namespace

Result claim_build_city(const Context& context) {
  const std::vector<Model>& scenes = context.models.scenes;
  const Limits quiet{.threads = 1, .stop = context.limits.stop};
  const std::vector<Entrant> entrants = entrants_of(scenes, quiet);
  const int rounds = context.quick ? kQuickRounds : kRounds;
  Steps steps(context.limits, entrants.size() * race_steps(*context.races, rounds));
  std::vector<Race> races;
  for (const Entrant& one : entrants) {
    const std::vector<Race> of_task = race(*context.races, one.task, rounds, steps);
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
      .claims = {claim_of(scenes, entrants, races, quiet)}};
}

}  // namespace soms::reproduce
