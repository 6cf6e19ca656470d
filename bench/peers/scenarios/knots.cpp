#include "soms/base/error.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

namespace soms::bench {

namespace {

FloatMesh knot_of(std::uint64_t triangles) {
  switch (triangles) {
    case 1'000:
      return torus_knot(50, 10);
    case 10'000:
      return torus_knot(250, 20);
    case 100'000:
      return torus_knot(625, 80);
    default:
      throw Error(ErrorKind::usage, "knot of " + std::to_string(triangles) + " triangles",
                  "the referee's sizes are 1000, 10000 and 100000");
  }
}

Pose shifted(Pose pose, const Vec3& t) {
  pose.m[3] = t.x;
  pose.m[7] = t.y;
  pose.m[11] = t.z;
  return pose;
}

/// Slides the knot in along `direction` until it touches, then out again by 0.001.
Pose near_miss(Body& knot, const Body& twin, const Pose& turned, const Vec3& direction) {
  const auto touches = [&](double s) {
    knot.pose = shifted(turned, s * direction);
    return overlap(knot, twin, {.mode = OverlapMode::any}).any;
  };
  double apart = 2.5;
  double touching = apart;
  while (touching > -2.5 && !touches(touching)) {
    apart = touching;
    touching -= 0.05;
  }
  while (apart - touching > 1e-5) {
    const double middle = 0.5 * (apart + touching);
    (touches(middle) ? touching : apart) = middle;
  }
  return shifted(turned, (apart + 0.001) * direction);
}

}  // namespace

Scene knot_scene(std::uint64_t triangles) {
  Scene scene{"knot", knot_of(triangles), knot_of(triangles), {{"random", {}}, {"near", {}}}};
  Rng rng(11);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Pose turned = random_rotation(rng, {});
    scene.sets[0].poses.push_back(shifted(turned, rng.uniform(1.0, 1.9) * random_direction(rng)));
  }
  Mesh mesh;
  for (const auto& v : scene.fixed.vertices) {
    mesh.vertices.push_back(wide(v));
  }
  mesh.triangles = scene.fixed.triangles;
  const Body twin(std::move(mesh));
  Body knot = twin;
  Rng near(13);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Pose turned = random_rotation(near, {});
    scene.sets[1].poses.push_back(near_miss(knot, twin, turned, random_direction(near)));
  }
  return scene;
}

}  // namespace soms::bench
