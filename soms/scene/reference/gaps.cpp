#include "soms/scene/reference/gaps.h"

#include "soms/query/distance.h"

#include <cstddef>

namespace soms::reference {

namespace {

template <typename Gap>
void add(std::vector<Gap>& gaps, std::uint32_t a, const Body& first, std::uint32_t b,
         const Body& second, double clearance) {
  const Distance answer = distance(first, second);
  // The ends of the bracket are the doubles next to the distance, so it is at most another double
  // exactly where its upper end is.
  if (answer.triangles && answer.distance.upper > 0 && answer.distance.upper <= clearance) {
    gaps.push_back({a, b, answer.triangles->a, answer.triangles->b, answer.distance, answer.point_a,
                    answer.point_b});
  }
}

}  // namespace

void for_each_compared_pair(
    const Scene& scene, const ComparedPairs& compared,
    const std::function<void(MoverId mover, EnvironmentId part)>& environment,
    const std::function<void(MoverId a, MoverId b)>& movers) {
  const std::vector<MoverId> ids = scene.movers();
  for (std::size_t k = 0; k < ids.size(); ++k) {
    for (const EnvironmentId part : scene.environments()) {
      if (!compared.environment || compared.environment(ids[k], part)) {
        environment(ids[k], part);
      }
    }
    for (std::size_t l = k + 1; l < ids.size(); ++l) {
      if (!compared.movers || compared.movers(ids[k], ids[l])) {
        movers(ids[k], ids[l]);
      }
    }
  }
}

Gaps gaps(const Scene& scene, double clearance, const ComparedPairs& compared) {
  Gaps found;
  for_each_compared_pair(
      scene, compared,
      [&](MoverId mover, EnvironmentId part) {
        add(found.environment, mover, scene.mover(mover), part, scene.environment(part), clearance);
      },
      [&](MoverId a, MoverId b) {
        add(found.movers, a, scene.mover(a), b, scene.mover(b), clearance);
      });
  return found;
}

}  // namespace soms::reference
