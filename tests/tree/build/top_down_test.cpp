#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"

#include "tests/support/slow_build.h"
#include "tests/tree/inputs.h"

#include <algorithm>
#include <array>
#include <functional>
#include <stop_token>
#include <vector>

namespace soms {
namespace {

constexpr std::array<std::size_t, 7> kSizes{0, 1, 2, 3, 7, 64, 1000};
constexpr std::array<EmptySide, 4> kEmptySides{EmptySide::stop, EmptySide::next_axis,
                                               EmptySide::object_median, EmptySide::chain};

/// Every combination of options that changes a tree, with a level limit.
void for_each_options(const std::function<void(const BuildOptions&)>& body) {
  for (const RuleEntry& rule : rules()) {
    if (rule.own_builder) {
      body(thesis_options(rule.rule));  // they have no other
      continue;
    }
    for (const Midpoint midpoint : {Midpoint::thesis, Midpoint::centroid, Midpoint::aabb}) {
      for (const AxisFrom axis : {AxisFrom::outer, AxisFrom::inner}) {
        for (const EmptySide empty : kEmptySides) {
          BuildOptions options = thesis_options(rule.rule);
          options.midpoint = midpoint;
          options.axis_from = axis;
          options.empty_side = empty;
          body(options);
        }
      }
    }
  }
}

/// What must hold for any tree of the thesis' options, besides being whole.
void expect_consistent(const Tree& tree, const Mesh& mesh, const BuildOptions& options) {
  ASSERT_EQ(find_fault(tree, mesh), "");
  const TreeStatistics s = statistics(tree, options);
  EXPECT_LT(s.depth, 15U);
  if (options.empty_side != EmptySide::chain) {
    EXPECT_EQ(s.empty, 0U);
    EXPECT_EQ(s.nodes + (mesh.triangles.empty() ? 0 : 1), 2 * s.leaves);
  }
  if (options.rule == Rule::object_median) {
    EXPECT_LE(s.max_leaf_depth - s.min_leaf_depth, 1U);
    EXPECT_EQ(s.undividable, 0U);
  }
  for (const Node& node : tree.nodes) {
    const auto ids = tree.triangles_of(node);
    if (node.is_leaf()) {
      EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
      const bool stopped = options.empty_side == EmptySide::stop && node.count > 1;
      EXPECT_TRUE(!stopped || node.undividable || node.depth == 14);
    }
  }
}

TEST(Build, IsWholeForEveryRuleOptionSizeAndInput) {
  std::size_t row = 0;
  for (const test::Input input : test::kInputs) {
    ++row;
    for (std::size_t column = 0; column < kSizes.size(); ++column) {
      // All small ones take no time.
      const std::size_t size = kSizes[column];
      if (size > 64 && !test::is_tried(row, column, kSizes.size() - 3)) {
        continue;
      }
      SCOPED_TRACE(test::name(input) + " " + std::to_string(size));
      const Mesh mesh = test::make_input(input, size);
      for_each_options([&](const BuildOptions& options) {
        SCOPED_TRACE(entry(options.rule).name);
        expect_consistent(build(mesh, options), mesh, options);
      });
    }
  }
}

TEST(Build, WithProductOptionsEndsInLeavesOfAtMostEightAboveDepth64) {
  std::size_t row = 0;
  for (const RuleEntry& rule : rules()) {
    ++row;
    for (std::size_t column = 0; column < test::kInputs.size(); ++column) {
      if (!test::is_tried(row, column, test::kInputs.size())) {
        continue;
      }
      const test::Input input = test::kInputs[column];
      for (const std::size_t size : {std::size_t{9}, std::size_t{1000}, std::size_t{20000}}) {
        SCOPED_TRACE(std::string(rule.name) + " " + test::name(input) + " " + std::to_string(size));
        BuildOptions options;
        options.rule = rule.rule;
        const Mesh mesh = test::make_input(input, size);
        const Tree tree = build(mesh, options);
        ASSERT_EQ(find_fault(tree, mesh), "");
        const TreeStatistics s = statistics(tree, options);
        EXPECT_LE(s.largest_leaf, 8U);
        EXPECT_LE(s.depth, 63U);
        EXPECT_TRUE(std::none_of(tree.nodes.begin(), tree.nodes.end(),
                                 [](const Node& n) { return n.id == kNoTreeId; }));
      }
    }
  }
}

TEST(Build, GivesTheSameTreeForAnyNumberOfThreads) {
  constexpr std::array kTried = {test::Input::random, test::Input::huge_and_tiny,
                                 test::Input::coplanar, test::Input::coincident};
  std::size_t row = 0;
  for (const RuleEntry& rule : rules()) {
    ++row;
    for (std::size_t column = 0; column < kTried.size(); ++column) {
      if (!test::is_tried(row, column, kTried.size())) {
        continue;
      }
      const test::Input input = kTried[column];
      SCOPED_TRACE(std::string(rule.name) + " " + test::name(input));
      const Mesh mesh = test::make_input(input, test::kSlowBuild ? 10000 : 40000);
      for (const bool thesis : {false, true}) {
        BuildOptions options = thesis ? thesis_options(rule.rule) : BuildOptions{};
        options.rule = rule.rule;
        const Tree one = build(mesh, options);
        const Tree two = build(mesh, options, {.threads = 2});
        const Tree eight = build(mesh, options, {.threads = 8});
        EXPECT_EQ(tree_hash(one), tree_hash(two));
        EXPECT_TRUE(one == two && one == eight);
      }
    }
  }
}

// The builder changes its way above 8192 triangles: both ways must give one tree.
TEST(Build, OfALargeMeshContainsTheBuildOfEachHalf) {
  const Mesh mesh = test::make_input(test::Input::random, 20000);
  const BuildOptions options = thesis_options(Rule::soms, 20);
  const Tree tree = build(mesh, options);
  const Node& left = tree.nodes[tree.nodes[0].left];
  Mesh half;
  half.vertices = mesh.vertices;
  for (const TriangleId id : tree.triangles_of(left)) {
    half.triangles.push_back(mesh.triangles[id]);
  }
  // Ascending numbers keep the order of the triangles.
  std::sort(half.triangles.begin(), half.triangles.end());
  const Tree part = build(half, thesis_options(Rule::soms, 19));
  ASSERT_EQ(part.nodes.size(), tree.nodes[0].right - 1);
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    ASSERT_EQ(part.nodes[i].bounds, tree.nodes[i + 1].bounds);
    ASSERT_EQ(part.nodes[i].count, tree.nodes[i + 1].count);
    ASSERT_EQ(part.nodes[i].depth + 1, tree.nodes[i + 1].depth);
  }
}

TEST(Build, PermutingTheTrianglesKeepsTheBoxes) {
  Mesh mesh = test::make_input(test::Input::random, 500);
  const BuildOptions options = thesis_options(Rule::soms, 24);
  const Tree before = build(mesh, options);
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const Tree after = build(mesh, options);
  ASSERT_EQ(before.nodes.size(), after.nodes.size());
  for (std::size_t i = 0; i < before.nodes.size(); ++i) {
    EXPECT_EQ(before.nodes[i].bounds, after.nodes[i].bounds);
  }
}

TEST(Build, ByAFunctionEqualsTheRuleOfThatFunction) {
  const Mesh mesh = generate_sphere(500);
  for (const RuleEntry& row : rules()) {
    if (row.own_builder) {
      continue;
    }
    for (const EmptySide empty : {EmptySide::stop, EmptySide::object_median}) {
      const BuildOptions options{.rule = row.rule,
                                 .midpoint = Midpoint::thesis,
                                 .axis_from = row.axis_from,
                                 .empty_side = empty,
                                 .per_leaf = 2};
      EXPECT_EQ(tree_hash(build_by(mesh, row.split, options)), tree_hash(build(mesh, options)))
          << row.name;
    }
  }
}

TEST(Build, ByARuleOfOnesOwnNeedsNoNamedRule) {
  const RuleFunction third = [](const SplitNode& node, std::size_t axis) {
    const double lower = node.inner.lower[axis];
    return Split{.axis = axis, .value = lower + (node.inner.upper[axis] - lower) / 3};
  };
  const Mesh mesh = generate_sphere(500);
  const Tree tree = build_by(mesh, third);
  EXPECT_EQ(find_fault(tree, mesh), "");
  EXPECT_NE(tree_hash(tree), tree_hash(build(mesh, {.rule = Rule::soms})));
  // The rule of the options is not looked at; `fast`, the default, would refuse the midpoint.
  EXPECT_EQ(find_fault(build_by(mesh, third, {.midpoint = Midpoint::thesis}), mesh), "");
  EXPECT_EQ(tree_hash(tree), tree_hash(build_by(mesh, third, {}, {.threads = 3})));
  EXPECT_TRUE(build_by(Mesh{}, third).nodes.empty());
  EXPECT_THROW((void)build_by(mesh, nullptr), Error);
  EXPECT_THROW((void)build_by(mesh, third, {.per_leaf = 0}), Error);
}

TEST(Build, AboveDepth63HasNoIdsAndNoLimit) {
  BuildOptions options = thesis_options(Rule::spatial_median, 0);
  const Mesh mesh = test::make_input(test::Input::halving, 300);
  const Tree tree = build(mesh, options);
  EXPECT_EQ(find_fault(tree, mesh), "");
  EXPECT_GT(statistics(tree, options).depth, 100U);
  for (const Node& node : tree.nodes) {
    EXPECT_EQ(node.id == kNoTreeId, node.depth > 63);
  }
}

TEST(Build, EmptySidesFollowTheirPolicy) {
  // All midpoints left of the middle on x, apart on y.
  Mesh mesh;
  for (const double y : {0.0, 10.0}) {
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{0, y, 0}, {0, y, 0}, {1, y, 0}});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  mesh.vertices.insert(mesh.vertices.end(), {{0, 4, 0}, {100, 4, 0}, {0, 4, 0}});
  mesh.triangles.push_back({6, 7, 8});
  BuildOptions options = thesis_options(Rule::spatial_median, 3);
  EXPECT_EQ(build(mesh, options).nodes.size(), 1U);
  EXPECT_TRUE(build(mesh, options).nodes[0].undividable);
  options.empty_side = EmptySide::next_axis;
  const Tree next = build(mesh, options);
  EXPECT_FALSE(next.nodes[0].undividable);
  EXPECT_EQ(next.nodes[1].count, 2U);  // y = 0 and 4 lie below the middle
  options.empty_side = EmptySide::object_median;
  const Tree halved = build(mesh, options);
  EXPECT_TRUE(halved.nodes[0].undividable);
  EXPECT_EQ(halved.nodes[1].count, 1U);
  options.empty_side = EmptySide::chain;
  const Tree chain = build(mesh, options);
  EXPECT_TRUE(chain.nodes[0].undividable);
  EXPECT_EQ(chain.nodes[1].count, 3U);
  EXPECT_EQ(chain.nodes[chain.nodes[0].right].count, 0U);
  EXPECT_TRUE(chain.nodes[chain.nodes[0].right].bounds.empty());
}

