#include "soms/thesis/traversals.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/posed_boxes.h"

#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<NodePair>;

/// What a traversal did, watched from outside.
struct Watched {
  TraversalCounts counts;
  Pairs reported;
  std::vector<std::pair<NodePair, bool>> tested;
  Pairs entered;
  std::uint64_t first_tests = 0;
};

Watched watch(const PosedTree& a, const PosedTree& b, const TraversalOptions& options) {
  Watched out;
  TraversalVisitor visitor;
  visitor.leaf_pair = [&](NodePair p) {
    if (out.reported.empty()) {
      out.first_tests = out.tested.size();
    }
    out.reported.push_back(p);
    return true;
  };
  visitor.tested = [&](NodePair p, bool hit) { out.tested.emplace_back(p, hit); };
  visitor.entered = [&](NodePair p) { out.entered.push_back(p); };
  out.counts = traverse(a, b, options, visitor);
  return out;
}

bool overlap(const PosedTree& a, const PosedTree& b, NodePair p) {
  return overlaps(a.boxes[p.a], b.boxes[p.b]);
}

/// Two random bodies at random poses in random trees.
struct Scene {
  explicit Scene(Rng& rng)
      : kind(test::kKinds[rng.below(test::kKinds.size())]),
        mesh_a(test::body(rng, kind, 1 + rng.below(25))),
        mesh_b(test::body(rng, kind, 1 + rng.below(25))),
        tree_a(test::random_tree(rng, mesh_a, 1 + rng.below(3))),
        tree_b(test::random_tree(rng, mesh_b, 1 + rng.below(3))),
        boxes_a(mesh_a, tree_a),
        boxes_b(mesh_b, tree_b) {
    const BoxUpdate update = rng.below(2) == 0 ? BoxUpdate::refit : BoxUpdate::rebox;
    boxes_a.move(test::pose(rng, kind), update);
    boxes_b.move(test::pose(rng, kind), update);
  }

  [[nodiscard]] PosedTree a() const { return boxes_a.view(); }

  [[nodiscard]] PosedTree b() const { return boxes_b.view(); }

  test::Kind kind;
  Mesh mesh_a, mesh_b;
  Tree tree_a, tree_b;
  PosedBoxes boxes_a, boxes_b;
};

/// Calls `body(scene, options)` for random scenes and every traversal them.
template <class Body>
void for_each_traversal_options(const std::string& tag, int n, const Body& body) {
  static const std::vector<TraversalOptions> all_settings = test::every_traversal_options();
  test::for_each_case(tag, n, [&](Rng& rng) {
    const Scene scene(rng);
    for (const TraversalOptions& options : all_settings) {
      SCOPED_TRACE(test::describe(options));
      body(scene, options);
    }
  });
}

bool is_e_node(const TraversalOptions& options) {
  return options.traversal == Traversal::e_node || options.traversal == Traversal::e_node_front;
}

TEST(Traversals, ReportEachOverlappingPairOfLeavesOnce) {
  for_each_traversal_options("traversals/answers", 120,
                             [](const Scene& s, const TraversalOptions& options) {
                               EXPECT_EQ(test::sorted(watch(s.a(), s.b(), options).reported),
                                         test::overlapping_leaves(s.a(), s.b()));
                             });
}

TEST(Traversals, CountWhatTheyDo) {
  for_each_traversal_options(
      "traversals/counts", 40, [](const Scene& s, const TraversalOptions& options) {
        const Watched w = watch(s.a(), s.b(), options);
        std::uint64_t triangles = 0;
        for (const NodePair p : w.reported) {
          triangles += std::uint64_t{s.tree_a.nodes[p.a].count} * s.tree_b.nodes[p.b].count;
        }
        EXPECT_EQ(w.counts.box_tests, w.tested.size());
        EXPECT_EQ(w.counts.entered, w.entered.size());
        EXPECT_EQ(w.counts.leaf_pairs, w.reported.size());
        EXPECT_EQ(w.counts.triangle_pairs, triangles);
        EXPECT_EQ(w.counts.first_tests, w.first_tests);
        EXPECT_LE(w.counts.max_stack, w.counts.entered);
        EXPECT_EQ(w.counts, traverse(s.a(), s.b(), options)) << "an unwatched run differs";
      });
}

