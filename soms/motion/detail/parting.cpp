#include "soms/motion/detail/parting.h"

#include "soms/geometry/detail/nearest_guess.h"
#include "soms/motion/detail/motion_interval.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

namespace {

/// Edges whose directions have a product shorter than this are taken for parallel.
constexpr double kParallel = 0x1p-24;

Vec3 edge_direction(const Corners& c, std::size_t i) {
  return direction_of(c[(i + 1) % 3] - c[i]);
}

Vec3 normal_of(const Corners& c) {
  return direction_of(cross(direction_of(c[1] - c[0]), direction_of(c[2] - c[0])));
}

/// The direction of an edge that a feature is.
Vec3 direction_of_edge(const Corners& c, Feature edge) {
  return direction_of(c[last_corner(edge)] - c[first_corner(edge)]);
}

/// The direction of a shortest segment between these features.
Vec3 direction_between(const Corners& x, Feature f, const Corners& y, Feature g) {
  if (f == kFace) {
    return normal_of(x);
  }
  if (g == kFace) {
    return normal_of(y);
  }
  const bool edge_f = corner_count(f) == 2;
  const bool edge_g = corner_count(g) == 2;
  const Vec3 way = direction_of(y[first_corner(g)] - x[first_corner(f)]);
  if (!edge_f && !edge_g) {
    return way;
  }
  if (edge_f && edge_g) {
    const Vec3 n = cross(direction_of_edge(x, f), direction_of_edge(y, g));
    if (dot(n, n) > kParallel * kParallel) {
      return direction_of(n);
    }
  }
  const Vec3 along = edge_f ? direction_of_edge(x, f) : direction_of_edge(y, g);
  return direction_of(way - along * dot(way, along));
}

}  // namespace

double gap_along(const Vec3& n, const Corners& x, const Corners& y) {
  const Vec3& about = y[0];
  const double least = std::min({dot(n, x[0] - about), dot(n, x[1] - about), dot(n, x[2] - about)});
  return least - std::max({0.0, dot(n, y[1] - about), dot(n, y[2] - about)});
}

Parting parted_along(const Vec3& n, const Corners& x, const Corners& y) {
  const double gap = gap_along(n, x, y);
  const double other = gap_along(-n, x, y);
  return other > gap ? Parting{-n, other} : Parting{n, gap};
}

std::array<Vec3, 11> separating_directions(const Corners& x, const Corners& y) {
  std::array<Vec3, 11> found;
  found[0] = normal_of(x);
  found[1] = normal_of(y);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      found[2 + 3 * i + j] = direction_of(cross(edge_direction(x, i), edge_direction(y, j)));
    }
  }
  return found;
}

Parting parting_of(const Corners& x, const Corners& y, double enough) {
  const FeaturePair features = guess_features(triangle_of(x), triangle_of(y));
  Parting best = parted_along(direction_between(x, features[0], y, features[1]), x, y);
  if (best.gap > enough) {
    return best;
  }
  for (const Vec3& n : separating_directions(x, y)) {
    const Parting next = parted_along(n, x, y);
    best = next.gap > best.gap ? next : best;
  }
  return best;
}

}  // namespace soms::detail
