// Where triangles differ in size, spatial median stops and SOMS goes on without a fallback.
//
// The thesis says so four times (chapter 1, figures 4.3 and 4.6, tables 5.5 and 5.11), and it is
// one property, so it is one matrix. A rule is stuck at a node if its plane leaves one side empty
// although the midpoints of the triangles differ: nodes of a single midpoint, which no plane parts,
// count for neither rule. The claim has two halves, and each is a metric: SOMS is stuck nowhere,
// spatial median somewhere. Trying the other axes (`next_axis`) may be called a fallback or not, so
// both are readings; object median in the place of the rule is a fallback without doubt and none.
#include "soms/generate/spread.h"
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"

#include "reproduce/chart.h"
#include "reproduce/counts.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/grouped_bars.h"
#include "reproduce/open_options.h"
#include "reproduce/steps.h"
#include "reproduce/stuck_nodes.h"
#include "reproduce/toy_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array kMidpoints{Midpoint::thesis, Midpoint::centroid, Midpoint::aabb};
constexpr std::array kWithoutFallback{EmptySide::stop, EmptySide::next_axis};
constexpr std::uint64_t kSpreadTriangles = 5000;

/// What the rows are counted on.
struct Subject {
  std::string name;
  Model model = {};
  int level = kObjectLevel;
  std::string unjudged = {};
};

