#include "soms/geometry/contact_box.h"

#include "soms/base/arithmetic.h"
#include "soms/base/common_box.h"
#include "soms/geometry/common_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms {

namespace {

constexpr std::uint64_t kTightPairs = 1000;

/// More than the error of `crossing`, as a share of the extent of both triangles.
constexpr double kCrossingError = 4e-12;

/// Two roundings of a coordinate by `crossing`, one where the error is added, and one to spare.
constexpr double kRoundings = 4 * std::numeric_limits<double>::epsilon();

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (const Vec3& corner : {box.lower, box.upper}) {
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  }
  return largest;
}

}  // namespace

void grow_by_contact(Box& box, std::uint64_t count, const Triangle& a, const Triangle& b) {
  const PlainArithmetic plain;
  const Box shared = common_box(bounds(a), bounds(b));
  if (count >= kTightPairs || box.contains(shared)) {
    box.grow(shared);
    return;
  }
  Box both = bounds(a);
  both.grow(bounds(b));
  const Vec3 extent = both.extent();
  const double error = kCrossingError * std::max({extent.x, extent.y, extent.z}) +
                       kRoundings * largest_coordinate(both);
  Box tight;
  const CommonPoints common = common_points(a, b);
  for (const Vec3& corner : common.points()) {
    tight.grow(corner - Vec3{error, error, error});
    tight.grow(corner + Vec3{error, error, error});
  }
  const Box inside = common_box(tight, shared);
  box.grow(inside.empty() ? shared : inside);
}

}  // namespace soms
