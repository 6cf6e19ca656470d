#include "soms/clash/detail/open_parts.h"

#include "soms/base/arithmetic.h"
#include "soms/base/box.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace soms::detail {

namespace {

bool has_area(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::yz) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::zx) != Sign::zero;
}

bool are_opposite(Sign s, Sign t) {
  return s != Sign::zero && t != Sign::zero && s != t;
}

/// True if the line through `p` and `q` goes through the triangle strictly inside it.
bool line_goes_inside(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Sign side = orientation(p, q, t.a, t.b);
  return side != Sign::zero && orientation(p, q, t.b, t.c) == side &&
         orientation(p, q, t.c, t.a) == side;
}

/// An edge of a triangle, from corner `k` on, and the corner beside it.
struct Edge {
  Vec3 from;
  Vec3 to;
  Vec3 apex;
};

/// Calls `body` for the edges of `s`, if it has area, that go through `t`, until it is true.
template <class Body>
bool any_edge_through(const Triangle& s, const Triangle& t, const Body& body) {
  const std::array<Vec3, 3> corners{s.a, s.b, s.c};
  std::array<Sign, 3> side{};
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = orientation(t.a, t.b, t.c, corners[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (are_opposite(side[k], side[next]) && line_goes_inside(corners[k], corners[next], t) &&
        has_area(s) && body(Edge{corners[k], corners[next], corners[(k + 2) % 3]})) {
      return true;
    }
  }
  return false;
}

bool in_one_plane(const Triangle& s, const Triangle& t) {
  return orientation(s.a, s.b, s.c, t.a) == Sign::zero &&
         orientation(s.a, s.b, s.c, t.b) == Sign::zero &&
         orientation(s.a, s.b, s.c, t.c) == Sign::zero;
}

bool touches_edge(const Triangle& t, const Edge& edge) {
  return triangles_overlap(t, {edge.from, edge.to, edge.from});
}

/// Six times the volume of a triangle and a point, and more than its error.
struct Height {
  double value = 0;
  double error = 0;
};

Height height(const Triangle& t, const Vec3& p) {
  const Vec3 u = t.b - t.a;
  const Vec3 v = t.c - t.a;
  const Vec3 w = p - t.a;
  const auto size = [](const Vec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); };
  // Three differences, two products and two sums, each rounded: below 8 epsilon of the product of
  // these sizes, which exceeds the sum of the moduli of all terms.
  constexpr double kError = 16 * std::numeric_limits<double>::epsilon();
  return {dot(cross(u, v), w), kError * size(u) * size(v) * size(w)};
}

/// True if the point in which an edge goes through `t` is surely not in the plane of `other`.
bool is_off_plane(const Edge& edge, const Triangle& t, const Triangle& other) {
  const PlainArithmetic plain;
  const Height from = height(t, edge.from);
  const Height to = height(t, edge.to);
  const Height other_from = height(other, edge.from);
  const Height other_to = height(other, edge.to);
  // The point divides the edge as from.value to -to.value.
  const double value = from.value * other_to.value - to.value * other_from.value;
  const auto product_error = [](const Height& x, const Height& y) {
    return std::abs(x.value) * y.error + x.error * (std::abs(y.value) + y.error);
  };
  const double error =
      product_error(from, other_to) + product_error(to, other_from) +
      4 * std::numeric_limits<double>::epsilon() *
          (std::abs(from.value * other_to.value) + std::abs(to.value * other_from.value));
  // Where numbers are so small that products lose all of their digits, nothing is known.
  constexpr double kLeast = 1e-280;
  return std::isfinite(value) && std::isfinite(error) && std::abs(value) > 2 * error + kLeast;
}

/// True if `other`, which lies in the plane of a triangle, is on the other side of one of its
/// edges.
bool is_beyond(const Edge& edge, const Triangle& other) {
  const std::array<Vec3, 3> corners{other.a, other.b, other.c};
  for (const Projection projection : {Projection::xy, Projection::yz, Projection::zx}) {
    const Sign inner = orientation2d(edge.from, edge.to, edge.apex, projection);
    if (inner != Sign::zero) {
      return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        return orientation2d(edge.from, edge.to, corner, projection) != inner;
      });
    }
  }
  return false;
}

/// No other triangle may be in the point in which the edge goes through `t`.
bool leaves_free(const Edge& edge, const Triangle& t, const Triangle& other) {
  return !touches_edge(other, edge) || (!in_one_plane(t, other) && is_off_plane(edge, t, other));
}

/// No other triangle may cover the triangle of the edge beside it, in the point in which it goes
/// through `t`.
bool leaves_uncovered(const Edge& edge, const Triangle& s, const Triangle& t,
                      const Triangle& other) {
  return !in_one_plane(s, other) || is_beyond(edge, other) || !touches_edge(other, edge) ||
         !triangles_overlap(other, t);
}

}  // namespace

bool edge_crosses(const Triangle& s, const Triangle& t, const TriangleLoop& beside_s,
                  const TriangleLoop& beside_t) {
  return any_edge_through(s, t, [&](const Edge& edge) {
    return beside_t([&](const Triangle& other) { return leaves_free(edge, t, other); }) &&
           beside_s([&](const Triangle& other) { return leaves_uncovered(edge, s, t, other); });
  });
}

bool surfaces_cross(std::span<const TrianglePair> pairs,
                    std::span<const std::pair<Triangle, Triangle>> triangles) {
  std::map<TriangleId, std::vector<std::size_t>> of_first;
  std::map<TriangleId, std::vector<std::size_t>> of_second;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    of_first[pairs[k].a].push_back(k);
    of_second[pairs[k].b].push_back(k);
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const TriangleLoop firsts = [&](const auto& body) {
      const auto& places = of_second[pairs[k].b];
      return std::all_of(places.begin(), places.end(),
                         [&](std::size_t i) { return i == k || body(triangles[i].first); });
    };
    const TriangleLoop seconds = [&](const auto& body) {
      const auto& places = of_first[pairs[k].a];
      return std::all_of(places.begin(), places.end(),
                         [&](std::size_t i) { return i == k || body(triangles[i].second); });
    };
    if (edge_crosses(triangles[k].first, triangles[k].second, firsts, seconds) ||
        edge_crosses(triangles[k].second, triangles[k].first, seconds, firsts)) {
      return true;
    }
  }
  return false;
}

bool fits_into(const PartBody& inner, const PartBody& outer) {
  const Box box = outer.box();
  return std::any_of(inner.components.begin(), inner.components.end(),
                     [&](const PartComponent& component) { return box.contains(component.box); });
}

bool lead_bodies(const PartBody& a, const PartBody& b) {
  return a.together.body != b.together.body && a.leads() && b.leads();
}

}  // namespace soms::detail
