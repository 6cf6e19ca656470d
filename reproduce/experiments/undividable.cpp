// Tables 5.5 and 5.11: nodes that a rule cannot divide.
#include "soms/tree/build.h"

#include "reproduce/count_charts.h"
#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 12> kColumns{
    "model",      "origin", "triangles", "rule",        "midpoint", "axis_from",
    "empty_side", "level",  "nodes",     "undividable", "empty",    "largest_leaf"};

constexpr std::array kStopAndChain{EmptySide::stop, EmptySide::chain};
constexpr std::array kAllPolicies{EmptySide::stop, EmptySide::next_axis, EmptySide::object_median,
                                  EmptySide::chain};

std::vector<Contender> stop_and_chain(int level) {
  return with_each(all_builds(level), kStopAndChain);
}

/// True if the midpoints of a node's triangles are all the same point.
bool is_one_point(const Tree& tree, const Node& node, const Mesh& mesh,
                  const BuildOptions& options) {
  const auto midpoint_of = [&](TriangleId i) {
    return midpoint(mesh.triangle(i), options.midpoint, options.c_vertex);
  };
  const std::span<const TriangleId> triangles = tree.triangles_of(node);
  return std::all_of(triangles.begin(), triangles.end(), [&](TriangleId i) {
    return midpoint_of(i) == midpoint_of(triangles.front());
  });
}

/// Nodes that a rule leaves undivided.
struct Stuck {
  std::uint64_t nodes = 0;
  std::uint64_t with_different_midpoints = 0;
  std::uint64_t largest = 0;  ///< triangles
};

Stuck stuck_nodes(const Model& model, const BuildOptions& options, const Parallel& parallel) {
  const Tree tree = build(*model.mesh, options, {1, parallel.stop, {}});
  Stuck stuck;
  for (const Node& node : tree.nodes) {
    if (node.undividable) {
      ++stuck.nodes;
      stuck.with_different_midpoints += is_one_point(tree, node, *model.mesh, options) ? 0U : 1U;
      stuck.largest = std::max(stuck.largest, std::uint64_t{node.count});
    }
  }
  return stuck;
}

std::string words_of(const Stuck& stuck) {
  if (stuck.nodes == 0) {
    return "none";
  }
  return fmt::format("{} of up to {} triangles", words(stuck.nodes), words(stuck.largest));
}

/// SOMS is to go on where spatial median stops.
Finding goes_on(std::span<const Model> models, int level, const Parallel& parallel) {
  Finding finding{.claim =
                      "SOMS goes on dividing triangles of unlike size where spatial median "
                      "stops, without a second rule",
                  .source = "abstract; figure 4.3 by its caption"};
  std::uint64_t of_soms = 0;
  std::uint64_t of_spatial = 0;
  for (const Model& model : models) {
    const Stuck soms = stuck_nodes(model, thesis_options(Rule::soms, level), parallel);
    const Stuck spatial = stuck_nodes(model, thesis_options(Rule::spatial_median, level), parallel);
    finding.measured +=
        fmt::format("{}: {} to {}. ", model.name, words_of(soms), words_of(spatial));
    of_soms += soms.with_different_midpoints;
    of_spatial += spatial.with_different_midpoints;
  }
  finding.measured = fmt::format(
      "Undividable nodes, SOMS to spatial median. {}Of SOMS' nodes {} hold "
      "triangles of different midpoints, of spatial median's {}.{}",
      finding.measured, words(of_soms), words(of_spatial), note_on_stand_ins(models));
  const bool only_stand_ins =
      std::all_of(models.begin(), models.end(), [](const Model& model) { return model.stand_in; });
  if (of_soms > 0) {
    finding.verdict = Verdict::does_not_hold;
    finding.reason = "SOMS stops at nodes whose triangles have different midpoints.";
  } else if (of_spatial == 0) {
    finding.reason = fmt::format(
        "At level {} spatial median stops nowhere on these models that a plane could part, so "
        "there is nothing where SOMS could go on.",
        level);
  } else {
    finding.verdict = Verdict::holds;
    finding.reason = fmt::format(
        "At level {} with empty side stop, on all models here: SOMS with the axis of the inner box "
        "stops only where all midpoints of a node are the same point.{}",
        level,
        only_stand_ins ? " It is a property of the rule, shown here on stand-ins only." : "");
  }
  return finding;
}

}  // namespace

Result table_5_5(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  const std::vector<Counted> counts =
      count_all(objects, at_every_level(kObjectLevel, stop_and_chain), context.parallel);
  const Model& bunny = objects.front();
  return {.tables = {count_table(
              "table_5_5",
              "Nodes that cannot be divided by greatest level: undividable is the nodes whose rule "
              "left one side empty; with chain, empty is the nodes without triangles." +
                  note_on_stand_ins(objects),
              kColumns, counts)},
          .figures = {{.id = "table_5_5",
                       .caption = fmt::format("Nodes that cannot be divided, {}, empty side stop.",
                                              label_of(bunny)),
                       .svg = lines_by_level("Nodes that cannot be divided", "nodes", bunny, counts,
                                             undividable)}},
          .findings = {goes_on(objects, kObjectLevel, context.parallel)}};
}

Result table_5_11(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  const std::vector<Counted> counts = count_all(
      scenes, with_each(all_builds_and_axes(kSceneLevel), kAllPolicies), context.parallel);
  const std::string note = note_on_stand_ins(scenes);
  return {.tables = {count_table("table_5_11",
                                 fmt::format("Nodes that cannot be divided, urban scenes at level "
                                             "{}.{}",
                                             kSceneLevel, note),
                                 kColumns, counts)},
          .figures =
              {{.id = "table_5_11",
                .caption = fmt::format(
                    "Nodes that cannot be divided at level {}. One near the root is worse than a "
                    "thousand at the bottom: see column largest_leaf.{}{}",
                    kSceneLevel, kComparedOptions, note),
                .svg = bars_of("Nodes that cannot be divided", "nodes", with_usual_options(counts),
                               undividable)}},
          .findings = {goes_on(scenes, kSceneLevel, context.parallel)}};
}

}  // namespace soms::reproduce