TEST(Traversals, TestNoPairTwice) {
  for_each_traversal_options("traversals/twice", 40,
                             [](const Scene& s, const TraversalOptions& options) {
                               std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
                               for (const auto& [p, hit] : watch(s.a(), s.b(), options).tested) {
                                 EXPECT_TRUE(seen.insert({p.a, p.b}).second) << p.a << ' ' << p.b;
                                 EXPECT_EQ(hit, overlap(s.a(), s.b(), p));
                               }
                             });
}

TEST(Traversals, EnterOnlyWhatOverlapsInENode) {
  for_each_traversal_options("traversals/entered", 40,
                             [](const Scene& s, const TraversalOptions& options) {
                               if (is_e_node(options) && options.prune) {
                                 for (const NodePair p : watch(s.a(), s.b(), options).entered) {
                                   EXPECT_TRUE(overlap(s.a(), s.b(), p)) << p.a << ' ' << p.b;
                                 }
                               }
                             });
}

TEST(Traversals, PruningLosesNothingAndSavesTests) {
  for_each_traversal_options("traversals/prune", 40,
                             [](const Scene& s, const TraversalOptions& options) {
                               if (!options.prune) {
                                 TraversalOptions pruned = options;
                                 pruned.prune = true;
                                 EXPECT_LE(traverse(s.a(), s.b(), pruned).box_tests,
                                           traverse(s.a(), s.b(), options).box_tests);
                               }
                             });
}

// (c) of the design's section 4.1: E-Node saves entries, not box tests.
TEST(Traversals, MakeAsManyBoxTestsInENodeAsTheBaselineThatOpensTheSameNodes) {
  test::for_each_case("traversals/same-tests", 100, [](Rng& rng) {
    const Scene s(rng);
    for (const auto& [baseline, descent] : {std::pair(Traversal::simultaneous, Descent::both),
                                            std::pair(Traversal::larger, Descent::larger)}) {
      const auto plain = traverse(s.a(), s.b(), {.traversal = baseline});
      const auto early =
          traverse(s.a(), s.b(), {.traversal = Traversal::e_node, .descent = descent});
      EXPECT_EQ(early.box_tests, plain.box_tests);
      EXPECT_LE(early.entered, plain.entered);
    }
  });
}

TEST(Traversals, RecurseInTheOrderOfTheStack) {
  for_each_traversal_options("traversals/recursive", 40,
                             [](const Scene& s, const TraversalOptions& options) {
                               if (options.recursive) {
                                 TraversalOptions by_stack = options;
                                 by_stack.recursive = false;
                                 const Watched nested = watch(s.a(), s.b(), options);
                                 const Watched stacked = watch(s.a(), s.b(), by_stack);
                                 EXPECT_EQ(nested.reported, stacked.reported);
                                 EXPECT_EQ(nested.tested, stacked.tested);
                                 EXPECT_EQ(nested.entered, stacked.entered);
                               }
                             });
}

TEST(Traversals, NameAliasesTheSameTraversal) {
  for_each_traversal_options(
      "traversals/alias", 20, [](const Scene& s, const TraversalOptions& options) {
        TraversalOptions same = options;
        if (options.traversal == Traversal::ericson) {
          same.traversal = options.ericson_rule;
          same = without_idle(same);
        } else if (options.traversal == Traversal::larsson) {
          same.traversal = Traversal::simultaneous;
        }
        EXPECT_EQ(watch(s.a(), s.b(), options).reported, watch(s.a(), s.b(), same).reported);
        EXPECT_EQ(traverse(s.a(), s.b(), options), traverse(s.a(), s.b(), same));
      });
}

