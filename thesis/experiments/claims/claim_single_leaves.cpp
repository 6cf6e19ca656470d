// SOMS produces more leaf nodes with a single triangle than spatial median.
//
// Tables 5.3 and 5.9 count at the greatest level (15 for objects, 13 for the scene), so this level
// is judged, on the axis between the midpoints. The outer axis and every level below are shown
// beside it: a tree of few levels cannot part all triangles, whatever the rule. Levels at which
// neither rule has a leaf with one triangle yet are left out: there is nothing to compare. What
// becomes of a node that a rule cannot divide is open and decides by how much SOMS is ahead.
#include "apps/draw/chart.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/run/steps.h"
#include "thesis/trees/open_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace soms::reproduce {

namespace {

/// Counts of both rules at one level.
struct Both {
  TreeStatistics soms = {};
  TreeStatistics spatial = {};

  [[nodiscard]] double lead() const {
    return static_cast<double>(soms.one) - static_cast<double>(spatial.one);
  }
};

/// A model with its ladder under empty side `stop`: what the figures show.
struct Ladder {
  const Model* model = nullptr;
  std::vector<Both> levels = {};  ///< [i] at level i + 1
};

Both both_of(const Model& model, int level, const OpenOptions& open, const Limits& limits) {
  return {counts_of(*model.mesh, Rule::soms, level, open, limits),
          counts_of(*model.mesh, Rule::spatial_median, level, open, limits)};
}

ClaimRow row_of(std::string reading, const Model& model, const Both& both,
                std::string_view unjudged) {
  return on_model(counted_row(std::move(reading), "lead of SOMS in leaves with one triangle", {},
                              "", demand_of("more_single_leaves"), both.lead()),
                  model, unjudged);
}

std::vector<ClaimRow> rows_at_greatest(std::span<const Leveled> models, Steps& steps) {
  std::vector<ClaimRow> rows;
  for (const EmptySide empty_side : kEmptySides) {
    for (const AxisFrom axis : kSomsAxes) {
      for (const auto& [model, level] : models) {
        rows.push_back(row_of(fmt::format("greatest level, {}", words_of(empty_side, axis)), *model,
                              both_of(*model, level, {axis, empty_side}, steps.quiet()),
                              axis_unjudged(axis)));
      }
    }
    steps.done_one();
  }
  return rows;
}

/// Why a level below the greatest is not judged.
std::string unjudged_below(const Model& model, int level) {
  const bool too_few = (std::size_t{1} << (level - 1)) < model.mesh->triangles.size();
  return fmt::format("tables 5.3 and 5.9 count at the greatest level{}",
                     too_few ? ", and a tree of so few levels cannot part all triangles" : "");
}

/// The rows below the greatest level, from deep to shallow, where a rule has a leaf with one
/// triangle; fills in the ladders of `stop`.
std::vector<ClaimRow> rows_below(std::span<const Leveled> models, std::vector<Ladder>& ladders,
                                 Steps& steps) {
  std::vector<ClaimRow> rows;
  for (const EmptySide empty_side : kEmptySides) {
    for (int level = kObjectLevel; level >= 1; --level) {
      for (std::size_t i = 0; i < models.size(); ++i) {
        if (level > models[i].level) {
          continue;
        }
        const Model& model = *models[i].model;
        const Both both = both_of(model, level, {AxisFrom::inner, empty_side}, steps.quiet());
        if (empty_side == EmptySide::stop) {
          ladders[i].levels.insert(ladders[i].levels.begin(), both);
        }
        if (level < models[i].level && both.soms.one + both.spatial.one > 0) {
          rows.push_back(
              row_of(fmt::format("level {}, {}", level, words_of(empty_side, AxisFrom::inner)),
                     model, both, unjudged_below(model, level)));
        }
      }
      steps.done_one();
    }
  }
  return rows;
}

/// "bunny from level 10 on (balanced level 6; fewer at 7, 9)": when the gain of a ladder begins for
/// good, and where it is a loss.
std::string ladder_words(const Ladder& ladder) {
  std::string fewer;
  std::size_t from = ladder.levels.size();
  for (std::size_t i = ladder.levels.size(); i-- > 0;) {
    from = ladder.levels[i].lead() > 0 && from == i + 1 ? i : from;
  }
  for (std::size_t i = 0; i < ladder.levels.size(); ++i) {
    if (ladder.levels[i].lead() < 0) {
      fewer += fmt::format("{}{}", fewer.empty() ? "; fewer at " : ", ", i + 1);
    }
  }
  const std::string start =
      from == ladder.levels.size() ? "at no level" : fmt::format("from level {} on", from + 1);
  return fmt::format("{} {} (balanced level {}{})", ladder.model->name, start,
                     ladder.levels.back().soms.balanced_level, fewer);
}

/// Where the gain begins on each model, as far as levels go.
std::string note_of(std::span<const Ladder> ladders) {
  std::string where;
  for (const Ladder& ladder : ladders) {
    where += fmt::format("{}{}", where.empty() ? "" : "; ", ladder_words(ladder));
  }
  return where.empty() ? where
                       : fmt::format(
                             "With empty side stop SOMS has more: {}. Fewer levels are "
                             "shown, not judged.",
                             where);
}

/// Triangles alone in a leaf, and why the other leaves have several.
struct Ends {
  std::uint64_t alone = 0;
  std::uint64_t several = 0;
  std::uint64_t stuck = 0;
  std::uint64_t capped = 0;

