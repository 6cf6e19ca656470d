#include "tests/support/shortest_segment.h"

#include "soms/geometry/triangle_distance.h"

#include "tests/support/bodies.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

namespace soms::test {

namespace {

constexpr double kPositiveInfinity = std::numeric_limits<double>::infinity();

double ulp(double x) {
  return std::nextafter(x, kPositiveInfinity) - x;
}

double largest_coordinate(const Triangle& s, const Triangle& t) {
  double largest = 0;
  for (const Vec3& v : {s.a, s.b, s.c, t.a, t.b, t.c}) {
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  }
  return largest;
}

bool is_near(const Vec3& point, const Triangle& t, double most) {
  return triangles_within({point, point, point}, t, most);
}

}  // namespace

Triangle moved_triangle(const Body& body, TriangleId id) {
  const Triangle t = body.shape.mesh().triangle(id);
  return {body.pose.apply(t.a), body.pose.apply(t.b), body.pose.apply(t.c)};
}

Body body_of(const Triangle& t) {
  return Body(soup_body({t}));
}

Bracket distance_of_pair(const Body& a, const Body& b, const TrianglePair& pair) {
  return triangle_distance(moved_triangle(a, pair.a), moved_triangle(b, pair.b)).distance;
}

std::string fault_of_points(const Body& a, const Body& b, const TrianglePair& pair, const Vec3& p,
                            const Vec3& q, const Bracket& d) {
  const Triangle s = moved_triangle(a, pair.a);
  const Triangle t = moved_triangle(b, pair.b);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(p[axis]) || !std::isfinite(q[axis])) {
      return "a coordinate of a point is not a number";
    }
  }
  const double unit = ulp(largest_coordinate(s, t));
  const double most = 4 * unit;
  if (!is_near(p, s, most)) {
    return "point_a is not on the first triangle";
  }
  if (!is_near(q, t, most)) {
    return "point_b is not on the second triangle";
  }
  // The sum and the difference may round once more.
  const double slack = 2 * most + unit;
  const Bracket apart = triangle_distance({p, p, p}, {q, q, q}).distance;
  // Written so that NaN fails.
  if (!(apart.lower <= d.upper + slack && apart.upper >= d.lower - slack)) {
    return "the points are not as far apart as the triangles";
  }
  return {};
}

}  // namespace soms::test
