#include "soms/tree/visits.h"

#include "soms/base/error.h"
#include "soms/generate/urban.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/tree/inputs.h"

#include <limits>

namespace soms {
namespace {

Box cube(const Vec3& center, double side) {
  const double h = 0.5 * side;
  return {{center.x - h, center.y - h, center.z - h}, {center.x + h, center.y + h, center.z + h}};
}

/// Triangles with integer corners in a cube of side 8.
Mesh lattice_mesh(Rng& rng, std::size_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back({static_cast<double>(rng.below(9)), static_cast<double>(rng.below(9)),
                               static_cast<double>(rng.below(9))});
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Every node queried on its own, with no descent.
Visits visits_of_all_nodes(const Tree& tree, const Box& query) {
  Visits visits;
  for (const Node& node : tree.nodes) {
    if (overlaps(node.bounds, query)) {
      ++visits.nodes;
      visits.leaves += node.is_leaf();
      visits.triangles += node.is_leaf() ? node.count : 0;
    }
  }
  return visits;
}

/// Mean over a query at the middle of each unit cell of the grown root. Node boxes have integer
/// bounds and the side is even, so each cell lies wholly inside a grown box or wholly outside: the
/// mean over cells is the mean over all places.
ExpectedVisits mean_over_cells(const Tree& tree, double side) {
  const Box root = tree.nodes[0].bounds;
  const double h = 0.5 * side;
  ExpectedVisits sum;
  double cells = 0;
  for (double x = root.lower.x - h + 0.5; x < root.upper.x + h; ++x) {
    for (double y = root.lower.y - h + 0.5; y < root.upper.y + h; ++y) {
      for (double z = root.lower.z - h + 0.5; z < root.upper.z + h; ++z) {
        const Visits visits = visits_of_all_nodes(tree, cube({x, y, z}, side));
        sum.nodes += static_cast<double>(visits.nodes);
        sum.leaves += static_cast<double>(visits.leaves);
        sum.triangles += static_cast<double>(visits.triangles);
        ++cells;
      }
    }
  }
  return {sum.nodes / cells, sum.leaves / cells, sum.triangles / cells};
}

TEST(Visits, OfAQueryAreTheNodesWhoseBoxesItOverlaps) {
  test::for_each_case("visits/count", 200, [](Rng& rng) {
    const Mesh mesh = lattice_mesh(rng, 1 + rng.below(100));
    BuildOptions options;
    options.rule = rules()[rng.below(rules().size())].rule;
    options.per_leaf = 1 + static_cast<int>(rng.below(8));
    const Tree tree = build(mesh, options);
    const Vec3 center{rng.uniform(-2, 10), rng.uniform(-2, 10), rng.uniform(-2, 10)};
    const Box query = cube(center, rng.uniform(0, 4));
    EXPECT_EQ(count_visits(tree, query), visits_of_all_nodes(tree, query));
  });
}

TEST(Visits, ExpectedAreTheMeanOverAllPlacesOfTheQuery) {
  test::for_each_case("visits/expected", 20, [](Rng& rng) {
    const Mesh mesh = lattice_mesh(rng, 1 + rng.below(40));
    BuildOptions options;
    options.rule = rules()[rng.below(rules().size())].rule;
    options.per_leaf = 1 + static_cast<int>(rng.below(4));
    const Tree tree = build(mesh, options);
    for (const double side : {2.0, 6.0}) {
      const ExpectedVisits expected = expected_visits(tree, {side, side, side});
      const ExpectedVisits mean = mean_over_cells(tree, side);
      EXPECT_NEAR(expected.nodes, mean.nodes, 1e-9 * mean.nodes);
      EXPECT_NEAR(expected.leaves, mean.leaves, 1e-9 * mean.leaves);
      EXPECT_NEAR(expected.triangles, mean.triangles, 1e-9 * mean.triangles);
    }
  });
}

TEST(Visits, ExpectedOfTwoHalvesAreTwoForPointsAndThreeForLargeBoxes) {
  // Two triangles whose boxes are the halves of a cube of side 2.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 2, 0}, {1, 0, 2}, {1, 0, 0}, {2, 2, 0}, {2, 0, 2}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  BuildOptions options;
  options.per_leaf = 1;
  const Tree tree = build(mesh, options);
  EXPECT_EQ(expected_visits(tree, {0, 0, 0}), (ExpectedVisits{2, 1, 1}));
  EXPECT_EQ(expected_visits(tree, {2, 0, 0}), (ExpectedVisits{2.5, 1.5, 1.5}));
  EXPECT_NEAR(expected_visits(tree, {1e9, 1e9, 1e9}).nodes, 3, 1e-8);
}

TEST(Visits, FlatMeshesAreRequestedByFlatBoxes) {
  const Mesh mesh = test::make_input(test::Input::coplanar, 64);
  const Tree tree = build(mesh);
  const ExpectedVisits flat = expected_visits(tree, {0.5, 0.5, 0});
  EXPECT_GT(flat.nodes, 1);
  EXPECT_LT(flat.nodes, static_cast<double>(tree.nodes.size()));
  EXPECT_EQ(flat, expected_visits(tree, {0.5, 0.5, 1}));  // every node reaches as far on z
}

TEST(Visits, OfTreesWithoutTrianglesAreNone) {
  EXPECT_EQ(count_visits(Tree{}, cube({0, 0, 0}, 1)), Visits{});
  EXPECT_EQ(expected_visits(Tree{}, {1, 1, 1}), ExpectedVisits{});
}

TEST(Visits, NodesWithoutTrianglesAreNeverVisited) {
  BuildOptions options = thesis_options(Rule::soms, 5);
  options.empty_side = EmptySide::chain;
  const Tree tree = build(test::make_input(test::Input::coincident, 6), options);
  ASSERT_EQ(tree.nodes.size(), 9U);  // of which 4 are empty
  EXPECT_EQ(expected_visits(tree, {1, 1, 1}).nodes, 5);
}

TEST(Visits, RefuseSizesThatAreNone) {
  const Tree tree = build(generate_urban(UrbanScene::plain));
  for (const double side :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    try {
      static_cast<void>(expected_visits(tree, {1, side, 1}));
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

}  // namespace
}  // namespace soms
