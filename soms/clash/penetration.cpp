#include "soms/clash/penetration.h"

#include "soms/base/arithmetic.h"
#include "soms/base/box.h"
#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace soms {

namespace {

/// Beside the extent of a part: what counts as in one plane, and as parallel.
constexpr double kFlat = 0x1p-20;

double longest_side(const Box& box) {
  const Vec3 e = box.extent();
  return std::max({e.x, e.y, e.z});
}

/// Of length one; nothing for a vector that is too short to have a direction.
std::optional<Vec3> direction_of(const Vec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) {
    return std::nullopt;
  }
  const Vec3 scaled{v.x / largest, v.y / largest, v.z / largest};
  return scaled * (1 / std::sqrt(dot(scaled, scaled)));
}

/// Keeps a direction unless one that is nearly parallel is there.
void add_axis(const Vec3& axis, std::vector<Vec3>& axes) {
  const bool known = std::any_of(axes.begin(), axes.end(), [&](const Vec3& other) {
    const Vec3 turn = cross(axis, other);
    return dot(turn, turn) < kFlat * kFlat;
  });
  if (!known) {
    axes.push_back(axis);
  }
}

/// Height of a point over the plane through `t` with the normal `n`.
double height(const Vec3& point, const Triangle& t, const Vec3& n) {
  return dot(n, point - t.a);
}

/// A triangle with area, and the direction across it.
struct Face {
  Triangle triangle;
  Vec3 normal;
};

/// The faces of a part where its pose has moved it, in units of its extent about its middle: so
/// nothing is too small or too large to be multiplied.
std::vector<Face> faces_of(const Body& body, const Vec3& middle, double extent) {
  const auto within = [&](const Vec3& v) {
    const Vec3 d = v - middle;
    return Vec3{d.x / extent, d.y / extent, d.z / extent};
  };
  std::vector<Face> faces;
  for (std::size_t i = 0; i < body.shape.mesh().triangles.size(); ++i) {
    const Triangle moved = detail::moved_triangle(body, static_cast<TriangleId>(i));
    const Triangle t{within(moved.a), within(moved.b), within(moved.c)};
    if (const std::optional<Vec3> n = direction_of(cross(t.b - t.a, t.c - t.a))) {
      faces.push_back({t, *n});
    }
  }
  return faces;
}

/// Where vertices are, each place once.
std::vector<Vec3> corners_of(const Body& body) {
  std::vector<Vec3> corners;
  for (const Vec3& vertex : body.shape.mesh().vertices) {
    corners.push_back(body.pose.apply(vertex));
  }
  std::sort(corners.begin(), corners.end(), [](const Vec3& v, const Vec3& w) {
    return std::tie(v.x, v.y, v.z) < std::tie(w.x, w.y, w.z);
  });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool is_convex(const std::vector<Face>& faces, const std::vector<Vec3>& corners) {
  return std::all_of(faces.begin(), faces.end(), [&](const Face& face) {
    double least = 0;
    double most = 0;
    for (const Vec3& corner : corners) {
      const double h = height(corner, face.triangle, face.normal);
      least = std::min(least, h);
      most = std::max(most, h);
      if (least < -kFlat && most > kFlat) {
        return false;
      }
    }
    return true;
  });
}

using EdgeEnds = std::array<double, 6>;

EdgeEnds ends_of(const Vec3& p, const Vec3& q) {
  const std::array from{p.x, p.y, p.z};
  const std::array to{q.x, q.y, q.z};
  const auto& [lesser, greater] = std::minmax(from, to);
  return {lesser[0], lesser[1], lesser[2], greater[0], greater[1], greater[2]};
}

/// Directions of the edges at which faces of different planes meet.
std::vector<Vec3> edge_axes(const std::vector<Face>& faces) {
  std::map<EdgeEnds, std::vector<std::uint32_t>> at_edge;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Triangle& t = faces[i].triangle;
    for (const auto& [p, q] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
      at_edge[ends_of(p, q)].push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<Vec3> axes;
  for (const auto& [ends, at] : at_edge) {
    const Vec3 first = faces[at.front()].normal;
    const bool flat = at.size() > 1 && std::all_of(at.begin(), at.end(), [&](std::uint32_t i) {
                        const Vec3 turn = cross(first, faces[i].normal);
                        return dot(turn, turn) < kFlat * kFlat;
                      });
    const Vec3 along{ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2]};
    if (const std::optional<Vec3> axis = direction_of(along); axis && !flat) {
      add_axis(*axis, axes);
    }
  }
  return axes;
}

/// The least and the greatest place of corners along an axis.
std::pair<double, double> places_along(const Vec3& axis, const std::vector<Vec3>& corners,
                                       const Vec3& origin) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec3& corner : corners) {
    const double place = dot(axis, corner - origin);
    least = std::min(least, place);
    most = std::max(most, place);
  }
  return {least, most};
}

