#include "soms/scene/detail/contact_place.h"

#include "soms/base/common_box.h"
#include "soms/geometry/triangle_overlap.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <utility>
#include <vector>

namespace soms {

namespace {

using PosedPairs = std::vector<std::pair<Triangle, Triangle>>;

Triangle shifted(const Triangle& t, const Vec3& by) {
  return {t.a + by, t.b + by, t.c + by};
}

/// A triangle of z = 0 and one that stands on its middle, at `x`.
std::pair<Triangle, Triangle> standing(double x) {
  const Triangle flat{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}};
  const Triangle upright{{0, 0, 0}, {-1, 0, 2}, {1, 0, 2}};
  return {shifted(flat, {x, 0, 0}), shifted(upright, {x, 0, 0})};
}

TEST(ContactPlace, IsInTheMidstOfAllPairs) {
  const detail::ContactPlace place =
      detail::contact_place(PosedPairs{standing(0), standing(10), standing(14), standing(30)});
  EXPECT_EQ(place.pair, 2U);
  EXPECT_EQ(place.point, (Vec3{14, 0, 0}));
  EXPECT_EQ(place.box, (Box{{-1, 0, 0}, {31, 0, 0}}));
}

TEST(ContactPlace, EquallyNearPairsAreDecidedByTheirOrder) {
  EXPECT_EQ(detail::contact_place(PosedPairs{standing(0), standing(2)}).pair, 0U);
  EXPECT_EQ(detail::contact_place(PosedPairs{standing(2), standing(0)}).pair, 0U);
}

TEST(ContactPlace, LiesInBothTrianglesOfItsPair) {
  std::size_t seen = 0;
  test::for_each_case("scene/contact-place", 200, [&](Rng& rng) {
    const Mesh a = test::random_mesh(rng);
    const Mesh b = test::random_mesh(rng);
    PosedPairs pairs;
    for (TriangleId i = 0; i < a.triangles.size(); ++i) {
      for (TriangleId j = 0; j < b.triangles.size(); ++j) {
        if (triangles_overlap(a.triangle(i), b.triangle(j))) {
          pairs.emplace_back(a.triangle(i), b.triangle(j));
        }
      }
    }
    if (pairs.empty()) {
      return;
    }
    ++seen;
    const detail::ContactPlace place = detail::contact_place(pairs);
    const auto& [s, t] = pairs[place.pair];
    Box near;  // corners of the meshes are small integers
    near.grow(place.point - Vec3{1e-9, 1e-9, 1e-9});
    near.grow(place.point + Vec3{1e-9, 1e-9, 1e-9});
    EXPECT_TRUE(overlaps(near, common_box(bounds(s), bounds(t))));
    EXPECT_TRUE(overlaps(near, place.box));
    for (const Triangle& triangle : {s, t}) {
      const Vec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
      EXPECT_NEAR(dot(normal, place.point - triangle.a), 0, 1e-9);
    }
  });
  EXPECT_GT(seen, 50U);
}

}  // namespace

}  // namespace soms
