// No triangle is lost whose moved box meets a box, however the tree is kept and wherever it is.
#include "soms/query/detail/solid/box_search.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace soms {
namespace {

std::vector<TriangleId> found_in(detail::BoxSearch& search, const Box& box) {
  std::vector<detail::MovedTriangle> found;
  Cost cost;
  search.find(box, found, cost);
  std::vector<TriangleId> ids;
  for (const detail::MovedTriangle& triangle : found) {
    ids.push_back(triangle.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST(BoxSearch, FindsEveryTriangleAndNoOther) {
  test::for_each_case("query/box-search", 60, [](Rng& rng) {
    const Mesh mesh = generate_knot(200 + 2 * rng.below(100));
    Pose pose = rng.below(4) == 0 ? Pose{} : test::awkward_rotation(rng);
    const double far = std::exp2(rng.uniform(-2, 52));
    for (std::size_t k = 0; k < 3; ++k) {
      pose.m[4 * k + 3] = far * rng.uniform(-1, 1);
    }
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

}  // namespace
}  // namespace soms
