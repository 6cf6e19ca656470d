#include "soms/query/detail/winding/boundary.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms::detail {
namespace {

using Edges = std::vector<BoundaryEdge>;

TEST(Boundary, OfTwoNeighborsIsTheirOutline) {
  Edges edges;
  add_edges({0, 1, 2}, 1, edges);
  add_edges({2, 1, 3}, 1, edges);
  cancel(edges);
  EXPECT_EQ(edges, (Edges{{0, 1, 1}, {2, 0, 1}, {1, 3, 1}, {3, 2, 1}}));
}

TEST(Boundary, CountsEdgesThatFaceOneWay) {
  Edges edges;
  add_edges({0, 1, 2}, 1, edges);
  add_edges({0, 1, 3}, 1, edges);
  cancel(edges);
  EXPECT_EQ(edges.front(), (BoundaryEdge{0, 1, 2}));
  EXPECT_EQ(edges.size(), 5U);
  add_edges({0, 1, 2}, -1, edges);
  add_edges({0, 1, 3}, -1, edges);
  cancel(edges);
  EXPECT_TRUE(edges.empty());
}

TEST(Boundary, LeavesOutEdgesWithoutLength) {
  Edges edges;
  add_edges({4, 4, 9}, 1, edges);
  cancel(edges);
  EXPECT_TRUE(edges.empty());
}

}  // namespace
}  // namespace soms::detail
