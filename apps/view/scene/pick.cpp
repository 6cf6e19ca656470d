// Picking: which triangle a ray meets first, by the same exact question that finds contacts.
#include "soms/query/overlap.h"

#include "apps/view/scene/view_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::view {

namespace {

/// Most contacts of a picked triangle that its text lists.
constexpr std::size_t kListed = 5;

/// The part of a ray that holds all it can meet, as a body of one triangle without area.
Body segment_of(const Ray& ray, double length) {
  Mesh mesh;
  mesh.vertices = {ray.origin, ray.origin + ray.direction * length};
  mesh.triangles = {{0, 1, 1}};
  return Body(std::move(mesh));
}

/// Farthest distance of a point of `box` from `p`, with room for rounding.
double reach(const Vec3& p, const Box& box) {
  double most = 0;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Vec3 c{(corner & 1U) != 0 ? box.upper.x : box.lower.x,
                 (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                 (corner & 4U) != 0 ? box.upper.z : box.lower.z};
    most = std::max(most, std::hypot(c.x - p.x, c.y - p.y, c.z - p.z));
  }
  return 1.0001 * most;
}

/// Nearest common point of the ray's segment and a triangle that it meets.
double distance_along(const Ray& ray, const Triangle& segment, const Triangle& t, Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  const Crossing common = crossing(segment, t);  // outlives the loop over its points
  for (const Vec3& p : common.points()) {
    const double d = dot(p - ray.origin, ray.direction);
    if (d < least) {
      least = d;
      point = p;
    }
  }
  return least;
}

/// Tangent of the angle at which a ray's origin sees a point beside the ray; infinity behind it.
double slope(const Ray& ray, const Vec3& p) {
  const Vec3 d = p - ray.origin;
  const double ahead = dot(d, ray.direction);
  const Vec3 beside = d - ray.direction * ahead;
  return ahead > 0 ? std::hypot(beside.x, beside.y, beside.z) / ahead
                   : std::numeric_limits<double>::infinity();
}

/// The least slope of the points of a segment: where a ray passes it, or at an end.
double slope(const Ray& ray, const Vec3& a, const Vec3& b) {
  const auto flat = [&](const Vec3& v) { return v - ray.direction * dot(v, ray.direction); };
  const Vec3 from = flat(a - ray.origin);
  const Vec3 along = flat(b - a);
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(-dot(from, along) / square, 0.0, 1.0) : 0;
  return std::min({slope(ray, a), slope(ray, b), slope(ray, a + (b - a) * share)});
}

std::string name_of(const ViewScene& scene, BodyRef ref) {
  const std::string& name = scene.body(ref).name;
  return ref.role == Role::city ? name : fmt::format("{} (mover {})", name, ref.index);
}

std::string describe(const ViewScene& scene, const Picked& p) {
  std::string text =
      fmt::format("{}, triangle {} (face {})", name_of(scene, p.body), p.triangle, p.face);
  if (!p.part_name.empty()) {
    text += ", part " + p.part_name;
  }
  text += fmt::format("\nvertices {}, {}, {}", p.vertices[0], p.vertices[1], p.vertices[2]);
  for (const Vec3& c : {p.corners.a, p.corners.b, p.corners.c}) {
    text += fmt::format("\n  ({:.9g}, {:.9g}, {:.9g})", c.x, c.y, c.z);
  }
  text += fmt::format("\nseen at ({:.9g}, {:.9g}, {:.9g}), {:.4g} away", p.point.x, p.point.y,
                      p.point.z, p.distance);
  if (p.touches.empty()) {
    return text + "\ntouches nothing";
  }
  text +=
      fmt::format("\ntouches {} triangle{}", p.touches.size(), p.touches.size() == 1 ? "" : "s");
  for (std::size_t k = 0; k < std::min(kListed, p.touches.size()); ++k) {
    const Touch& touch = p.touches[k];
    const bool first = touch.a == p.body && touch.i == p.triangle;
    text += fmt::format("\n{}, triangle {}: {}", name_of(scene, first ? touch.b : touch.a),
                        first ? touch.j : touch.i, scene.explain(touch).text);
  }
  return text;
}

}  // namespace

std::optional<Picked> ViewScene::pick(const Ray& ray, bool with_movers) const {
  Box all = bounds();
  const std::uint32_t moving = with_movers ? movers() : 0;
  for (std::uint32_t k = 0; k < moving; ++k) {
    all.grow(bounds(mover(k)));
  }
  if (all.empty()) {
    return std::nullopt;
  }
  const Body segment = segment_of(ray, reach(ray.origin, all));
  const Triangle line = segment.shape.mesh().triangle(0);
  std::optional<Picked> best;
  const auto look_at = [&](BodyRef ref) {
    const Overlap hits = overlap(segment, body(ref));
    for (const TrianglePair& hit : hits.pairs) {
      Vec3 point;
      const double distance = distance_along(ray, line, triangle(ref, hit.second), point);
      if (!best || distance < best->distance) {
        best.emplace();
        best->body = ref;
        best->triangle = hit.second;
        best->point = point;
        best->distance = distance;
      }
    }
  };
  for (std::uint32_t k = 0; k < city_parts(); ++k) {
    look_at(city_part(k));
  }
  for (std::uint32_t k = 0; k < moving; ++k) {
    look_at(mover(k));
  }
  if (!best) {
    return std::nullopt;
  }
  const Mesh& mesh = body(best->body).shape.mesh();
  best->face = mesh.faces.empty() ? best->triangle : mesh.faces[best->triangle];
  best->part = part_of(mesh, best->triangle);
  best->part_name = best->part == Part::kNoParent ? std::string() : mesh.parts[best->part].name;
  best->vertices = mesh.triangles[best->triangle];
  best->corners = triangle(best->body, best->triangle);
  for (const Touch& touch : contacts()) {
    if ((touch.a == best->body && touch.i == best->triangle) ||
        (touch.b == best->body && touch.j == best->triangle)) {
      best->touches.push_back(touch);
    }
  }
  best->explanation = describe(*this, *best);
  return best;
}

std::optional<Touch> ViewScene::pick_contact(const Ray& ray, double angle) const {
  double least = std::tan(angle);
  std::optional<Touch> best;
  for (const Touch& touch : contacts()) {
    const Crossing common = crossing(touch);
    const auto p = common.points();
    for (std::size_t k = 0; k < p.size(); ++k) {
      const double seen = slope(ray, p[k], p[(k + 1) % p.size()]);
      if (seen < least) {
        least = seen;
        best = touch;
      }
    }
  }
  return best;
}

}  // namespace soms::view
