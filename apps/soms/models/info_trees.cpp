#include "apps/soms/models/info_trees.h"

#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace soms::command {

RuleReport measure_tree(const MeshView& mesh, const BuildOptions& options, const Console& console) {
  RuleReport report;
  report.rule = entry(options.rule).kebab;
  std::vector<double> times;
  const auto timed_build = [&](const Limits& limits) {
    const auto begin = std::chrono::steady_clock::now();
    Tree tree = build(mesh, options, limits);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    times.push_back(time.count());
    return tree;
  };
  const std::string doing = fmt::format("building the tree of {} by {}", mesh.source, report.rule);
  const Tree tree = console.run(doing, timed_build);
  report.build_runs = builds_to_time(times.front());
  while (static_cast<int>(times.size()) < report.build_runs) {
    static_cast<void>(console.run(doing, timed_build));
  }
  // As many above as below: their number is odd.
  const auto middle = times.begin() + report.build_runs / 2;
  std::nth_element(times.begin(), middle, times.end());
  report.build_ms = *middle;
  report.counts = statistics(tree, options);
  report.levels = tree.nodes.empty() ? 0 : report.counts.depth + 1;
  report.sah = sah_cost(tree);
  return report;
}

Json to_json(const RuleReport& r) {
  const TreeStatistics& counts = r.counts;
  return {{"rule", r.rule},
          {"levels", r.levels},
          {"full_levels", counts.balanced_level},
          {"nodes", counts.nodes},
          {"leaves", counts.leaves},
          {"single_triangle_leaves", counts.one},
          {"leaves_below_5_triangles", counts.lt5},
          {"largest_leaf_triangles", counts.largest_leaf},
          {"undividable", counts.undividable},
          {"sah_cost", r.sah},
          {"build_ms", r.build_ms},
          {"build_runs", r.build_runs},
          // Names of version 0.1, for scripts that know them.
          {"one", counts.one},
          {"lt5", counts.lt5},
          {"balanced_level", counts.balanced_level},
          {"largest_leaf", counts.largest_leaf},
          {"sah", r.sah}};
}

std::string describe_trees(const std::vector<RuleReport>& trees, int per_leaf) {
  if (trees.empty()) {
    return {};
  }
  std::string text = fmt::format("  trees with at most {} per leaf\n",
                                 counted(static_cast<std::uint64_t>(per_leaf), "triangle"));
  text +=
      fmt::format("    {:<14}{:>7}{:>6}{:>12}{:>13}{:>13}{:>10}{:>10}{:>8}\n", "rule", "levels",
                  "full", "leaves", "1-triangle", "undividable", "SAH cost", "build ms", "builds");
  for (const RuleReport& r : trees) {
    text += fmt::format("    {:<14}{:>7}{:>6}{:>12}{:>13}{:>13}{:>10.2f}{:>10.2f}{:>8}\n", r.rule,
                        r.levels, r.counts.balanced_level, with_commas(r.counts.leaves),
                        with_commas(r.counts.one), with_commas(r.counts.undividable), r.sah,
                        r.build_ms, r.build_runs);
  }
  return text;
}

}  // namespace soms::command
