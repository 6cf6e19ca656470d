// Queries of rays and segments against one body.
#include "soms/query/ray.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <vector>

using soms::Body;
using soms::Pose;
using soms::Ray;
using soms::RayOptions;
using soms::Vec3;
using soms::web::Answer;
using soms::web::answer_of_batch;
using soms::web::answer_of_lists;
using soms::web::guarded;
using soms::web::HeldShape;
using soms::web::within_time;

namespace {

/// Rays as they come: of 7 numbers each (origin, direction, length), or segments of 6.
std::vector<Ray> rays_of(const double* numbers, std::uint32_t count, bool segments) {
  std::vector<Ray> rays(count);
  for (Ray& ray : rays) {
    const Vec3 origin{numbers[0], numbers[1], numbers[2]};
    const Vec3 other{numbers[3], numbers[4], numbers[5]};
    ray = segments ? Ray::between(origin, other) : Ray{origin, other, numbers[6]};
    numbers += segments ? 6 : 7;
  }
  return rays;
}

/// `skip` is -1 for none.
RayOptions ray_options(std::int32_t skip) {
  RayOptions options;
  if (skip >= 0) {
    options.skip = static_cast<soms::TriangleId>(skip);
  }
  return options;
}

}  // namespace

SOMS_EXPORT(soms_closest_hit)

Answer* soms_closest_hit(const HeldShape* shape, const Pose* pose, const double* numbers,
                         std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                         double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip);
    return answer_of_batch<soms::ClosestHit>(closest_hit(
        body, rays_of(numbers, count, segments != 0), options, within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_any_hit)

Answer* soms_any_hit(const HeldShape* shape, const Pose* pose, const double* numbers,
                     std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                     double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip);
    return answer_of_batch<soms::AnyHit>(
        any_hit(body, rays_of(numbers, count, segments != 0), options, within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_all_hits)

Answer* soms_all_hits(const HeldShape* shape, const Pose* pose, const double* numbers,
                      std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                      double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip);
    return answer_of_lists(
        all_hits(body, rays_of(numbers, count, segments != 0), options, within_time(milliseconds)));
  });
}
