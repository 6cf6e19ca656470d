// Models that are nothing like each other, of any origin and size.
#include "soms/io/read_mesh.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/grazing.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <optional>

namespace soms::bench {

namespace {

Box bounds_of_model(const Mesh& mesh) {
  Box box;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    box.grow(bounds(mesh.triangle(i)));
  }
  return box;
}

/// One body before another; says whether they touch.
class Pair {
 public:
  Pair(const FloatMesh& mover, const FloatMesh& fixed)
      : mover_(widened(mover)), fixed_(widened(fixed)) {}

  /// Moves from `start` along a line until they touch and `into` farther; nothing where they touch
  /// from the start or not within reach.
  std::optional<Pose> graze(const Pose& start, const Vec3& direction, double into,
                            const Search& search) {
    const auto touches = [&](double way) {
      mover_.pose = onward(start, direction, way);
      return overlap(mover_, fixed_, {.mode = OverlapMode::any}).any;
    };
    const std::optional<double> way = free_way(touches, search);
    return way ? std::optional(onward(start, direction, *way + into)) : std::nullopt;
  }

 private:
  Body mover_;
  Body fixed_;
};

/// Uniform in a box.
Vec3 anywhere_in(const Box& room, Rng& rng) {
  const double x = rng.uniform(room.lower.x, room.upper.x);
  const double y = rng.uniform(room.lower.y, room.upper.y);
  return {x, y, rng.uniform(room.lower.z, room.upper.z)};
}

}  // namespace

Scene unlike_models_scene(const std::string& name, const std::filesystem::path& mover,
                          const std::filesystem::path& fixed, std::uint64_t seed) {
  Scene scene{name,
              unit_model(mover),
              unit_model(fixed),
              {{"random", {}, kAnyAndAll}, {"grazing", {}, kAnyAndAll}}};
  Rng rng = rng_of(71, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Vec3 place = rng.uniform(0, 2) * random_direction(rng);
    scene.sets[0].poses.push_back(random_rotation(rng, place));
  }
  Pair pair(scene.mover, scene.fixed);
  Rng slides = rng_of(72, seed);
  const Search search{.step = 0.02, .reach = 5, .within = 1e-6};
  while (scene.sets[1].poses.size() < kPoses) {
    const Vec3 from = 2.5 * random_direction(slides);
    const Vec3 to = slides.uniform(0, 0.5) * random_direction(slides);
    const Pose start = random_rotation(slides, from);
    const double into = slides.uniform(0.0001, 0.005);
    if (const auto pose = pair.graze(start, unit(to - from), into, search)) {
      scene.sets[1].poses.push_back(*pose);
    }
  }
  return scene;
}

Scene unlike_hall_scene(const std::string& name, const std::filesystem::path& mover,
                        const std::filesystem::path& fixed, double scale, std::uint64_t seed) {
  const Mesh furniture = read_mesh(mover);
  const Mesh hall = read_mesh(fixed);
  const Box room = bounds_of_model(hall);
  const Box piece = bounds_of_model(furniture);
  Scene scene{name,
              float_mesh(furniture, piece.center(), scale),
              float_mesh(hall, room.center(), scale),
              {{"random", {}, kAnyAndAll}, {"grazing", {}, kAnyAndAll}}};
  const Vec3 half = 0.5 * scale * room.extent();
  Rng rng = rng_of(73, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    const Vec3 place = anywhere_in({-half, half}, rng);
    scene.sets[0].poses.push_back(Pose::about_z(rng.uniform(0, 2 * kPi), place));
  }
  Pair pair(scene.mover, scene.fixed);
  Rng pushes = rng_of(74, seed);
  const Search search{.step = 0.05, .reach = 20};
  while (scene.sets[1].poses.size() < kPoses) {
    const Vec3 place = anywhere_in({-half, half}, pushes);
    const Pose start = Pose::about_z(pushes.uniform(0, 2 * kPi), place);
    const double a = pushes.uniform(0, 2 * kPi);
    const double into = pushes.uniform(0.001, 0.05);
    if (const auto pose = pair.graze(start, {std::cos(a), std::sin(a), 0}, into, search)) {
      scene.sets[1].poses.push_back(*pose);
    }
  }
  return scene;
}

}  // namespace soms::bench
