// Where pairs of triangles cross, for drawing.
#include "soms/geometry/common_points.h"
#include "soms/query/body.h"
#include "soms/query/detail/moved_triangle.h"

#include "web/bridge/answer.h"
#include "web/bridge/arguments.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

using soms::Body;
using soms::Pose;
using soms::Vec3;
using soms::web::Answer;
using soms::web::answer_of;
using soms::web::guarded;
using soms::web::HeldShape;

namespace {

/// \errors ErrorKind::usage where a shape has no such triangle.
void check_ids(const std::uint32_t* pairs, std::uint32_t count, const soms::Shape& a,
               const soms::Shape& b) {
  const std::array<std::size_t, 2> triangles = {a.mesh().triangles.size(),
                                                b.mesh().triangles.size()};
  for (std::size_t k = 0; k < 2 * std::size_t{count}; ++k) {
    if (pairs[k] >= triangles[k % 2]) {
      throw soms::Error(soms::ErrorKind::usage,
                        "pair " + std::to_string(k / 2) + ": triangle " + std::to_string(pairs[k]) +
                            " of " + std::to_string(triangles[k % 2]),
                        "give pairs that overlap found for these bodies, in this order");
    }
  }
}

}  // namespace

/// `pairs` are `count` x 2 triangles of `a` and `b`. Columns: offsets u32, of `count` + 1 rows;
/// corners f64 x 3 of what each pair has in common: none, a point, a segment's ends, or an outline.
SOMS_EXPORT(soms_crossings)

Answer* soms_crossings(const HeldShape* a, const Pose* pose_a, const HeldShape* b,
                       const Pose* pose_b, const std::uint32_t* pairs, std::uint32_t count) {
  return guarded([&] {
    const Body first(a->shape(), *pose_a);
    const Body second(b->shape(), *pose_b);
    check_ids(pairs, count, a->shape(), b->shape());
    std::vector<std::uint32_t> offsets{0};
    std::vector<Vec3> corners;
    for (std::uint32_t k = 0; k < count; ++k) {
      const soms::CommonPoints common =
          common_points(soms::detail::moved_triangle(first, pairs[2 * k]),
                        soms::detail::moved_triangle(second, pairs[2 * k + 1]));
      const std::span<const Vec3> points = common.points();
      corners.insert(corners.end(), points.begin(), points.end());
      offsets.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    return answer_of(std::move(offsets), std::move(corners));
  });
}
