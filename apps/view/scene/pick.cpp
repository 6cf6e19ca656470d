// Picking: which triangle a ray hits first, and which contact it passes nearest to.
#include "apps/view/scene/view_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::view {

namespace {

/// Most contacts of a picked triangle that its text lists.
constexpr std::size_t kListed = 5;

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

/// Where an id stands among all, which ascend.
std::uint32_t place_of(std::uint32_t id, const std::vector<std::uint32_t>& all) {
  return static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), id) - all.begin());
}

std::string describe(const ViewScene& scene, const Picked& p) {
  std::string text = fmt::format("{}, triangle {} (face {})", name_of(scene, p.body),
                                 scene.numbers().triangle(p.body, p.triangle), p.face);
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
    const BodyRef other = first ? touch.b : touch.a;
    text += fmt::format("\n{}, triangle {}: {}", name_of(scene, other),
                        scene.numbers().triangle(other, first ? touch.j : touch.i),
                        scene.explain(touch).text);
  }
  return text;
}

}  // namespace

std::vector<SurfaceHit> ViewScene::first_hits(std::span<const Ray> rays, bool with_movers,
                                              const Limits& limits) const {
  const SceneHitBatch found = scene().closest_hit(rays, {}, {.movers = with_movers}, limits);
  const std::vector<EnvironmentId> parts = scene().environments();
  const std::vector<MoverId> moving = scene().movers();
  const auto ref_of = [&](const SceneBody& body) {
    return body.kind == SceneBodyKind::environment ? city_part(place_of(body.id, parts))
                                                   : mover(place_of(body.id, moving));
  };
  std::vector<SurfaceHit> hits(rays.size());
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (found.body[k]) {
      hits[k] = {ref_of(*found.body[k]), *found.triangle[k], found.point[k], found.lower[k]};
    }
  }
  return hits;
}

Picked ViewScene::picked(BodyRef at, TriangleId i) const {
  Picked it;
  it.body = at;
  it.triangle = i;
  const MeshView& mesh = body(at).shape.mesh();
  it.face = mesh.faces.empty() ? i : mesh.faces[i];
  it.part = part_of(mesh, i);
  it.part_name = it.part == Part::kNoParent ? std::string() : mesh.parts[it.part].name;
  it.vertices = mesh.triangles[i];
  for (std::uint32_t& vertex : it.vertices) {
    vertex = numbers().vertex(at, vertex);
  }
  it.corners = triangle(at, i);
  it.point = soms::bounds(it.corners).center();
  for (const Touch& touch : contacts()) {
    if ((touch.a == at && touch.i == i) || (touch.b == at && touch.j == i)) {
      it.touches.push_back(touch);
    }
  }
  return it;
}

std::optional<Picked> ViewScene::pick(const Ray& ray, bool with_movers) const {
  const SurfaceHit hit = first_hits({&ray, 1}, with_movers).front();
  if (!hit.body) {
    return std::nullopt;
  }
  std::optional<Picked> best(picked(*hit.body, hit.triangle));
  best->point = hit.point;
  best->distance = hit.t;
  best->explanation = describe(*this, *best);
  return best;
}

std::optional<Touch> ViewScene::pick_contact(const Ray& ray, double angle) const {
  double least = std::tan(angle);
  std::optional<Touch> best;
  for (const Touch& touch : contacts()) {
    const CommonPoints common = common_points(touch);
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
