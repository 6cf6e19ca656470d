// What rays hit first in a scene.
#include "apps/view/scene/view_scene.h"

namespace soms::view {

std::vector<SurfaceHit> ViewScene::first_hits(std::span<const Ray> rays, bool with_movers,
                                              const Parallel& parallel) const {
  std::vector<SurfaceHit> hits(rays.size());
  const auto look_at = [&](BodyRef ref) {
    const ClosestHitBatch found = closest_hit(body(ref), rays, {}, parallel);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      if (found.triangle[k] && found.lower[k] < hits[k].t) {
        hits[k] = {ref, *found.triangle[k], found.point[k], found.lower[k]};
      }
    }
  };
  for (std::uint32_t k = 0; k < city_parts(); ++k) {
    look_at(city_part(k));
  }
  for (std::uint32_t k = 0; with_movers && k < movers(); ++k) {
    look_at(mover(k));
  }
  return hits;
}

}  // namespace soms::view
