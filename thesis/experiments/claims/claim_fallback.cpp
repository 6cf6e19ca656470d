// Where triangles differ in size, spatial median stops and SOMS goes on without a fallback.
//
// The thesis says so four times (chapter 1, figures 4.3 and 4.6, tables 5.5 and 5.11), and it is
// one property, so it is one matrix. A rule is stuck at a node if its plane leaves one side empty
// although the midpoints of the triangles differ: nodes of a single midpoint, which no plane parts,
// count for neither rule. The claim joins two statements, so a row judges both: its number is above
// zero only if SOMS is stuck nowhere and spatial median somewhere. The counts of each rule are a
// table. Trying the other axes (`next_axis`) may be called a fallback or not, so both are readings;
// object median in the place of the rule is a fallback without doubt and none. Toy sets are shown
// and not judged, as in every claim.
#include "soms/generate/spread.h"
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"

#include "apps/draw/chart.h"
#include "apps/draw/grouped_bars.h"
#include "thesis/claims/thesis_claims.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"
#include "thesis/run/steps.h"
#include "thesis/trees/open_options.h"
#include "thesis/trees/stuck_nodes.h"
#include "thesis/trees/toy_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array kMidpoints{Midpoint::thesis, Midpoint::centroid, Midpoint::aabb};
constexpr std::array kWithoutFallback{EmptySide::stop, EmptySide::next_axis};
constexpr std::uint64_t kSpreadTriangles = 5000;

/// What the rows are counted on.
struct StuckSubject {
  std::string name;
  Model model = {};
  int level = kObjectLevel;
  std::string unjudged = {};  ///< why it is judged in no reading
  SubjectKind kind = SubjectKind::given;
};

/// Where both rules are stuck on a subject under one reading.
struct Stuck {
  const StuckSubject* subject = nullptr;
  OpenOptions open = {};
  StuckNodes soms = {};
  StuckNodes spatial = {};
};

Model model_of(Mesh mesh) {
  Model model;
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

std::vector<StuckSubject> stuck_subjects(const Models& models) {
  std::vector<StuckSubject> subjects;
  for (const auto& [model, level] : at_greatest_level(models)) {
    subjects.push_back({label_of(*model),
                        *model,
                        level,
                        {},
                        model->stand_in ? SubjectKind::stand_in : SubjectKind::given});
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
      subjects.push_back({fmt::format("toy set {}", toy.name),
                          model_of(std::move(toy.mesh)),
                          kObjectLevel,
                          {},
                          SubjectKind::toy_set});
    }
  }
  return subjects;
}

StuckNodes stuck(const StuckSubject& subject, Rule rule, const OpenOptions& open,
                 const Limits& limits) {
  const Mesh& mesh = *subject.model.mesh;
  const BuildOptions options = options_of(rule, subject.level, open);
  return stuck_nodes(build(mesh, options, {.threads = 1, .stop = limits.stop}), mesh, options);
}

/// "stop, inner axis, midpoint thesis".
std::string open_reading(const OpenOptions& open) {
  return fmt::format("{}, midpoint {}{}", words_of(open.empty_side, open.soms_axis),
                     name(open.midpoint), open.midpoint == Midpoint::thesis ? "" : " (ours)");
}

/// The outer axis is counted with the midpoint of the thesis, other midpoints on the inner axis.
std::vector<OpenOptions> all_options() {
  std::vector<OpenOptions> all;
  for (const Midpoint midpoint : kMidpoints) {
    for (const EmptySide empty_side : kWithoutFallback) {
      for (const AxisFrom axis : kSomsAxes) {
        if (midpoint == Midpoint::thesis || axis == AxisFrom::inner) {
          all.push_back({axis, empty_side, midpoint});
        }
      }
    }
  }
  return all;
}

std::vector<Stuck> count_stuck(std::span<const StuckSubject> subjects, const Limits& limits) {
  std::vector<Stuck> all;
  const std::vector<OpenOptions> options = all_options();
  Steps steps(limits, options.size() * subjects.size());
  for (const OpenOptions& open : options) {
    for (const StuckSubject& subject : subjects) {
      all.push_back({&subject, open, stuck(subject, Rule::soms, open, steps.quiet()),
                     stuck(subject, Rule::spatial_median, open, steps.quiet())});
      steps.done_one();
    }
  }
  return all;
}

/// Why a row is not judged, whatever its subject's kind.
std::string unjudged_of(const Stuck& one) {
  if (one.open.midpoint != Midpoint::thesis) {
    return "figure 4.23 constructs the midpoint of the thesis";
  }
  const std::string axis = axis_unjudged(one.open.soms_axis);
  return axis.empty() ? one.subject->unjudged : axis;
}

ClaimRow stuck_row(const Stuck& one) {
  const auto count = [](const StuckNodes& nodes) { return static_cast<double>(nodes.partable); };
  ClaimRow row =
      counted_row(open_reading(one.open),
                  "nodes where spatial median is stuck; if SOMS is stuck anywhere, minus its nodes",
                  one.subject->name, "", demand_of("no_fallback"),
                  one.soms.partable == 0 ? count(one.spatial) : -count(one.soms));
  row.unjudged = unjudged_of(one);
  row.kind = one.subject->kind;
  return row;
}

