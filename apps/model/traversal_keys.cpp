#include "apps/model/traversal_keys.h"

#include "soms/base/error.h"
#include "soms/thesis/traversals.h"

#include "apps/cli/parse.h"
#include "apps/model/models.h"

#include <fmt/format.h>

#include <vector>

namespace soms::command {

namespace {

Choices<Traversal> traversal_choices() {
  Choices<Traversal> choices{{"default", traversal_named("default").traversal}};
  for (const auto& row : traversals()) {
    choices.emplace_back(row.kebab, row.traversal);
  }
  return choices;
}

Choices<Descent> descent_choices() {
  Choices<Descent> choices;
  for (const auto& row : descents()) {
    choices.emplace_back(row.kebab, row.descent);
  }
  return choices;
}

}  // namespace

void add_traversal_options(Parser& parser, TraversalOptions& options) {
  add_choice<Traversal>(parser, "--traversal", options.traversal, traversal_choices(),
                        "traversal algorithm")
      ->group(kTreeGroup);
  add_choice<Descent>(parser, "--descent", options.descent, descent_choices(),
                      "nodes that E-Node descends into")
      ->group(kTreeGroup);
}

void add_traversal_keys(Parser& parser, TraversalOptions& options) {
  add_traversal_options(parser, options);
  for (const char* const key : {"--traversal", "--descent"}) {
    parser.option(key)->key_of(parser.option("--tree"));
  }
}

void check_traversal(const Parser& parser, const TraversalOptions& options) {
  std::vector<IdleOption> idle = idle_options(options);
  std::erase_if(idle, [](const IdleOption& option) { return option.name != "descent"; });
  refuse_given(parser, idle);
  if (options.traversal == Traversal::e_node_front && options.descent != Descent::both &&
      options.descent != Descent::larger) {
    throw Error(ErrorKind::usage,
                fmt::format("--traversal e-node-front does not work with --descent {}",
                            entry(options.descent).kebab),
                "use --descent both or --descent larger");
  }
}

}  // namespace soms::command
