#include "thesis/trees/neutral_builders.h"

#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"
#include "soms/io/read_mesh.h"
#include "soms/tree/build.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace soms::reproduce {
namespace {

constexpr std::array kRules{Rule::spatial_median, Rule::soms};
constexpr std::array kWays{NeutralWay::thesis_like, NeutralWay::in_place};
constexpr std::array kTestedEmptySides{EmptySide::stop, EmptySide::next_axis,
                                       EmptySide::object_median, EmptySide::chain};

BuildOptions neutral_options(Rule rule, int level, EmptySide empty_side = EmptySide::stop) {
  BuildOptions options = thesis_options(rule, level);
  options.empty_side = empty_side;
  return options;
}

/// The order of triangles within a leaf is nobody's business.
Tree with_sorted_leaves(Tree tree) {
  for (const Node& node : tree.nodes) {
    if (node.is_leaf()) {
      const auto first = tree.primitives.begin() + node.first;
      std::sort(first, first + node.count);
    }
  }
  return tree;
}

/// Both ways give the nodes of the library's builder at every one of the levels, buffers kept.
void expect_the_librarys_trees(const Mesh& mesh, EmptySide empty_side, int least, int greatest) {
  for (const Rule rule : kRules) {
    for (int level = least; level <= greatest; ++level) {
      const BuildOptions options = neutral_options(rule, level, empty_side);
      const Tree expected = build(mesh, options);
      for (const NeutralWay way : kWays) {
        NeutralBuilder builder(way, options);
        for (int time = 0; time < 2; ++time) {
          const Tree tree = builder.build(mesh);
          EXPECT_EQ(tree.nodes, expected.nodes)
              << entry(rule).name << ", level " << level << ", " << name(empty_side) << ", way "
              << static_cast<int>(way) << ", build " << time;
          EXPECT_EQ(with_sorted_leaves(tree).primitives, expected.primitives);
        }
      }
    }
  }
}

TEST(NeutralBuilders, MakeTheLibrarysTreesOfAwkwardMeshes) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    for (const std::size_t count : {0U, 1U, 2U, 3U, 60U, 400U}) {
      for (const EmptySide empty_side : kTestedEmptySides) {
        expect_the_librarys_trees(test::make_input(input, count, count + 1), empty_side, 1, 15);
      }
      if (HasFailure()) {
        return;
      }
    }
  }
}

TEST(NeutralBuilders, MakeTheLibrarysTreesFarAwayAndTiny) {
  test::for_each_case("neutral_builders", 20, [](Rng& rng) {
    Mesh mesh = test::make_input(test::Input::random, 1 + rng.below(120), rng.next());
    const double size = std::array{1e-300, 1e-6, 1.0, 1e6}[rng.below(4)];
    const double far = std::array{0.0, 1e8, 1e15}[rng.below(3)];
    for (Vec3& v : mesh.vertices) {
      v = size * (v + Vec3{far, -far, far});
    }
    expect_the_librarys_trees(mesh, EmptySide::stop, 1, 15);
    expect_the_librarys_trees(mesh, EmptySide::chain, 15, 15);
  });
}

TEST(NeutralBuilders, MakeTheLibrarysTreesOfTheScenes) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  for (const UrbanScene scene : {UrbanScene::mixed, UrbanScene::boxes, UrbanScene::plain}) {
    const Mesh mesh = generate_urban(scene);
    expect_the_librarys_trees(mesh, EmptySide::stop, 1, 15);
    for (const EmptySide empty_side : kTestedEmptySides) {
      expect_the_librarys_trees(mesh, empty_side, 13, 13);
    }
  }
}

TEST(NeutralBuilders, OneBuilderServesMeshesOfAnySize) {
  for (const NeutralWay way : kWays) {
    NeutralBuilder builder(way, neutral_options(Rule::soms, 15));
    for (const std::uint64_t count : {500U, 0U, 20U, 900U, 100U}) {
      const Mesh mesh = count == 0 ? Mesh{} : generate_knot(count);
      EXPECT_EQ(builder.build(mesh).nodes, build(mesh, neutral_options(Rule::soms, 15)).nodes)
          << count;
    }
  }
}

/// What a build must do, from its tree.
BuildWork work_from(const Tree& tree, NeutralWay way, Rule rule) {
  const std::uint64_t all = tree.primitives.size();
  BuildWork work;
  std::uint64_t in_nodes = 0;
  for (const Node& node : tree.nodes) {
    in_nodes += node.count;
    work.compared += node.is_leaf() && !node.undividable ? 0 : node.count;
    work.merged += node.is_leaf() ? 0U : 1U;
  }
  if (way == NeutralWay::thesis_like) {
    return {work.compared, in_nodes, rule == Rule::soms ? work.compared : 0, 0};
  }
  return rule == Rule::soms ? BuildWork{work.compared, all, all + work.compared, work.merged}
                            : BuildWork{work.compared, all + work.compared, 0, 0};
}

TEST(NeutralBuilders, WorkIsWhatTheTreeTells) {
  const Mesh mesh = generate_urban(UrbanScene::plain);
  for (const NeutralWay way : kWays) {
    for (const Rule rule : kRules) {
      for (const int level : {1, 7, 13}) {
        for (const EmptySide empty_side : {EmptySide::stop, EmptySide::chain}) {
          NeutralBuilder builder(way, neutral_options(rule, level, empty_side));
          const Tree tree = builder.build(mesh);
          EXPECT_EQ(builder.work(), work_from(tree, way, rule))
              << entry(rule).name << ", level " << level << ", " << name(empty_side);
        }
      }
    }
  }
}

TEST(NeutralBuilders, RefuseWhatTheyDoNotKnow) {
  const auto refuses = [](const BuildOptions& options) {
    EXPECT_THROW(NeutralBuilder(NeutralWay::in_place, options), std::logic_error);
  };
  refuses(neutral_options(Rule::object_mean, 15));
  refuses(neutral_options(Rule::soms, 0));
  refuses(BuildOptions{});
  BuildOptions outer = neutral_options(Rule::soms, 15);
  outer.axis_from = AxisFrom::outer;
  refuses(outer);
}

}  // namespace
}  // namespace soms::reproduce
