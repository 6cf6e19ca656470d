#include "bench/peers/core/probe_judge.h"

#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::bench {

namespace {

double norm(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// True if a ray comes within `slack` of a box.
bool may_meet(const ProbeRay& ray, const Box& box, double slack) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const double lower = box.lower[k] - slack - ray.origin[k];
    const double upper = box.upper[k] + slack - ray.origin[k];
    const double d = ray.direction[k];
    if (d == 0) {
      if (lower > 0 || upper < 0) {
        return false;
      }
    } else {
      enter = std::max(enter, std::min(lower / d, upper / d));
      leave = std::min(leave, std::max(lower / d, upper / d));
    }
  }
  return enter <= leave;
}

/// Adds what a ray does to a triangle. Moving its corners by `slack` turns no sure answer: the side
/// of an edge is linear in the edge and in the way to it across the ray.
void look_at(const Triangle& t, const ProbeRay& ray, double slack, Crossings& found) {
  const Vec3& d = ray.direction;
  const double speed = norm(d);
  const std::array<Vec3, 3> corner{t.a - ray.origin, t.b - ray.origin, t.c - ray.origin};
  bool left = false;  // surely, of an edge at least
  bool right = false;
  bool sure = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = corner[(k + 1) % 3] - corner[k];
    const double side = dot(d, cross(edge, corner[k]));
    const double across = norm(cross(d, corner[k])) / speed;
    const double doubt = 2 * slack * speed * (norm(edge) + across + slack);
    left = left || side < -doubt;
    right = right || side > doubt;
    sure = sure && std::abs(side) > doubt;
  }
  if (left && right) {
    return;
  }
  const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double along = dot(d, normal);
  const double t_hit = dot(corner[0], normal) / along;
  const double t_doubt = 4 * slack * norm(normal) / std::abs(along);
  if (sure && t_hit > t_doubt) {
    ++found.sure;
    found.least = std::min(found.least, t_hit - t_doubt);
    found.most = std::min(found.most, t_hit + t_doubt);
    return;
  }
  const double far = std::max({dot(corner[0], d), dot(corner[1], d), dot(corner[2], d)});
  const double near = std::min({dot(corner[0], d), dot(corner[1], d), dot(corner[2], d)});
  if ((sure && t_hit < -t_doubt) || far / speed < -slack) {
    return;
  }
  ++found.open;
  found.least = std::min(found.least, std::max(0.0, (near / speed - slack) / speed));
}

}  // namespace

RayJudge::RayJudge(const FloatMesh& body)
    : body_(bunches_of(body)), reach_(reach(bounds_of(body_))) {
}

double RayJudge::slack(const ProbeRay& ray, Precision precision) const {
  const double largest =
      std::max({reach_, std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
  return largest * (precision == Precision::floats ? kSlackOfFloats : kSlackOfDoubles);
}

Crossings RayJudge::crossings(const ProbeRay& ray, Precision precision) const {
  Crossings found;
  const double doubt = slack(ray, precision);
  for (const Bunch& bunch : body_.list) {
    if (may_meet(ray, bunch.box, 2 * doubt)) {
      for (const Triangle& t : body_.of(bunch)) {
        look_at(t, ray, doubt, found);
      }
    }
  }
  return found;
}

SideJudge::SideJudge(const FloatMesh& body) : rays_(body), distances_(point_mesh(), body) {
}

double SideJudge::side(const Vec3& point) const {
  constexpr int kTries = 8;
  Rng rng(41);
  for (int i = 0; i < kTries; ++i) {
    const Crossings found = rays_.crossings({point, random_direction(rng)}, Precision::doubles);
    if (found.open == 0) {
      return found.sure % 2 == 0 ? 0 : 1;
    }
  }
  return distances_.distance(Pose::translation(point.x, point.y, point.z)) == 0 ? kOnSurface
                                                                                : kOpen;
}

FloatMesh point_mesh() {
  return {{{0, 0, 0}}, {{0, 0, 0}}};
}

}  // namespace soms::bench
