#include "tests/scene/scenes.h"

#include "soms/query/reference/overlap.h"

#include "tests/scene/random_bodies.h"

#include <vector>

namespace soms::test {

bool Exclusions::excludes(MoverId a, MoverId b) const {
  const auto group = [this](MoverId id) {
    const auto at = groups.find(id);
    return at == groups.end() ? 0U : at->second;
  };
  return (group(a) != 0 && group(a) == group(b)) || movers.count({a, b}) != 0;
}

StepReport scan(const Scene& scene, const Exclusions& exclusions) {
  StepReport report;
  const std::vector<MoverId> movers = scene.movers();
  const auto pairs = [](const Body& first, const Body& second) {
    return reference::overlap(first.shape.mesh(), first.pose, second.shape.mesh(), second.pose)
        .pairs;
  };
  for (std::size_t a = 0; a < movers.size(); ++a) {
    const Body& first = scene.mover(movers[a]);
    for (const EnvironmentId part : scene.environments()) {
      if (exclusions.parts.count({movers[a], part}) == 0) {
        for (const auto& [i, j] : pairs(first, scene.environment(part))) {
          report.environment.push_back({movers[a], part, i, j});
        }
      }
    }
    for (std::size_t b = a + 1; b < movers.size(); ++b) {
      if (!exclusions.excludes(movers[a], movers[b])) {
        for (const auto& [i, j] : pairs(first, scene.mover(movers[b]))) {
          report.movers.push_back({movers[a], movers[b], i, j});
        }
      }
    }
  }
  return report;
}

Scene random_scene(Rng& rng, double reach, std::uint64_t movers, std::uint64_t parts) {
  Scene scene;
  std::vector<Shape> shapes;
  for (int k = 0; k < 4; ++k) {
    shapes.emplace_back(random_mesh(rng));
  }
  shapes.emplace_back();  // an empty one
  for (std::uint64_t k = 0; k < parts; ++k) {
    scene.add_environment(Body(shapes[rng.below(shapes.size())], random_pose(rng, reach)));
  }
  for (std::uint64_t k = 0; k < movers; ++k) {
    scene.add_mover(Body(shapes[rng.below(shapes.size())], random_pose(rng, reach)));
  }
  return scene;
}

}  // namespace soms::test
