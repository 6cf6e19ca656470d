// The user's own two files.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <string>

namespace soms::bench {

namespace {

Box bounds_of(const Mesh& mesh) {
  Box box;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
  }
  return box;
}

/// The pose for meshes whose middles were taken off: R (x + a) + t - b.
Pose about_middles(Pose pose, const Vec3& a, const Vec3& b) {
  const Vec3 t = pose.apply(a) - b;
  pose.m[3] = t.x;
  pose.m[7] = t.y;
  pose.m[11] = t.z;
  return pose;
}

std::vector<Pose> about(const Box& room, std::size_t count, std::uint64_t seed) {
  std::vector<Pose> poses;
  Rng rng(seed);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = rng.uniform(room.lower.x, room.upper.x);
    const double y = rng.uniform(room.lower.y, room.upper.y);
    poses.push_back(random_rotation(rng, {x, y, rng.uniform(room.lower.z, room.upper.z)}));
  }
  return poses;
}

void doubt_frames(Scene& scene, const Mesh& a, const Mesh& b, bool strict) {
  const char* const remedy = "turn and scale one first: soms convert IN OUT --up AXIS --scale X";
  scene.doubts = compare_frames(frame_of(a), frame_of(b));
  std::string all;
  for (const FrameDoubt doubt : scene.doubts) {
    const std::string place = explain(doubt, frame_of(a), a.source, frame_of(b), b.source);
    scene.warnings.push_back(place + "; " + remedy);
    all += (all.empty() ? "--strict: " : "; ") + place;
  }
  if (strict && !all.empty()) {
    throw Error(ErrorKind::bad_file, all, remedy);
  }
}

}  // namespace

Scene own_files_scene(const std::filesystem::path& a, const std::filesystem::path& b,
                      const std::vector<Pose>& poses, std::size_t random, std::uint64_t seed,
                      bool strict) {
  const Mesh mover = read_mesh(a, {.strict = strict});
  const Mesh fixed = read_mesh(b, {.strict = strict});
  const Box box_a = bounds_of(mover);
  const Box box_b = bounds_of(fixed);
  Scene scene{"own",
              float_mesh(mover, box_a.center()),
              float_mesh(fixed, box_b.center()),
              {{poses.empty() ? "random" : "poses", {}, kEveryPoseJob}}};
  for (const Pose& pose : poses) {
    scene.sets[0].poses.push_back(about_middles(pose, box_a.center(), box_b.center()));
  }
  for (const Mesh* mesh : {&mover, &fixed}) {
    for (const std::string& note : mesh->notes) {
      scene.warnings.push_back(mesh->source + ": " + note);
    }
  }
  doubt_frames(scene, mover, fixed, strict);
  if (poses.empty()) {
    const Vec3 half_a = 0.5 * box_a.extent();
    const Vec3 half_b = 0.5 * box_b.extent();
    const Box room{-(half_a + half_b), half_a + half_b};
    scene.sets[0].poses = about(room, random, seed);
  }
  return scene;
}

}  // namespace soms::bench
