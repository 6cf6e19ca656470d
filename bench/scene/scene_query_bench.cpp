// Points and rays in a scene: 1,000 movers of 1,000 triangles in a city of 100,000. The scene
// against a loop over its bodies, in which each is searched up to what was found before; answers
// are compared. One thread, processor time.
#include "soms/base/random.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/scene/scene.h"

#include "bench/measure.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace soms::bench {
namespace {

constexpr std::uint32_t kMovers = 1000;
constexpr std::size_t kQuestions = 20000;
constexpr std::size_t kLooped = 200;  // questions put to the loop

double seconds_of(const std::function<void()>& work) {
  const double begin = processor_seconds();
  work();
  return processor_seconds() - begin;
}

/// The scene, its bodies in a list, and questions within reach of the streets.
struct Setting {
  Scene scene;
  std::vector<Body> bodies;
  std::vector<Vec3> points;
  std::vector<Ray> rays;

  Setting() {
    Rng rng(1);
    City city = generate_city({.triangles = 100000});
    const Box box = bounds(city.mesh);
    const auto anywhere = [&] {
      return Vec3{rng.uniform(box.lower.x, box.upper.x), rng.uniform(box.lower.y, box.upper.y),
                  rng.uniform(0, 30)};
    };
    bodies.emplace_back(std::move(city.mesh));
    scene.add_environment(bodies.back());
    const Shape mover(generate_knot(1000));
    for (std::uint32_t k = 0; k < kMovers; ++k) {
      const Vec3 at = anywhere();
      bodies.emplace_back(mover, Pose::about_z(rng.uniform(0, 6), at));
      scene.add_mover(bodies.back());
    }
    for (std::size_t k = 0; k < kQuestions; ++k) {
      points.push_back(anywhere());
      rays.push_back({points.back(), {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}});
    }
  }
};

void print_row(const char* name, double scene, double loop, std::size_t different) {
  const double a_second = static_cast<double>(kQuestions) / scene;
  const double of_loop = static_cast<double>(kLooped) / loop;
  std::printf("%-8s %10.0f a second in the scene %8.0f by a loop: ratio %.0f, %zu of %zu differ\n",
              name, a_second, of_loop, a_second / of_loop, different, kLooped);
}

void compare_points(const Setting& setting) {
  SceneClosestBatch batch;
  const double in_scene = seconds_of([&] { batch = setting.scene.closest(setting.points); });
  std::size_t different = 0;
  const double in_loop = seconds_of([&] {
    for (std::size_t i = 0; i < kLooped; ++i) {
      ClosestOptions options;
      for (const Body& body : setting.bodies) {
        const Closest here = closest(body, setting.points[i], options);
        options.at_most = std::min(options.at_most, here.distance.upper);
      }
      if (options.at_most != batch.upper[i]) {
        ++different;
      }
    }
  });
  print_row("points", in_scene, in_loop, different);
}

void compare_rays(const Setting& setting) {
  SceneHitBatch batch;
  const double in_scene = seconds_of([&] { batch = setting.scene.closest_hit(setting.rays); });
  std::size_t different = 0;
  const double in_loop = seconds_of([&] {
    for (std::size_t i = 0; i < kLooped; ++i) {
      Ray ray = setting.rays[i];
      for (const Body& body : setting.bodies) {
        ray.length = std::min(ray.length, closest_hit(body, ray).t.upper);
      }
      if (ray.length != batch.upper[i]) {
        ++different;
      }
    }
  });
  print_row("rays", in_scene, in_loop, different);
}

}  // namespace
}  // namespace soms::bench

int main() {
  using namespace soms;
  bench::Setting setting;
  std::printf("index of %u movers: %.3f ms\n", bench::kMovers,
              1e3 * bench::seconds_of([&] {
                const SceneFilter movers{.environment = false};
                static_cast<void>(setting.scene.closest(Vec3{}, {.at_most = 0}, movers));
              }));
  static_cast<void>(setting.scene.closest(Vec3{}));  // builds the index of the environment
  bench::compare_points(setting);
  bench::compare_rays(setting);
}