TEST(Build, CVertexTurnsTheCorners) {
  const Mesh mesh = test::make_input(test::Input::random, 300);
  for (const int c : {0, 1}) {
    Mesh rotated_corners = mesh;
    for (auto& t : rotated_corners.triangles) {
      t = c == 0 ? std::array{t[1], t[2], t[0]} : std::array{t[2], t[0], t[1]};
    }
    BuildOptions options = thesis_options(Rule::soms);
    const Tree expected = build(rotated_corners, options);
    EXPECT_FALSE(build(mesh, options) == expected);
    options.c_vertex = c;
    EXPECT_TRUE(build(mesh, options) == expected);
  }
}

// Its plane costs little where triangles are alike, and what SAH saves where they are not is kept.
TEST(Build, OfSomsSahIsNeverWorseThanSomsAndMuchBetterWhereTrianglesAreUnlike) {
  const auto cost = [](const Mesh& mesh, Rule rule) {
    BuildOptions options;
    options.rule = rule;
    return sah_cost(build(mesh, options));
  };
  for (const UrbanScene scene : {UrbanScene::mixed, UrbanScene::boxes, UrbanScene::plain}) {
    const Mesh mesh = generate_urban(scene);
    SCOPED_TRACE(mesh.source);
    EXPECT_LE(cost(mesh, Rule::soms_sah), cost(mesh, Rule::soms));
  }
  const Mesh mixed = generate_urban(UrbanScene::mixed);
  EXPECT_LT(cost(mixed, Rule::soms_sah), 0.7 * cost(mixed, Rule::soms));
}

