#include "soms/scene/reference/gaps.h"

#include "soms/query/distance.h"

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

Gaps gaps(const Scene& scene, double clearance, const ComparedPairs& compared) {
  Gaps found;
  const std::vector<MoverId> movers = scene.movers();
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const MoverId mover = movers[k];
    for (const EnvironmentId part : scene.environments()) {
      if (!compared.environment || compared.environment(mover, part)) {
        add(found.environment, mover, scene.mover(mover), part, scene.environment(part), clearance);
      }
    }
    for (std::size_t l = k + 1; l < movers.size(); ++l) {
      const MoverId other = movers[l];
      if (!compared.movers || compared.movers(mover, other)) {
        add(found.movers, mover, scene.mover(mover), other, scene.mover(other), clearance);
      }
    }
  }
  return found;
}

}  // namespace soms::reference