Model model_of(Mesh mesh) {
  Model model;
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

std::vector<Subject> subjects_of(const Models& models) {
  std::vector<Subject> subjects;
  for (const auto& [model, level] : at_greatest_level(models)) {
    subjects.push_back({label_of(*model), *model, level});
  }
  for (const double ratio : {1.0, 10.0, 100.0, 1000.0, 10'000.0}) {
    subjects.push_back(
        {fmt::format("spread of edges 1 to {:.0f}", ratio),
         model_of(generate_spread({.triangles = kSpreadTriangles, .ratio = ratio})), kObjectLevel,
         ratio > 1 ? "" : "its triangles are all of one size, and the claim is about others"});
  }
  std::vector<ToySet> toys = flat_toy_sets();
  toys.push_back(solid_toy_set());
  for (ToySet& toy : toys) {
    const ToySplit split = split_toy(toy.mesh, Rule::soms);
    if (toy.unlike && split.inner.lower != split.inner.upper) {
      subjects.push_back({"toy set " + toy.name, model_of(std::move(toy.mesh))});
    }
  }
  return subjects;
}

StuckNodes stuck(const Subject& subject, Rule rule, const OpenOptions& open,
                 const Parallel& parallel) {
  const Mesh& mesh = *subject.model.mesh;
  const BuildOptions options = options_of(rule, subject.level, open);
  return stuck_nodes(build(mesh, options, {1, parallel.stop, {}}), mesh, options);
}

/// "stop, inner axis, midpoint thesis".
std::string reading_of(AxisFrom axis, const OpenOptions& open) {
  return fmt::format("{}, midpoint {}{}", words_of(open.empty_side, axis), name(open.midpoint),
                     open.midpoint == Midpoint::thesis ? "" : " (ours)");
}

ClaimRow row_of(const Subject& subject, Rule rule, const OpenOptions& open,
                const Parallel& parallel) {
  const bool of_soms = rule == Rule::soms;
  const StuckNodes count = stuck(subject, rule, open, parallel);
  ClaimRow row = counted_row(
      reading_of(of_soms ? open.soms_axis : AxisFrom::outer, open),
      fmt::format("nodes where {} is stuck", of_soms ? "SOMS" : "spatial median"), subject.name, "",
      of_soms ? Demand{.below = 1} : Demand{.above = 0}, static_cast<double>(count.partable));
  row.unjudged = subject.unjudged;
  return row;
}

/// The inner axis needs no `next_axis`: where all midpoints agree on the longest axis of their box
/// they agree on all.
bool says_more(const OpenOptions& open) {
  return open.soms_axis == AxisFrom::outer || open.empty_side == EmptySide::stop;
}

std::vector<ClaimRow> rows_of(std::span<const Subject> subjects, const Parallel& parallel) {
  std::vector<ClaimRow> rows;
  Steps steps(parallel, kMidpoints.size() * kWithoutFallback.size() * subjects.size());
  for (const Midpoint midpoint : kMidpoints) {
    for (const EmptySide empty_side : kWithoutFallback) {
      for (const Subject& subject : subjects) {
        for (const AxisFrom axis : kSomsAxes) {
          const OpenOptions open{axis, empty_side, midpoint};
          if (says_more(open)) {
            rows.push_back(row_of(subject, Rule::soms, open, steps.quiet()));
          }
        }
        rows.push_back(row_of(subject, Rule::spatial_median,
                              {AxisFrom::inner, empty_side, midpoint}, steps.quiet()));
        steps.done_one();
      }
    }
  }
  return rows;
}

/// Sum of a metric's rows with this reading, over what is judged.
double sum_of(const Claim& claim, std::string_view rule, std::string_view reading) {
  double sum = 0;
  for (const ClaimRow& row : claim.rows) {
    if (row.unjudged.empty() && row.reading == reading &&
        row.metric.find(rule) != std::string::npos) {
      sum += row.value;
    }
  }
  return sum;
}

/// What spatial median does where only the sizes change: from one size to edges far apart.
std::string spread_words(std::span<const Subject> subjects, const Parallel& parallel) {
  const auto is_spread = [](const Subject& subject) { return subject.name.starts_with("spread"); };
  const auto alike = std::find_if(subjects.begin(), subjects.end(), is_spread);
  const auto unlike = std::find_if(subjects.rbegin(), subjects.rend(), is_spread);
  const StuckNodes from = stuck(*alike, Rule::spatial_median, {}, parallel);
  const StuckNodes to = stuck(*unlike, Rule::spatial_median, {}, parallel);
  return fmt::format(
      "Unlike sizes are not what it takes to stop spatial median, but they decide where it stops: "
      "on triangles of one size it is stuck at {} nodes of at most {} triangles, on the {} at {} "
      "nodes of up to {}.",
      words(from.partable), words(from.largest), unlike->name, words(to.partable),
      words(to.largest));
}

Claim claim_of(std::span<const Subject> subjects, const Parallel& parallel) {
  Claim claim{.id = "no_fallback",
              .statement =
                  "Where triangles differ in size, spatial median stops and SOMS goes on "
                  "without a fallback",
              .source =
                  "chapter 1 (problem); figures 4.3 and 4.6, tables 5.5 and 5.11 by their "
                  "captions",
              .rows = rows_of(subjects, parallel)};
  const auto total = [&](std::string_view rule, AxisFrom axis, EmptySide empty_side) {
    return words(static_cast<std::uint64_t>(
        sum_of(claim, rule, reading_of(axis, {.soms_axis = axis, .empty_side = empty_side}))));
  };
  claim.nearest = "stop, inner axis, midpoint thesis";
  claim.why = fmt::format(
      "A rule is stuck at a node if its plane leaves one side empty although the midpoints of the "
      "triangles differ. SOMS puts its plane between the least and the greatest midpoint of the "
      "inner box's longest "
      "axis, so it fails only where that box is a point. On the longest axis of the outer box all "
      "midpoints may agree, and then it fails as well. Spatial median's plane is the middle of "
      "corners, which may lie far from all midpoints: one large triangle is enough. Over all that "
      "is judged, with the midpoint of the thesis and empty side stop, SOMS is stuck at {} nodes "
      "on the inner axis and at {} on the outer, spatial median at {}. With the other axes tried, "
      "SOMS on the outer axis is stuck at {}, spatial median at {}. {} A reading names the empty "
      "side, the axis "
      "of the rule and the midpoint.",
      total("SOMS", AxisFrom::inner, EmptySide::stop),
      total("SOMS", AxisFrom::outer, EmptySide::stop),
      total("spatial", AxisFrom::outer, EmptySide::stop),
      total("SOMS", AxisFrom::outer, EmptySide::next_axis),
      total("spatial", AxisFrom::outer, EmptySide::next_axis), spread_words(subjects, parallel));
  claim.settles =
      "chapter 4 of the thesis, which says from which box SOMS takes its axis; the abstract (\"the "
      "longest axis between the midpoint of the triangles\") speaks for the inner one";
  claim.revision = Revision{Verdict::holds,
                            "it was judged with SOMS on the inner axis alone, and spatial median "
                            "under empty side stop alone"};
  return claim;
}

Figure figure_of(std::span<const Subject> subjects, const Claim& claim) {
  const std::array readings{
      std::pair{"SOMS", reading_of(AxisFrom::inner, {})},
      std::pair{"SOMS", reading_of(AxisFrom::outer, {.soms_axis = AxisFrom::outer})},
      std::pair{"spatial median", reading_of(AxisFrom::outer, {})}};
  constexpr std::array kNames{"SOMS, inner axis", "SOMS, outer axis", "spatial median"};
  std::vector<Datum> data;
  for (const Subject& subject : subjects) {
    for (std::size_t i = 0; i < readings.size(); ++i) {
      for (const ClaimRow& row : claim.rows) {
        if (row.subject == subject.name && row.reading == readings[i].second &&
            row.metric.find(readings[i].first) != std::string::npos) {
          data.push_back({subject.name, kNames.at(i), row.value});
        }
      }
    }
  }
  return {.id = "claim_fallback",
          .caption =
              "Nodes that a rule cannot divide although their midpoints differ, with the "
              "midpoint of the thesis and empty side stop. One near the root is worse than "
              "a thousand at the bottom.",
          .svg = draw(grouped_bars("Where each rule is stuck", "nodes", data))};
}

}  // namespace

Result claim_fallback(const Context& context) {
  const std::vector<Subject> subjects = subjects_of(context.models);
  Result result;
  result.claims = {claim_of(subjects, context.parallel)};
  result.figures = {figure_of(subjects, result.claims.front())};
  return result;
}

}  // namespace soms::reproduce
