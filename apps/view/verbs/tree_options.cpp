#include "apps/view/verbs/tree_options.h"

#include "apps/cli/parser.h"
#include "apps/model/models.h"
#include "apps/model/traversal_keys.h"

namespace soms::view {

void add_tree_options(command::Parser& parser, BuildOptions& build, TraversalOptions& traversal) {
  // Options are heeded in the order in which they are added.
  command::Option* const thesis = parser.add_flag_callback(
      "--thesis",
      [&build, &traversal] {
        build = thesis_options(Rule::soms);
        traversal = {.traversal = Traversal::e_node, .prune = traversal.prune};
      },
      "tree and traversal of the thesis: --tree rule=soms,midpoint=thesis,leaf=1,\n"
      "empty-side=stop,levels=15,traversal=e-node,descent=both");
  command::add_tree_list(parser, build);
  command::add_traversal_keys(parser, traversal);
  thesis->group(parser.option("--tree")->group());
}

void check_tree_options(const command::Parser& parser, BuildOptions& build,
                        const TraversalOptions& traversal) {
  if (parser.count("--thesis") > 0 && command::given_of(parser, idle_options(build)).empty()) {
    build = without_idle(build);
  }
  command::check_build(parser, build);
  command::check_traversal(parser, traversal);
}

void describe_count(command::Parser& parser) {
  parser.option("--count")->description(
      "number of movers (one per --mover or --route; without either 1000,\n"
      "in a city from files none)");
}

}  // namespace soms::view
