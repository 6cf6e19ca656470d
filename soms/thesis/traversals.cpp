#include "soms/thesis/traversals.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/thesis/baselines.h"
#include "soms/thesis/detail/recursion.h"
#include "soms/thesis/e_node.h"
#include "soms/thesis/e_node_front.h"

#include <algorithm>
#include <array>
#include <string>

namespace soms {

namespace {

constexpr std::array<TraversalEntry, 10> kTraversals{{
    {Traversal::fast, "fast", "fast", "the product's default: traverses the wide layout", nullptr},
    {Traversal::a_first, "a_first", "a-first", "descends the first tree, then the second",
     detail::a_first},
    {Traversal::b_first, "b_first", "b-first", "descends the second tree, then the first",
     detail::b_first},
    {Traversal::alternate, "alternate", "alternate", "descends the trees in turn",
     detail::alternate},
    {Traversal::larger, "larger", "larger", "descends the node of greater volume", detail::larger},
    {Traversal::simultaneous, "simultaneous", "simultaneous", "descends both nodes",
     detail::simultaneous},
    {Traversal::ericson, "ericson", "ericson", "generic, with the rule of any of the above",
     detail::ericson},
    {Traversal::larsson, "larsson", "larsson", "another name of simultaneous (reconstruction)",
     detail::simultaneous},
    {Traversal::e_node, "e_node", "e-node", "tests all child pairs before it enters any",
     detail::e_node},
    {Traversal::e_node_front, "e_node_front", "e-node-front",
     "E-Node that starts where the last frame ended", detail::e_node_front},
}};

constexpr std::array<DescentEntry, 4> kDescents{{
    {Descent::both, "both", "both", "child pairs of both nodes"},
    {Descent::larger, "larger", "larger", "children of the node of greater volume"},
    {Descent::cross, "cross", "cross", "pairs of the children that overlap the other node"},
    {Descent::fewest, "fewest", "fewest",
     "children of the node that leave fewer overlapping pairs"},
}};

/// The entry for which `matches` holds. \errors ErrorKind::usage; lists the names.
template <class Entries, class Matches>
const auto& find(const Entries& entries, const std::string& what, const Matches& matches) {
  const auto found = std::find_if(entries.begin(), entries.end(), matches);
  if (found == entries.end()) {
    std::string names;
    for (const auto& e : entries) {
      names += (names.empty() ? "" : ", ") + std::string(e.kebab);
    }
    throw Error(ErrorKind::usage, what + " is unknown", "use one of " + names);
  }
  return *found;
}

bool is_baseline(Traversal t) {
  return t == Traversal::a_first || t == Traversal::b_first || t == Traversal::alternate ||
         t == Traversal::larger || t == Traversal::simultaneous;
}

bool is_fast(const TraversalOptions& options) {
  return options.traversal == Traversal::fast;
}

/// The one place that says which options of a traversal have an effect beside which others.
struct Row {
  IdleOption idle;
  bool (*has_no_effect)(const TraversalOptions& options);
  bool (*is_set)(const TraversalOptions& options);
  void (*reset)(TraversalOptions& options);
};

constexpr std::string_view kFast = "the traversal fast has no such choice";

constexpr std::array<Row, 6> kRows{{
    {{"descent", "only E-Node has a descent", "traversal", "e_node or e_node_front"},
     [](const TraversalOptions& o) { return !has_descent(o.traversal); },
     [](const TraversalOptions& o) { return o.descent != TraversalOptions{}.descent; },
     [](TraversalOptions& o) { o.descent = TraversalOptions{}.descent; }},
    {{"order", "only E-Node orders the pairs that it enters", "traversal",
      "e_node or e_node_front"},
     [](const TraversalOptions& o) { return !has_descent(o.traversal); },
     [](const TraversalOptions& o) { return o.order != TraversalOptions{}.order; },
     [](TraversalOptions& o) { o.order = TraversalOptions{}.order; }},
    {{"ericson_rule", "only the traversal ericson has a rule of descent", "traversal", "ericson"},
     [](const TraversalOptions& o) { return o.traversal != Traversal::ericson; },
     [](const TraversalOptions& o) { return o.ericson_rule != TraversalOptions{}.ericson_rule; },
     [](TraversalOptions& o) { o.ericson_rule = TraversalOptions{}.ericson_rule; }},
    {{"recursive", "only the baselines, a_first to larsson, and e_node may recurse", "traversal",
      ""},
     [](const TraversalOptions& o) { return is_fast(o) || o.traversal == Traversal::e_node_front; },
     [](const TraversalOptions& o) { return o.recursive != TraversalOptions{}.recursive; },
     [](TraversalOptions& o) { o.recursive = TraversalOptions{}.recursive; }},
    {{"prune", kFast, "traversal", ""},
     &is_fast,
     [](const TraversalOptions& o) { return o.prune != TraversalOptions{}.prune; },
     [](TraversalOptions& o) { o.prune = TraversalOptions{}.prune; }},
    {{"update", kFast, "traversal", ""},
     &is_fast,
     [](const TraversalOptions& o) { return o.update != TraversalOptions{}.update; },
     [](TraversalOptions& o) { o.update = TraversalOptions{}.update; }},
}};

}  // namespace

std::vector<IdleOption> idle_options(const TraversalOptions& options) {
  std::vector<IdleOption> idle;
  for (const Row& row : kRows) {
    if (row.has_no_effect(options)) {
      idle.push_back(row.idle);
    }
  }
  return idle;
}

TraversalOptions without_idle(TraversalOptions options) {
  for (const Row& row : kRows) {
    if (row.has_no_effect(options)) {
      row.reset(options);
    }
  }
  return options;
}

TraversalCounts& TraversalCounts::operator+=(const TraversalCounts& other) {
  box_tests += other.box_tests;
  entered += other.entered;
  leaf_pairs += other.leaf_pairs;
  triangle_pairs += other.triangle_pairs;
  first_tests += other.first_tests;
  max_stack = std::max(max_stack, other.max_stack);
  return *this;
}

std::span<const TraversalEntry> traversals() {
  return kTraversals;
}

std::span<const DescentEntry> descents() {
  return kDescents;
}

const TraversalEntry& entry(Traversal traversal) {
  return find(kTraversals, "traversal " + std::to_string(static_cast<int>(traversal)),
              [&](const TraversalEntry& e) { return e.traversal == traversal; });
}

const DescentEntry& entry(Descent descent) {
  return find(kDescents, "descent " + std::to_string(static_cast<int>(descent)),
              [&](const DescentEntry& e) { return e.descent == descent; });
}

const TraversalEntry& traversal_named(std::string_view name) {
  return find(kTraversals, "traversal '" + std::string(name) + "'", [&](const TraversalEntry& e) {
    return e.name == name || e.kebab == name ||
           (e.traversal == TraversalOptions{}.traversal && name == "default");
  });
}

const DescentEntry& descent_named(std::string_view name) {
  return find(kDescents, "descent '" + std::string(name) + "'",
              [&](const DescentEntry& e) { return e.name == name || e.kebab == name; });
}

bool has_descent(Traversal traversal) {
  return traversal == Traversal::e_node || traversal == Traversal::e_node_front;
}

void check(const TraversalOptions& options) {
  if (options == TraversalOptions{}) {
    return;  // a query of microseconds looks no further
  }
  (void)entry(options.traversal);
  (void)entry(options.descent);
  (void)entry(options.ericson_rule);
  if (options.order != EntryOrder::tree && options.order != EntryOrder::volume) {
    throw Error(ErrorKind::usage, "traversal: unknown order", "use tree or volume");
  }
  if (options.update != BoxUpdate::refit && options.update != BoxUpdate::rebox) {
    throw Error(ErrorKind::usage, "traversal: unknown update", "use refit or rebox");
  }
  if (options.traversal == Traversal::ericson && !is_baseline(options.ericson_rule)) {
    throw Error(ErrorKind::usage,
                "traversal ericson: '" + std::string(entry(options.ericson_rule).name) +
                    "' is not a rule of descent",
                "use a_first, b_first, alternate, larger or simultaneous");
  }
  if (options.traversal == Traversal::e_node_front) {
    if (options.descent != Descent::both && options.descent != Descent::larger) {
      throw Error(ErrorKind::usage,
                  "traversal e_node_front: a front of descent '" +
                      std::string(entry(options.descent).name) + "' cannot be kept",
                  "use descent both or larger");
    }
    if (!options.prune) {
      throw Error(ErrorKind::usage, "traversal e_node_front: a front is what pruning leaves",
                  "leave `prune` on");
    }
  }
  for (const Row& row : kRows) {
    if (row.is_set(options) && row.has_no_effect(options)) {
      refuse_idle("traversal " + std::string(entry(options.traversal).name), row.idle);
    }
  }
}

void detail::check_boxes(const PosedTree& a, const PosedTree& b) {
  for (const PosedTree* posed : {&a, &b}) {
    if (posed->tree == nullptr || posed->boxes.size() != posed->tree->nodes.size()) {
      throw Error(ErrorKind::usage, "traversal: a tree without one box for each of its nodes",
                  "give the boxes of this tree (PosedBoxes)");
    }
  }
}

TraversalCounts traverse(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                         const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  const PlainArithmetic plain;
  check(options);
  const TraversalEntry& named = entry(options.traversal);
  if (named.function == nullptr) {
    throw Error(ErrorKind::usage,
                "traversal: '" + std::string(named.name) + "' does not traverse canonical trees",
                "name another traversal");
  }
  detail::check_boxes(a, b);
  if (a.tree->nodes.empty() || b.tree->nodes.empty()) {
    return {};
  }
  if (options.recursive) {
    detail::check_recursion(a, b);
  }
  return named.function(a, b, options, visitor, workspace);
}

TraversalCounts traverse(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                         const TraversalVisitor& visitor) {
  TraversalWorkspace workspace;
  return traverse(a, b, options, visitor, workspace);
}

}  // namespace soms
