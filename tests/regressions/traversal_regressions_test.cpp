// R76 of the reported faults: traversal stacks shorter than the tree. Every traversal descends
// trees a thousand levels deep on a stack of 256 KiB.
#include "soms/base/error.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/e_node_front.h"
#include "soms/thesis/named_overlap.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build_options.h"

#include "tests/support/small_stack.h"
#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace soms {
namespace {

/// Triangles at 2^-k, k = 0 to 1000, apart from each other; their boxes' volumes underflow to 0.
Mesh powers_of_two() {
  Mesh mesh;
  for (int k = 0; k <= 1000; ++k) {
    const double s = std::ldexp(1.0, -k);
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {{s, 0, 0}, {1.25 * s, 0, 0}, {s, 0.25 * s, 0.25 * s}});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

/// A tree that splits one triangle off at each of its `depth` levels; the last leaf has the rest.
Tree chain(const Mesh& mesh, std::uint32_t depth) {
  Tree tree;
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  tree.primitives.resize(count);
  std::iota(tree.primitives.begin(), tree.primitives.end(), TriangleId{0});
  const auto add = [&](std::uint32_t first, std::uint32_t n, std::uint32_t at) {
    Node node;
    for (std::uint32_t i = first; i < first + n; ++i) {
      node.bounds.grow(bounds(mesh.triangle(i)));
    }
    node.first = first;
    node.count = n;
    node.depth = at;
    tree.nodes.push_back(node);
    return static_cast<std::uint32_t>(tree.nodes.size() - 1);
  };
  std::uint32_t inner = add(0, count, 0);
  for (std::uint32_t d = 1; d <= depth; ++d) {
    tree.nodes[inner].left = add(d - 1, 1, d);
    tree.nodes[inner].right = add(d, count - d, d);
    inner = tree.nodes[inner].right;
  }
  return tree;
}

/// Poses of a body of `powers_of_two` in which it meets its twin at many scales, or not at all.
std::vector<Pose> poses() {
  const double tiny = std::ldexp(1.0, -500);
  Pose turned;
  turned.m = {0, -1, 0, tiny, 1, 0, 0, -tiny, 0, 0, 1, 0};
  return {Pose::identity(), Pose::translation(tiny, 0, 0), Pose::translation(-0.25, 0, 0),
          turned,           Pose::translation(8, 0, 0),    Pose::identity()};
}

TEST(Regression, R76EveryTraversalDescendsAThousandLevelsOnASmallStack) {
  const Mesh mesh = powers_of_two();
  const Tree deep = chain(mesh, 1000);
  ASSERT_EQ(deep.nodes.size(), 2001U);
  PosedBoxes still(mesh, deep);
  PosedBoxes moving(mesh, deep);
  still.move({});
  test::on_small_stack([&] {
    for (const Pose& pose : poses()) {
      moving.move(pose);
      const auto truth = test::overlapping_leaves(moving.view(), still.view());
      for (const TraversalOptions& settings : test::every_traversal_options()) {
        if (!settings.recursive && settings.prune) {
          std::vector<NodePair> found;
          traverse(moving.view(), still.view(), settings, {.leaf_pair = [&](NodePair p) {
                     found.push_back(p);
                     return true;
                   }});
          EXPECT_EQ(test::sorted(found), truth) << test::describe(settings);
        }
      }
    }
  });
}

TEST(Regression, R76FrontsFollowAThousandLevelsOnASmallStack) {
  const Mesh mesh = powers_of_two();
  const Tree deep = chain(mesh, 1000);
  PosedBoxes still(mesh, deep);
  PosedBoxes moving(mesh, deep);
  still.move({});
  test::on_small_stack([&] {
    for (const Descent descent : {Descent::both, Descent::larger}) {
      EnodeFront front(deep, deep, descent);
      for (const Pose& pose : poses()) {
        moving.move(pose);
        const auto truth = test::overlapping_leaves(moving.view(), still.view());
        EXPECT_EQ(front.next(moving.boxes(), still.boxes()).leaf_pairs, truth.size());
      }
    }
  });
}

TEST(Regression, R76NamedOverlapsAreRightInDeepTreesOnASmallStack) {
  const Shape deep(powers_of_two(), {.build = thesis_options(Rule::soms, 0), .keep_tree = true});
  std::vector<Overlap> truth;
  for (const Pose& pose : poses()) {
    truth.push_back(reference::overlap(deep.mesh(), pose, deep.mesh(), {}));
  }
  EXPECT_EQ(truth[0].pairs.size(), 1001U);
  EXPECT_GT(truth[1].pairs.size(), 0U);
  test::on_small_stack([&] {
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      if (!settings.recursive && settings.prune) {
        thesis::NamedOverlap session(deep, deep, settings);
        for (std::size_t i = 0; i < truth.size(); ++i) {
          EXPECT_EQ(session(poses()[i], {}, {}, {}).pairs, truth[i].pairs)
              << test::describe(settings) << ", pose " << i;
        }
      }
    }
  });
}

TEST(Regression, R76RecursionIsRefusedWhereItCouldOverflow) {
  const Mesh mesh = powers_of_two();
  const Tree deep = chain(mesh, kMaxRecursion / 2);
  const Tree fits = chain(mesh, kMaxRecursion / 2 - 1);
  PosedBoxes deep_boxes(mesh, deep);
  PosedBoxes boxes(mesh, fits);
  deep_boxes.move({});
  boxes.move({});
  const auto truth = test::overlapping_leaves(deep_boxes.view(), boxes.view());
  test::on_small_stack([&] {
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      if (settings.recursive) {
        SCOPED_TRACE(test::describe(settings));
        EXPECT_EQ(traverse(deep_boxes.view(), boxes.view(), settings).leaf_pairs, truth.size());
        EXPECT_THROW(traverse(deep_boxes.view(), deep_boxes.view(), settings), Error);
      }
    }
  });
}

}  // namespace
}  // namespace soms