  void add(const TreeStatistics& counts) {
    alone += counts.one;
    several += counts.leaves - counts.one;
    stuck += counts.undividable;
    capped += counts.capped;
  }
};

std::string why_of(std::span<const Ladder> ladders) {
  Ends soms;
  Ends spatial;
  std::size_t triangles = 0;
  for (const Ladder& ladder : ladders) {
    triangles += ladder.model->mesh->triangles.size();
    soms.add(ladder.levels.back().soms);
    spatial.add(ladder.levels.back().spatial);
  }
  return fmt::format(
      "SOMS gains where spatial median has stopped: at deep levels, and the more the less is done "
      "for a node that a rule cannot divide. Where both still divide nearly every node, around the "
      "balanced level of most models, it is a matter of the model which leaves more alone. Not "
      "even SOMS leaves each triangle alone: at the greatest level, with empty side stop, it does "
      "so with {} of {} triangles on all models together, and of its other {} leaves {} hold "
      "triangles of one midpoint and {} are where the levels end. Spatial median leaves {} alone, "
      "and of its other {} leaves it cannot divide {}, and {} are where the levels end. The "
      "greatest level is {} for objects and {} for scenes.{}",
      words(soms.alone), words(triangles), words(soms.several), words(soms.stuck),
      words(soms.capped), words(spatial.alone), words(spatial.several), words(spatial.stuck),
      words(spatial.capped), kObjectLevel, kSceneLevel, kReadingWords);
}

double share(const Ladder& ladder, double leaves) {
  return 100 * leaves /
         static_cast<double>(std::max<std::size_t>(1, ladder.model->mesh->triangles.size()));
}

Figure difference_figure(std::span<const Ladder> ladders) {
  LineChart chart{.title = "What SOMS gains in leaves with one triangle",
                  .x_label = "greatest level",
                  .y_label = "SOMS - spatial median, % of all triangles"};
  for (const Ladder& ladder : ladders) {
    Line line{.name = label_of(*ladder.model), .dashed = ladder.model->stand_in};
    for (std::size_t i = 0; i < ladder.levels.size(); ++i) {
      line.x.push_back(static_cast<double>(i + 1));
      line.y.push_back(share(ladder, ladder.levels[i].lead()));
    }
    chart.lines.push_back(std::move(line));
  }
  return {.id = "claim_single_leaves",
          .caption =
              "Triangles alone in a leaf, SOMS minus spatial median, by greatest level, with "
              "empty side stop. The gain is one of deep trees.",
          .svg = draw(chart)};
}

/// SOMS over spatial median, where both have some: levels with fewer lie below 1.
Figure ratio_figure(std::span<const Ladder> ladders) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LineChart chart{.title = "SOMS over spatial median, level by level",
                  .x_label = "greatest level",
                  .y_label = "leaves with one triangle, SOMS / spatial median",
                  .y_scale = Scale::log};
  std::string left_out;
  for (const Ladder& ladder : ladders) {
    Line line{.name = label_of(*ladder.model), .dashed = ladder.model->stand_in};
    bool any = false;
    for (std::size_t i = 0; i < ladder.levels.size(); ++i) {
      const Both& at = ladder.levels[i];
      const bool both = at.soms.one > 0 && at.spatial.one > 0;
      any = any || both;
      line.x.push_back(static_cast<double>(i + 1));
      line.y.push_back(both ? static_cast<double>(at.soms.one) / static_cast<double>(at.spatial.one)
                            : kNone);
    }
    if (any) {
      chart.lines.push_back(std::move(line));
    } else {
      left_out += fmt::format("{}{}", left_out.empty() ? "" : ", ", ladder.model->name);
    }
  }
  return {.id = "claim_single_leaves_ratio",
          .caption = fmt::format("Leaves with one triangle, SOMS over spatial median, by greatest "
                                 "level, with empty side stop, where both rules have some; below 1 "
                                 "SOMS has fewer.{}",
                                 left_out.empty() ? ""
                                                  : fmt::format(" Without a line, for spatial "
                                                                "median or SOMS has none: {}.",
                                                                left_out)),
          .svg = draw(chart)};
}

}  // namespace

Result claim_single_leaves(const Context& context) {
  const std::vector<Leveled> models = at_greatest_level(context.models);
  std::vector<Ladder> ladders;
  ladders.reserve(models.size());
  for (const Leveled& one : models) {
    ladders.push_back({one.model});
  }
  Steps steps(context.limits, kEmptySides.size() * (1 + kObjectLevel));
  std::vector<ClaimRow> rows = rows_at_greatest(models, steps);
  const std::vector<ClaimRow> below = rows_below(models, ladders, steps);
  rows.insert(rows.end(), below.begin(), below.end());
  Claim claim = judged(thesis_claim("more_single_leaves"), std::move(rows));
  claim.note = note_of(ladders);
  claim.why = why_of(ladders);
  claim.revision = Revision{Verdict::holds, "it was judged on the objects alone, not on scenes"};
  return {.figures = {difference_figure(ladders), ratio_figure(ladders)},
          .claims = {std::move(claim)}};
}

}  // namespace soms::reproduce