TEST(Traversals, StopWhenTheVisitorHasEnough) {
  for_each_traversal_options(
      "traversals/stop", 30, [](const Scene& s, const TraversalOptions& options) {
        const Pairs all = watch(s.a(), s.b(), options).reported;
        for (std::size_t wanted = 1; wanted <= all.size(); wanted += 1 + wanted / 2) {
          Pairs got;
          const auto counts = traverse(s.a(), s.b(), options, {.leaf_pair = [&](NodePair p) {
                                         got.push_back(p);
                                         return got.size() < wanted;
                                       }});
          EXPECT_EQ(got, Pairs(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wanted)));
          EXPECT_EQ(counts.leaf_pairs, wanted);
        }
      });
}

TEST(Traversals, StopWhenRequestedBetweenBoxTests) {
  const Box one{{0, 0, 0}, {1, 1, 1}};
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::coincident, 100);
  const Tree tree = test::random_tree(rng, mesh, 1);
  const std::vector<Box> boxes(tree.nodes.size(), one);
  for (const TraversalOptions& options : test::every_traversal_options()) {
    int calls = 0;
    const auto counts = traverse({&tree, boxes}, {&tree, boxes}, options,
                                 {.keep_going = [&] { return ++calls < 3; }});
    EXPECT_EQ(calls, 3) << test::describe(options);
    EXPECT_GE(counts.box_tests, 3 * 1024U);
    EXPECT_LT(counts.box_tests, 3 * 1024U + 8);
  }
}

TEST(Traversals, FindNothingInEmptyTrees) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 3);
  const Tree tree = test::random_tree(rng, mesh, 1);
  const Tree empty;
  PosedBoxes boxes(mesh, tree);
  boxes.move({});
  for (const TraversalOptions& options : test::every_traversal_options()) {
    EXPECT_EQ(traverse({&empty, {}}, boxes.view(), options), TraversalCounts{});
    EXPECT_EQ(traverse(boxes.view(), {&empty, {}}, options), TraversalCounts{});
  }
}

TEST(Traversals, ReportTwoRootsThatAreLeavesAfterOneTest) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 1);
  const Tree tree = test::random_tree(rng, mesh, 1);
  PosedBoxes boxes(mesh, tree);
  boxes.move({});
  for (const TraversalOptions& options : test::every_traversal_options()) {
    const Watched w = watch(boxes.view(), boxes.view(), options);
    EXPECT_EQ(w.reported, Pairs(1));
    EXPECT_EQ(w.counts.box_tests, 1U);
    EXPECT_EQ(w.counts.entered, is_e_node(options) ? 0U : 1U) << test::describe(options);
  }
}

