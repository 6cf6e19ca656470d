#include "soms/motion/detail/parting.h"

#include "soms/geometry/detail/nearest_guess.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

namespace {

/// Edges whose directions have a product shorter than this are taken for parallel.
constexpr double kParallel = 0x1p-24;

/// The direction of an edge that a feature is.
Vec3 direction_of_edge(const Corners& c, Feature edge) {
  return direction_of(c[last_corner(edge)] - c[first_corner(edge)]);
}

/// The direction of a shortest segment between these features.
Vec3 direction_between(const Corners& x, Feature f, const Corners& y, Feature g) {
  if (f == kFace) {
    return sides_of(x).normal;
  }
  if (g == kFace) {
    return sides_of(y).normal;
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
  const Vec3& about = y[0];
  const auto [x_least, x_most] =
      std::minmax({dot(n, x[0] - about), dot(n, x[1] - about), dot(n, x[2] - about)});
  const auto [y_least, y_most] = std::minmax({0.0, dot(n, y[1] - about), dot(n, y[2] - about)});
  const double gap = x_least - y_most;
  const double other = y_least - x_most;
  return other > gap ? Parting{-n, other} : Parting{n, gap};
}

TriangleSides sides_of(const Corners& c) {
  TriangleSides sides;
  for (std::size_t k = 0; k < 3; ++k) {
    sides.edge[k] = direction_of(c[(k + 1) % 3] - c[k]);
  }
  sides.normal = direction_of(cross(sides.edge[0], sides.edge[2]));
  return sides;
}

Parting parting_of(const Corners& x, const Corners& y, double enough) {
  const FeaturePair features = guess_features(triangle_of(x), triangle_of(y));
  Parting best = parted_along(direction_between(x, features[0], y, features[1]), x, y);
  if (best.gap > enough) {
    return best;
  }
  for_separating_directions(sides_of(x), sides_of(y), [&](const Vec3& n) {
    const Parting next = parted_along(n, x, y);
    best = next.gap > best.gap ? next : best;
    return true;
  });
  return best;
}

}  // namespace soms::detail
