// No triangle is lost whose moved box meets a box, however the tree is kept and wherever it is.
#include "soms/query/detail/solid/box_search.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

std::vector<TriangleId> sorted_ids(const std::vector<detail::MovedTriangle>& found) {
  std::vector<TriangleId> ids;
  for (const detail::MovedTriangle& triangle : found) {
    ids.push_back(triangle.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<TriangleId> found_in(detail::BoxSearch& search, const Box& box) {
  std::vector<detail::MovedTriangle> found;
  Cost cost;
  search.find(box, found, cost);
  return sorted_ids(found);
}

std::vector<TriangleId> found_beside(detail::BoxSearch& search, TriangleId id) {
  std::vector<detail::MovedTriangle> found;
  Cost cost;
  search.find_beside(id, found, cost);
  return sorted_ids(found);
}

/// A pose that rounds what it moves, from near to so far that little is left.
Pose rounding_pose(Rng& rng, double far) {
  Pose pose = rng.below(4) == 0 ? Pose{} : test::awkward_rotation(rng);
  for (std::size_t k = 0; k < 3; ++k) {
    pose.m[4 * k + 3] = far * rng.uniform(-1, 1);
  }
  return pose;
}

TEST(BoxSearch, FindsEveryTriangleAndNoOther) {
  test::for_each_case("query/box-search", 60, [](Rng& rng) {
    const Mesh mesh = generate_knot(200 + 2 * rng.below(100));
    const double far = std::exp2(rng.uniform(-2, 52));
    const Pose pose = rounding_pose(rng, far);
    const Body body(Shape(mesh, {.layout = rng.below(2) == 0 ? Layout::wide : Layout::compact}),
                    pose);
    detail::BoxSearch search(body);
    const auto moved = reference::detail::moved_triangles(mesh, pose);
    for (int i = 0; i < 40; ++i) {
      const Triangle& t = moved[rng.below(moved.size())];
      Box box{t.a, t.a};
      if (rng.below(2) == 0) {
        box.grow(t.b);
      }
      if (rng.below(3) == 0) {
        box.upper[rng.below(3)] = std::numeric_limits<double>::infinity();
      }
      std::vector<TriangleId> expected;
      for (std::size_t k = 0; k < moved.size(); ++k) {
        if (overlaps(bounds(moved[k]), box)) {
          expected.push_back(static_cast<TriangleId>(k));
        }
      }
      ASSERT_EQ(found_in(search, box), expected);
    }
  });
}

TEST(BoxSearch, FindsAllThatTouchesATriangle) {
  test::for_each_case("query/box-search-beside", 60, [](Rng& rng) {
    const Mesh mesh = generate_knot(200 + 2 * rng.below(100));
    const double far = std::exp2(rng.uniform(-2, 52));
    const Pose pose = rounding_pose(rng, far);
    const Body body(Shape(mesh, {.layout = rng.below(2) == 0 ? Layout::wide : Layout::compact}),
                    pose);
    detail::BoxSearch search(body);
    const auto moved = reference::detail::moved_triangles(mesh, pose);
    const auto id = static_cast<TriangleId>(rng.below(moved.size()));
    const std::vector<TriangleId> found = found_beside(search, id);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      if (triangles_overlap(moved[id], moved[k])) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), static_cast<TriangleId>(k)));
      }
    }
    if (far < 0x1p30) {  // farther away, all are within a rounding of each other
      EXPECT_LT(found.size(), mesh.triangles.size() / 2);
    }
  });
}

// Two triangles 2^-10 apart: less than a quarter, the unit in the last place at 2^50.
TEST(BoxSearch, FindsWhatRoundingPutsBesideATriangle) {
  Mesh mesh;
  for (const double z : {0.0, 0x1p-10}) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, z}, {1, 0, z}, {0, 1, z}});
  }
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const Body here(Shape{Mesh(mesh)});
  const Body far(Shape{Mesh(mesh)}, Pose::translation(0, 0, 0x1p50));
  detail::BoxSearch near_search(here);
  detail::BoxSearch far_search(far);
  EXPECT_EQ(found_beside(near_search, 0), std::vector<TriangleId>{0});
  EXPECT_EQ(found_beside(far_search, 0), (std::vector<TriangleId>{0, 1}));
  EXPECT_EQ(far_search.moved(0).a, far_search.moved(1).a);
}

}  // namespace
}  // namespace soms
