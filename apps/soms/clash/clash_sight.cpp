#include "apps/soms/clash/clash_sight.h"

#include "soms/query/ray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::command {

namespace {

/// Directions to the eye, the best ones first: sines and cosines of how much they rise, each with
/// four turns around the vertical.
struct Rise {
  double level;
  double up;
  double cost;
};

/// From below, floors are dark, and hide what stands on them: worse than seeing through the larger
/// part, which pictures draw as glass, and better than being hidden by both.
constexpr double kFromBelow = 1.6;

constexpr std::array kRises{Rise{0.8191520442889918, 0.573576436351046, 0},    // 35 degrees up
                            Rise{0.9659258262890683, 0.25881904510252074, 0},  // 15 degrees up
                            Rise{0.8660254037844387, -0.5, kFromBelow}};       // 30 degrees down
constexpr double kAlong = 0.8660254037844387;  // of a turn by 60 degrees
constexpr double kAside = 0.5;
constexpr std::array kTurns{Vec3{kAside, -kAlong, 0}, Vec3{kAlong, kAside, 0},
                            Vec3{-kAlong, -kAside, 0}, Vec3{-kAside, kAlong, 0}};

/// Being hidden by the larger part is worse, as it hides more.
constexpr double kHiddenByLarger = 1.5;

double length_of(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// Sides of a part's box, the longest first.
std::array<double, 3> sides_of(const PartBody* part) {
  if (part == nullptr || part->body.shape.bounds().empty()) {
    return {};
  }
  const Vec3 extent = part->body.shape.bounds().extent();
  std::array<double, 3> sides{extent.x, extent.y, extent.z};
  std::sort(sides.rbegin(), sides.rend());
  return sides;
}

/// How much of a picture shows a clash: all that is shared; else more of wide parts than of thin
/// ones, but so that the thinner of the two can still be seen. `a` and `b` are how thick the two
/// are.
double reach_of(double shared, double a, double b) {
  const double thin = a > 0 && b > 0 ? std::min(a, b) : std::max(a, b);
  return std::max(0.6 * shared,
                  std::min(2.2 * std::sqrt(thin * std::max(a, b)), 0.6 * shared + 7 * thin));
}

/// How much of the line of sight to the place the two parts hide.
double hidden(const ClashSight& sight, const PartBody* larger, const PartBody* smaller) {
  // Parts meet at the place itself.
  const Ray line = Ray::between(sight.place + 0.03 * sight.reach * sight.toward, sight.eye());
  const auto hides = [&](const PartBody* part) {
    return part != nullptr && any_hit(part->body, line).hit;
  };
  return (hides(larger) ? kHiddenByLarger : 0) + (hides(smaller) ? 1 : 0);
}

}  // namespace

std::optional<ClashSight> sight_of(const ClashModels& models, const ListedClash& clash) {
  if (!clash.place) {
    return std::nullopt;
  }
  const PartBody* const a = clash.a ? &models.a.parts[*clash.a] : nullptr;
  const PartBody* const b = clash.b ? &models.second().parts[*clash.b] : nullptr;
  const std::array<double, 3> a_sides = sides_of(a);
  const std::array<double, 3> b_sides = sides_of(b);
  ClashSight best{.place = *clash.place,
                  .focus = clash.box.empty() ? *clash.place : clash.box.center(),
                  .a_is_larger = a_sides[1] > b_sides[1]};
  const double shared = clash.box.empty() ? 0 : length_of(clash.box.extent());
  best.reach = reach_of(shared, a_sides[1], b_sides[1]);
  const double far = length_of(best.focus);
  if (!(best.reach > 1e-9 * far)) {
    best.reach = far > 0 ? 1e-6 * far : 1;
  }
  double least = 0;
  bool first = true;
  for (const Rise& rise : kRises) {
    for (const Vec3& turn : kTurns) {
      ClashSight sight = best;
      sight.toward = rise.level * turn + Vec3{0, 0, rise.up};
      const double now =
          rise.cost + hidden(sight, best.a_is_larger ? a : b, best.a_is_larger ? b : a);
      if (first || now < least) {
        first = false;
        least = now;
        best.toward = sight.toward;
      }
      if (least == 0) {
        return best;
      }
    }
  }
  return best;
}

}  // namespace soms::command
