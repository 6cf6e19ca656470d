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

#include <span>
#include <utility>
#include <vector>

using soms::Body;
using soms::ClosestOptions;
using soms::Pose;
using soms::Vec3;
using soms::WindingIndex;
using soms::web::Answer;
using soms::web::answer_of;
using soms::web::deadline_after;
using soms::web::guarded;
using soms::web::HeldShape;

namespace {

ClosestOptions closest_options(double at_most, double milliseconds) {
  ClosestOptions options;
  options.at_most = at_most;
  options.deadline = deadline_after(milliseconds);
  return options;
}

Answer* answer_of_rows(soms::NearTriangles found) {
  return answer_of(found.offsets, std::move(found.triangle), std::move(found.lower),
                   std::move(found.upper), found.coverage, found.cost);
}

}  // namespace

/// Columns: lower f64, upper f64, triangle i32, point f64 x 3, feature u8, farther u8, coverage u8,
/// cost.
SOMS_EXPORT(soms_closest)

Answer* soms_closest(const HeldShape* shape, const Pose* pose, const Vec3* points,
                     std::uint32_t count, double at_most, double milliseconds) {
  return guarded([&] {
    soms::ClosestBatch found = closest(Body(shape->shape(), *pose), std::span(points, count),
                                       closest_options(at_most, milliseconds));
    return answer_of(std::move(found.lower), std::move(found.upper), found.triangle,
                     std::move(found.point), found.feature, std::move(found.farther),
                     found.coverage, found.cost);
  });
}

/// Columns as of `soms_closest`, and side u8.
SOMS_EXPORT(soms_signed_closest)

Answer* soms_signed_closest(HeldShape* shape, const Pose* pose, const Vec3* points,
                            std::uint32_t count, double at_most, double milliseconds) {
  return guarded([&] {
    soms::SignedClosestBatch both = closest(shape->closed_at(*pose), std::span(points, count),
                                            closest_options(at_most, milliseconds));
    soms::ClosestBatch& found = both.closest;
    return answer_of(std::move(found.lower), std::move(found.upper), found.triangle,
                     std::move(found.point), found.feature, std::move(found.farther),
                     found.coverage, found.cost, both.side);
  });
}

/// The `most` nearest triangles. Columns: offsets u32, triangle u32, lower f64, upper f64, coverage
/// u8, cost.
SOMS_EXPORT(soms_nearest_triangles)

Answer* soms_nearest_triangles(const HeldShape* shape, const Pose* pose, const Vec3* points,
                               std::uint32_t count, std::uint32_t most, double at_most,
                               double milliseconds) {
  return guarded([&] {
    return answer_of_rows(nearest_triangles(Body(shape->shape(), *pose), std::span(points, count),
                                            most, closest_options(at_most, milliseconds)));
  });
}

/// The triangles within `radius`. Columns as of `soms_nearest_triangles`.
SOMS_EXPORT(soms_near_triangles)

Answer* soms_near_triangles(const HeldShape* shape, const Pose* pose, const Vec3* points,
                            std::uint32_t count, double radius, double milliseconds) {
  return guarded([&] {
    ClosestOptions options;
    options.deadline = deadline_after(milliseconds);
    return answer_of_rows(
        near_triangles(Body(shape->shape(), *pose), std::span(points, count), radius, options));
  });
}

/// Columns: side u8, coverage u8 (one for all points), cost.
SOMS_EXPORT(soms_contains)

Answer* soms_contains(HeldShape* shape, const Pose* pose, const Vec3* points, std::uint32_t count,
                      double milliseconds) {
  return guarded([&] {
    soms::ContainsOptions options;
    options.deadline = deadline_after(milliseconds);
    const soms::ContainsBatch found =
        contains(shape->closed_at(*pose), std::span(points, count), options);
    return answer_of(found.side, std::vector<soms::Coverage>{found.coverage}, found.cost);
  });
}

SOMS_EXPORT(soms_winding_index)

WindingIndex* soms_winding_index(const HeldShape* shape, const Pose* pose) {
  return guarded([&] { return new WindingIndex(Body(shape->shape(), *pose)); });
}

SOMS_EXPORT(soms_winding_index_free) void soms_winding_index_free(WindingIndex* index) {
  delete index;
}

/// Columns: side u8, lower f64, upper f64, coverage u8, cost.
SOMS_EXPORT(soms_winding)

Answer* soms_winding(const WindingIndex* index, const Vec3* points, std::uint32_t count,
                     double width, double milliseconds) {
  return guarded([&] {
    soms::WindingOptions options;
    options.width = width;
    options.deadline = deadline_after(milliseconds);
    const soms::WindingBatch found = winding(*index, std::span(points, count), options);
    std::vector<double> lower;
    std::vector<double> upper;
    for (const soms::Bracket& number : found.number) {
      lower.push_back(number.lower);
      upper.push_back(number.upper);
    }
    return answer_of(found.side, std::move(lower), std::move(upper), found.coverages, found.cost);
  });
}