std::string message(const TraversalOptions& options) {
  try {
    check(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "";
}

TEST(Traversals, R119OptionsThatTheTraversalIgnoresAreRefused) {
  EXPECT_EQ(message({.traversal = Traversal::larger, .descent = Descent::cross}),
            "traversal larger: descent has no effect: only E-Node has a descent; leave it at its "
            "default, or set traversal to e_node or e_node_front");

  // Each option away from its default, and the traversals that use it.
  struct IdleCase {
    TraversalOptions set;
    std::function<bool(Traversal)> uses;
  };

  const auto e_node = [](Traversal t) {
    return t == Traversal::e_node || t == Traversal::e_node_front;
  };
  const std::vector<IdleCase> cases{
      {{.descent = Descent::larger}, e_node},
      {{.order = EntryOrder::volume}, e_node},
      {{.ericson_rule = Traversal::a_first}, [](Traversal t) { return t == Traversal::ericson; }},
      {{.recursive = true},
       [](Traversal t) { return t != Traversal::fast && t != Traversal::e_node_front; }},
      {{.prune = false}, [](Traversal t) { return t != Traversal::fast; }},
      {{.update = BoxUpdate::rebox}, [](Traversal t) { return t != Traversal::fast; }},
  };
  const Body body(Shape(generate_sphere(80), {.keep_tree = true}));
  for (const IdleCase& c : cases) {
    for (const TraversalEntry& row : traversals()) {
      if (row.traversal == Traversal::e_node_front && !c.set.prune) {
        continue;  // refused for another reason
      }
      TraversalOptions options = c.set;
      options.traversal = row.traversal;
      SCOPED_TRACE(test::describe(options));
      EXPECT_EQ(without_idle(options) == options, c.uses(row.traversal));
      if (c.uses(row.traversal)) {
        EXPECT_NO_THROW(static_cast<void>(thesis::overlap(body, body, options)));
      } else {
        EXPECT_THROW(static_cast<void>(thesis::overlap(body, body, options)), Error);
        EXPECT_THROW(
            static_cast<void>(thesis::overlap(body.shape, std::vector<Pose>(2), body, options)),
            Error);
      }
    }
  }
}

TEST(Traversals, RefuseOptionsThatDoNotGoTogether) {
  for (const TraversalOptions& options : test::every_traversal_options()) {
    EXPECT_EQ(message(options), "") << test::describe(options);
  }
  EXPECT_EQ(message({.traversal = Traversal::ericson, .ericson_rule = Traversal::e_node}),
            "traversal ericson: 'e_node' is not a rule of descent; "
            "use a_first, b_first, alternate, larger or simultaneous");
  EXPECT_EQ(message({.traversal = Traversal::e_node_front, .descent = Descent::cross}),
            "traversal e_node_front: a front of descent 'cross' cannot be kept; "
            "use descent both or larger");
  EXPECT_NE(message({.traversal = Traversal::e_node_front, .prune = false}), "");
  EXPECT_NE(message({.traversal = static_cast<Traversal>(77)}), "");
  EXPECT_NE(message({.descent = static_cast<Descent>(77)}), "");
  EXPECT_NE(message({.ericson_rule = static_cast<Traversal>(77)}), "");
  EXPECT_EQ(message({.order = static_cast<EntryOrder>(77)}),
            "traversal: unknown order; use tree or volume");
  EXPECT_EQ(message({.update = static_cast<BoxUpdate>(77)}),
            "traversal: unknown update; use refit or rebox");
}

TEST(Traversals, RefuseBoxesOfAnotherTreeAndTheLayout) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 3);
  const Tree tree = test::random_tree(rng, mesh, 1);
  const std::vector<Box> short_by_one(tree.nodes.size() - 1);
  const std::vector<Box> right(tree.nodes.size());
  const TraversalOptions larger{.traversal = Traversal::larger};
  EXPECT_THROW(traverse({&tree, short_by_one}, {&tree, right}, larger), Error);
  EXPECT_THROW(traverse({&tree, right}, {nullptr, right}, larger), Error);
  EXPECT_THROW(traverse({&tree, right}, {&tree, right}, {}), Error);
}

TEST(TraversalTable, HasEachTraversalUnderBothSpellings) {
  for (std::size_t i = 0; i < traversals().size(); ++i) {
    const TraversalEntry& e = traversals()[i];
    EXPECT_EQ(static_cast<std::size_t>(e.traversal), i);
    EXPECT_EQ(traversal_named(e.name).traversal, e.traversal);
    EXPECT_EQ(traversal_named(e.kebab).traversal, e.traversal);
    EXPECT_EQ(e.function == nullptr, e.traversal == Traversal::fast);
    std::string spelled(e.name);
    std::replace(spelled.begin(), spelled.end(), '_', '-');
    EXPECT_EQ(spelled, e.kebab);
    EXPECT_FALSE(e.description.empty());
  }
  EXPECT_EQ(traversals().back().traversal, Traversal::e_node_front);
  EXPECT_EQ(traversal_named("default").traversal, TraversalOptions{}.traversal);
  EXPECT_EQ(descents().size(), 4U);
  for (const DescentEntry& e : descents()) {
    EXPECT_EQ(descent_named(e.name).descent, e.descent);
    EXPECT_EQ(&entry(e.descent), &e);
  }
}

TEST(TraversalTable, ListsNamesWhenOneIsUnknown) {
  try {
    (void)traversal_named("enode");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_STREQ(error.what(),
                 "traversal 'enode' is unknown; use one of fast, a-first, b-first, alternate, "
                 "larger, simultaneous, ericson, larsson, e-node, e-node-front");
  }
  EXPECT_THROW((void)descent_named("Both"), Error);
}

}  // namespace
}  // namespace soms