/// Looks at one axis after the other for the shortest way out.
class WayOut {
 public:
  WayOut(const std::vector<Vec3>& a, const std::vector<Vec3>& b) : a_(a), b_(b) {
    Box box;
    for (const std::vector<Vec3>* const corners : {&a, &b}) {
      for (const Vec3& corner : *corners) {
        box.grow(corner);
      }
    }
    origin_ = box.center();
    // Three products, two sums, the difference to the origin, and the length of the axis.
    rounding_ = 0x1p-48 * longest_side(box);
  }

  void look(const Vec3& axis) {
    const auto [least_a, most_a] = places_along(axis, a_, origin_);
    const auto [least_b, most_b] = places_along(axis, b_, origin_);
    take(most_a - least_b, axis);
    take(most_b - least_a, -axis);
  }

  [[nodiscard]] Penetration found() const { return found_; }

 private:
  void take(double overlap, const Vec3& direction) {
    // What rounding may have hidden counts, too: parts that cross by less are not 0 deep.
    const double depth = std::max(0.0, overlap + rounding_);
    if (depth < found_.depth) {
      found_ = {depth, direction};
    }
  }

  const std::vector<Vec3>& a_;
  const std::vector<Vec3>& b_;
  Vec3 origin_;
  double rounding_ = 0;
  Penetration found_{std::numeric_limits<double>::infinity(), {}};
};

}  // namespace

std::optional<ConvexPart> ConvexPart::of(const PartBody& part) {
  const PlainArithmetic plain;
  if (!part.closed) {
    return std::nullopt;
  }
  const Box box = part.box();
  const double extent = longest_side(box);
  if (!(extent > 0) || !std::isfinite(extent)) {
    return std::nullopt;
  }
  const Body& body = part.body;
  const std::vector<Face> faces = faces_of(body, box.center(), extent);
  ConvexPart convex;
  std::vector<Vec3> scaled;
  for (const Vec3& corner : corners_of(body)) {
    convex.corners_.push_back(corner);
    const Vec3 d = corner - box.center();
    scaled.push_back({d.x / extent, d.y / extent, d.z / extent});
  }
  if (faces.empty() || !is_convex(faces, scaled)) {
    return std::nullopt;
  }
  for (const Face& face : faces) {
    add_axis(face.normal, convex.normals_);
  }
  convex.edges_ = edge_axes(faces);
  return convex;
}

std::optional<Penetration> penetration(const ConvexPart& a, const ConvexPart& b) {
  const PlainArithmetic plain;
  const auto size = [](const auto& list) { return static_cast<double>(list.size()); };
  const double axes = size(a.normals()) + size(b.normals()) + size(a.edges()) * size(b.edges());
  if (axes * (size(a.corners()) + size(b.corners())) > kMostPenetrationWork) {
    return std::nullopt;
  }
  WayOut way(a.corners(), b.corners());
  for (const ConvexPart* const part : {&a, &b}) {
    for (const Vec3& normal : part->normals()) {
      way.look(normal);
    }
  }
  for (const Vec3& of_a : a.edges()) {
    for (const Vec3& of_b : b.edges()) {
      if (const std::optional<Vec3> axis = direction_of(cross(of_a, of_b))) {
        way.look(*axis);
      }
    }
  }
  return way.found();
}

}  // namespace soms