Table table_of(std::span<const Stuck> all) {
  Table table{.id = "claim_fallback",
              .caption =
                  "Nodes that each rule cannot divide although the midpoints of their triangles "
                  "differ, by the axis of SOMS, empty side and midpoint, and the triangles of the "
                  "largest node that it cannot divide, whether or not its midpoints differ.",
              .columns = {{"subject"},
                          {"midpoint"},
                          {"empty_side"},
                          {"soms_axis"},
                          {"soms_stuck"},
                          {"soms_largest"},
                          {"spatial_stuck"},
                          {"spatial_largest"}}};
  const auto count = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
  for (const Stuck& one : all) {
    table.rows.push_back({one.subject->name, std::string(name(one.open.midpoint)),
                          std::string(name(one.open.empty_side)),
                          std::string(name(one.open.soms_axis)), count(one.soms.partable),
                          count(one.soms.largest), count(one.spatial.partable),
                          count(one.spatial.largest)});
  }
  return table;
}

/// Subjects on which spatial median is stuck nowhere: "toy set a (next_axis)"; toy sets alone, or
/// all others.
std::string stuck_nowhere(std::span<const Stuck> all, bool toys) {
  std::string text;
  for (const Stuck& one : all) {
    if (unjudged_of(one).empty() && one.spatial.partable == 0 &&
        (one.subject->kind == SubjectKind::toy_set) == toys) {
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", one.subject->name,
                          words_of(one.open.empty_side));
    }
  }
  return text;
}

std::string note_of(std::span<const Stuck> all) {
  const std::string judged = stuck_nowhere(all, false);
  const std::string toys = stuck_nowhere(all, true);
  std::string text =
      judged.empty()
          ? "Spatial median is stuck somewhere on all that is judged."
          : fmt::format("Of what is judged, spatial median is stuck nowhere on {}.", judged);
  if (!toys.empty()) {
    text += fmt::format(" Of the toy sets, which are not judged, it is stuck nowhere on {}.", toys);
  }
  return text;
}

/// Nodes where each rule is stuck with the midpoint of the thesis, over all that is of unlike size.
std::string totals_of(std::span<const Stuck> all) {
  std::string text;
  for (const EmptySide empty_side : kWithoutFallback) {
    std::uint64_t inner = 0;
    std::uint64_t outer = 0;
    std::uint64_t spatial = 0;
    for (const Stuck& one : all) {
      if (one.open.midpoint == Midpoint::thesis && one.open.empty_side == empty_side &&
          one.subject->unjudged.empty()) {
        const bool is_inner = one.open.soms_axis == AxisFrom::inner;
        (is_inner ? inner : outer) += one.soms.partable;
        spatial += is_inner ? one.spatial.partable : 0;
      }
    }
    text += fmt::format(
        " With empty side {} SOMS is stuck at {} nodes on the inner axis and at {} "
        "on the outer, spatial median at {}.",
        words_of(empty_side), words(inner), words(outer), words(spatial));
  }
  return text;
}

/// What spatial median does where only the sizes change: from one size to edges far apart.
std::string spread_words(std::span<const StuckSubject> subjects, const Limits& limits) {
  const auto is_spread = [](const StuckSubject& subject) {
    return subject.name.starts_with("spread");
  };
  const auto alike = std::find_if(subjects.begin(), subjects.end(), is_spread);
  const auto unlike = std::find_if(subjects.rbegin(), subjects.rend(), is_spread);
  const StuckNodes from = stuck(*alike, Rule::spatial_median, {}, limits);
  const StuckNodes to = stuck(*unlike, Rule::spatial_median, {}, limits);
  return fmt::format(
      "Unlike sizes are not what it takes to stop spatial median, but they decide where it stops: "
      "on triangles of one size it is stuck at {} nodes of at most {} triangles, on the {} at {} "
      "nodes of up to {}.",
      words(from.partable), words(from.largest), unlike->name, words(to.partable),
      words(to.largest));
}

Claim claim_of(std::span<const StuckSubject> subjects, std::span<const Stuck> all,
               const Limits& limits) {
  std::vector<ClaimRow> rows;
  std::transform(all.begin(), all.end(), std::back_inserter(rows), stuck_row);
  Claim claim = judged(thesis_claim("no_fallback"), std::move(rows));
  claim.note = note_of(all);
  claim.why = fmt::format(
      "A rule is stuck at a node if its plane leaves one side empty although the midpoints of the "
      "triangles differ. SOMS puts its plane between the least and the greatest midpoint of the "
      "inner box's longest axis, so it fails only where that box is a point: its half of the claim "
      "follows from the rule. On the longest axis of the outer box all midpoints may agree, and "
      "then it fails as well. Spatial median's plane is the middle of corners, which may lie far "
      "from all midpoints: one large triangle is enough. Over all subjects of unlike sizes, with "
      "the midpoint of the thesis:{} {} A reading names the empty side, the axis of SOMS and the "
      "midpoint.",
      totals_of(all), spread_words(subjects, limits));
  claim.revision =
      Revision{Verdict::holds, "spatial median was not judged where it tries the other axes"};
  return claim;
}

Figure figure_of(std::span<const Stuck> all) {
  std::vector<Datum> data;
  for (const AxisFrom axis : kSomsAxes) {
    for (const Stuck& one : all) {
      if (one.open.midpoint == Midpoint::thesis && one.open.empty_side == EmptySide::stop &&
          one.open.soms_axis == axis) {
        data.push_back({one.subject->name, fmt::format("SOMS, {} axis", name(axis)),
                        static_cast<double>(one.soms.partable)});
        if (axis == AxisFrom::outer) {
          data.push_back(
              {one.subject->name, "spatial median", static_cast<double>(one.spatial.partable)});
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
  const std::vector<StuckSubject> subjects = stuck_subjects(context.models);
  const std::vector<Stuck> all = count_stuck(subjects, context.limits);
  Result result;
  result.claims = {claim_of(subjects, all, context.limits)};
  result.tables = {table_of(all)};
  result.figures = {figure_of(all)};
  return result;
}

}  // namespace soms::reproduce
