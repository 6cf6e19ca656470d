#include "apps/view/verbs/tree_options.h"

#include "apps/support/models.h"

#include <CLI/CLI.hpp>

namespace soms::view {

void add_tree_options(CLI::App& app, BuildOptions& build, TraversalOptions& traversal) {
  // Options are heeded in the order in which they are added.
  CLI::Option* const thesis = app.add_flag_callback(
      "--thesis",
      [&build, &traversal] {
        build = thesis_options(Rule::soms);
        traversal = {.traversal = Traversal::e_node, .prune = traversal.prune};
      },
      "tree and traversal of the thesis: --rule soms --midpoint thesis --leaf 1\n"
      "--empty-side stop --levels 15 --traversal e-node --descent both");
  command::add_build_options(app, build);
  command::add_traversal_options(app, traversal);
  thesis->group(app.get_option("--rule")->get_group());
}

void check_tree_options(const CLI::App& app, BuildOptions& build,
                        const TraversalOptions& traversal) {
  if (app.count("--thesis") > 0 && command::given_of(app, idle_options(build)).empty()) {
    build = without_idle(build);
  }
  command::check_build(app, build);
  command::check_traversal(app, traversal);
}

void describe_count(CLI::App& app) {
  app.get_option("--count")->description(
      "number of movers (one per --mover or --route; without either 1000,\n"
      "in a city from files none)");
}

}  // namespace soms::view
