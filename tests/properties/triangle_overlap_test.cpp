// Two triangles against a twin of another kind: the edge rule in unfiltered exact signs.
#include "soms/geometry/triangle_overlap.h"

#include "soms/geometry/detail/exact/orientation_exact.h"

#include "tests/properties/near_touch.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace soms {
namespace {

using Corners = std::array<Vec3, 3>;

int side(const Corners& t, const Vec3& p) {
  return static_cast<int>(detail::orientation_wide(t[0], t[1], t[2], p));
}

/// True if the edge pq, whose ends are not both in the plane of t, meets t.
bool edge_meets(const Vec3& p, const Vec3& q, const Corners& t) {
  if (side(t, p) * side(t, q) > 0) {
    return false;
  }
  bool left = false;
  bool right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign sign = detail::orientation_wide(p, q, t[k], t[(k + 1) % 3]);
    left = left || sign == Sign::positive;
    right = right || sign == Sign::negative;
  }
  return !(left && right);
}

/// The edge rule for triangles in different planes: they meet iff an edge of one meets the other.
/// Edges within the other's plane may be skipped.
bool some_edge_meets(const Corners& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = s[k];
    const Vec3& q = s[(k + 1) % 3];
    if ((side(t, p) != 0 || side(t, q) != 0) && edge_meets(p, q, t)) {
      return true;
    }
  }
  return false;
}

bool in_one_plane(const Corners& s, const Corners& t) {
  return side(t, s[0]) == 0 && side(t, s[1]) == 0 && side(t, s[2]) == 0;
}

TEST(TriangleOverlapProperty, AgreesWithTheEdgeRuleNearContact) {
  int cases = 0;
  int touching = 0;
  test::for_each_case("triangle-overlap/edge-rule", 20000, [&](Rng& rng) {
    ++cases;
    auto [s, t] = test::nearly_touching(rng);
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(1270)) - 1000);
    for (Vec3* p : {&s.a, &s.b, &s.c, &t.a, &t.b, &t.c}) {
      *p = scale * *p;
    }
    const Corners u{s.a, s.b, s.c};
    const Corners v{t.a, t.b, t.c};
    if (in_one_plane(u, v) || in_one_plane(v, u)) {
      return;
    }
    const bool expected = some_edge_meets(u, v) || some_edge_meets(v, u);
    touching += expected ? 1 : 0;
    EXPECT_EQ(triangles_overlap(s, t), expected);
    EXPECT_EQ(triangles_overlap(t, s), expected);
  });
  EXPECT_GT(touching, cases / 4);
  EXPECT_LT(touching, cases - cases / 20);
}

}  // namespace
}  // namespace soms