TEST(Build, OfSahIsTheCheapestByAreaToAHundredthAndTheDefaultToAThird) {
  for (const UrbanScene scene : {UrbanScene::mixed, UrbanScene::boxes, UrbanScene::plain}) {
    const Mesh mesh = generate_urban(scene);
    SCOPED_TRACE(mesh.source);
    BuildOptions sah;
    sah.rule = Rule::sah;
    const double best = sah_cost(build(mesh, sah));
    EXPECT_LE(sah_cost(build(mesh)), best * 4 / 3);
    for (const RuleEntry& rule : rules()) {
      BuildOptions options;
      options.rule = rule.rule;
      EXPECT_LE(best, 1.01 * sah_cost(build(mesh, options))) << rule.name;
    }
  }
}

// Costs are compared in float: the tree is the same on every machine all the same.
TEST(Build, OfRulesThatCompareCostsIsTheSameEverywhere) {
  const auto hash = [](Rule rule, UrbanScene scene) {
    BuildOptions options;
    options.rule = rule;
    return tree_hash(build(generate_urban(scene), options));
  };
  EXPECT_EQ(hash(Rule::sah, UrbanScene::mixed), 0x5c6bf671d37050d2ULL);
  EXPECT_EQ(hash(Rule::sah, UrbanScene::boxes), 0x429ed80286c92830ULL);
  EXPECT_EQ(hash(Rule::sah, UrbanScene::plain), 0x36b55c9fb5fbd206ULL);
  EXPECT_EQ(hash(Rule::fast, UrbanScene::mixed), 0xe4de7e8ad8c3bc43ULL);
  EXPECT_EQ(hash(Rule::fast, UrbanScene::plain), 0x517afcea558ff299ULL);
  EXPECT_EQ(hash(Rule::quality, UrbanScene::mixed), 0x2b6933ad9465be82ULL);
  EXPECT_EQ(hash(Rule::quality, UrbanScene::plain), 0x67083c156f2f8b56ULL);
}

TEST(Build, StopsOnRequestAndReportsProgressInOrder) {
  const Mesh mesh = test::make_input(test::Input::random, 60000);
  std::vector<double> shares;
  const Limits watched{.progress = [&](double share) { shares.push_back(share); }};
  const Tree tree = build(mesh, {}, watched);
  EXPECT_TRUE(tree == build(mesh));
  ASSERT_GT(shares.size(), 5U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);

  std::stop_source source;
  const Limits stopped{.stop = source.get_token(), .progress = [&](double share) {
                         if (share > 0.5) {
                           source.request_stop();
                         }
                       }};
  try {
    static_cast<void>(build(mesh, {}, stopped));
    ADD_FAILURE() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
  source.request_stop();
  EXPECT_THROW(static_cast<void>(build(Mesh{}, {}, stopped)), Error);
}

}  // namespace
}  // namespace soms
