// Queries of points against one body.
#include "soms/query/closest.h"
#include "soms/query/contains.h"
#include "soms/query/signed_closest.h"
#include "soms/query/winding.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <memory>
#include <span>

using soms::Body;
using soms::Pose;
using soms::Vec3;
using soms::WindingIndex;
using soms::web::add_columns;
using soms::web::Answer;
using soms::web::answer_of_batch;
using soms::web::answer_of_lists;
using soms::web::guarded;
using soms::web::HeldShape;
using soms::web::within_time;

// Columns are those of the fields of the answer (fields.js), and its cost.

SOMS_EXPORT(soms_closest)

Answer* soms_closest(const HeldShape* shape, const Pose* pose, const Vec3* points,
                     std::uint32_t count, double at_most, double milliseconds) {
  return guarded([&] {
    return answer_of_batch<soms::Closest>(closest(Body(shape->shape(), *pose),
                                                  std::span(points, count), {.at_most = at_most},
                                                  within_time(milliseconds)));
  });
}

/// Columns as of `soms_closest`, and the side.
SOMS_EXPORT(soms_signed_closest)

Answer* soms_signed_closest(HeldShape* shape, const Pose* pose, const Vec3* points,
                            std::uint32_t count, double at_most, double milliseconds) {
  return guarded([&] {
    soms::SignedClosestBatch both = closest(shape->closed_at(*pose), std::span(points, count),
                                            {.at_most = at_most}, within_time(milliseconds));
    auto answer = std::make_unique<Answer>();
    add_columns<soms::Closest>(*answer, both.closest);
    answer->add(both.side);
    return answer.release();
  });
}

/// The `most` nearest triangles.
SOMS_EXPORT(soms_nearest_triangles)

Answer* soms_nearest_triangles(const HeldShape* shape, const Pose* pose, const Vec3* points,
                               std::uint32_t count, std::uint32_t most, double at_most,
                               double milliseconds) {
  return guarded([&] {
    return answer_of_lists(nearest_triangles(Body(shape->shape(), *pose), std::span(points, count),
                                             most, {.at_most = at_most},
                                             within_time(milliseconds)));
  });
}

/// The triangles within `radius`.
SOMS_EXPORT(soms_near_triangles)

Answer* soms_near_triangles(const HeldShape* shape, const Pose* pose, const Vec3* points,
                            std::uint32_t count, double radius, double milliseconds) {
  return guarded([&] {
    return answer_of_lists(near_triangles(Body(shape->shape(), *pose), std::span(points, count),
                                          radius, {}, within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_contains)

Answer* soms_contains(HeldShape* shape, const Pose* pose, const Vec3* points, std::uint32_t count,
                      double milliseconds) {
  return guarded([&] {
    return answer_of_batch<soms::Contains>(
        contains(shape->closed_at(*pose), std::span(points, count), within_time(milliseconds)));
  });
}

SOMS_EXPORT(soms_winding_index)

WindingIndex* soms_winding_index(const HeldShape* shape, const Pose* pose) {
  return guarded([&] { return new WindingIndex(Body(shape->shape(), *pose)); });
}

SOMS_EXPORT(soms_winding_index_free) void soms_winding_index_free(WindingIndex* index) {
  delete index;
}

SOMS_EXPORT(soms_winding)

Answer* soms_winding(const WindingIndex* index, const Vec3* points, std::uint32_t count,
                     double width, double milliseconds) {
  return guarded([&] {
    soms::WindingOptions options;
    options.width = width;
    return answer_of_batch<soms::Winding>(
        winding(*index, std::span(points, count), options, within_time(milliseconds)));
  });
}
