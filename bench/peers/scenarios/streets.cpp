#include "soms/generate/routes.h"
#include "soms/generate/shapes.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

namespace soms::bench {

namespace {

FloatMesh narrowed(const Mesh& mesh) {
  FloatMesh narrow_mesh;
  for (const Vec3& v : mesh.vertices) {
    narrow_mesh.vertices.push_back(narrow(v));
  }
  narrow_mesh.triangles = mesh.triangles;
  return narrow_mesh;
}

}  // namespace

Scene street_scene(std::uint64_t triangles, std::uint64_t seed) {
  const City city = generate_city({.triangles = triangles});
  Scene scene{"streets",
              narrowed(generate_mover(MoverKind::car)),
              narrowed(city.mesh),
              {{"routes", {}, kNear}}};
  for (std::uint64_t car = 0; car < 50; ++car) {
    const Route route = street_route(city, 50 * (seed - 1) + car, 12, 0.12);
    for (int i = 0; i < 20; ++i) {
      scene.sets[0].poses.push_back(route.at(0.5 * i));
    }
  }
  return scene;
}

}  // namespace soms::bench
