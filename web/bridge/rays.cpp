// Queries of rays and segments against one body.
#include "soms/query/ray.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <span>
#include <utility>

using soms::Body;
using soms::Pose;
using soms::Ray;
using soms::RayOptions;
using soms::Segment;
using soms::web::Answer;
using soms::web::answer_of_batch;
using soms::web::answer_of_lists;
using soms::web::guarded;
using soms::web::HeldShape;

static_assert(sizeof(Ray) == 7 * sizeof(double) && sizeof(Segment) == 6 * sizeof(double));

namespace {

/// Lines as they come: rays of 7 doubles (origin, direction, length), or segments of 6.
struct Lines {
  const double* numbers;
  std::uint32_t count;
  bool segments;

  template <class Query>
  [[nodiscard]] auto each(const Query& query) const {
    return segments ? query(std::span(reinterpret_cast<const Segment*>(numbers), count))
                    : query(std::span(reinterpret_cast<const Ray*>(numbers), count));
  }
};

/// `skip` is -1 for none.
RayOptions ray_options(std::int32_t skip, double milliseconds) {
  RayOptions options;
  if (skip >= 0) {
    options.skip = static_cast<soms::TriangleId>(skip);
  }
  options.deadline = soms::web::deadline_after(milliseconds);
  return options;
}

}  // namespace

SOMS_EXPORT(soms_closest_hit)

Answer* soms_closest_hit(const HeldShape* shape, const Pose* pose, const double* numbers,
                         std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                         double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip, milliseconds);
    return answer_of_batch<soms::ClosestHit>(Lines{numbers, count, segments != 0}.each(
        [&](auto lines) { return closest_hit(body, lines, options); }));
  });
}

SOMS_EXPORT(soms_any_hit)

Answer* soms_any_hit(const HeldShape* shape, const Pose* pose, const double* numbers,
                     std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                     double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip, milliseconds);
    return answer_of_batch<soms::AnyHit>(Lines{numbers, count, segments != 0}.each(
        [&](auto lines) { return any_hit(body, lines, options); }));
  });
}

SOMS_EXPORT(soms_all_hits)

Answer* soms_all_hits(const HeldShape* shape, const Pose* pose, const double* numbers,
                      std::uint32_t count, std::uint32_t segments, std::int32_t skip,
                      double milliseconds) {
  return guarded([&] {
    const Body body(shape->shape(), *pose);
    const RayOptions options = ray_options(skip, milliseconds);
    return answer_of_lists(Lines{numbers, count, segments != 0}.each(
        [&](auto lines) { return all_hits(body, lines, options); }));
  });
}
