#include "thesis/trips/stand_ins.h"

#include "soms/generate/statue.h"
#include "soms/generate/teapot.h"

namespace soms::reproduce {

namespace {

/// A statue with y up that stands on the height `ground`.
Mesh standing(std::uint64_t triangles, double ground, double height) {
  Mesh mesh = generate_statue(triangles);
  for (Vec3& v : mesh.vertices) {
    v = {height * v.x, ground + height * v.z, -height * v.y};
  }
  mesh.up = UpAxis::y;
  return mesh;
}

}  // namespace

Mesh stand_in_bunny() {
  return standing(948, 0.0336, 0.1483);
}

Mesh stand_in_venus() {
  return standing(1416, -4.54, 10.5);
}

Mesh stand_in_small_teapot() {
  return generate_teapot(6);
}

Mesh stand_in_teapot() {
  Mesh mesh = generate_teapot(10);
  for (Vec3& v : mesh.vertices) {
    v = {-v.y, v.z, -v.x};
  }
  mesh.up = UpAxis::y;
  return mesh;
}

}  // namespace soms::reproduce
