#include "soms/geometry/detail/point_feature.h"

#include "soms/geometry/detail/feature_proof.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace soms::detail {

namespace {

constexpr double kEdgeError = 32;
constexpr double kFaceError = 0x1p9;
constexpr double kLeastSquare = 0x1p-20;  // q of the proof

static_assert(15.1 + 1 + 1 < kEdgeError && 16.2 + 1 + 1 + 1 < kEdgeError);
static_assert(49 + 243 + 15 + 6 < kFaceError - 64);
static_assert(282 * 0x1p-53 < kSureShare && 1.01 * 140 * 0x1p-53 < 0x1p-20 * kLeastSquare);

constexpr Feature corner_feature(std::size_t i) {
  return static_cast<Feature>(1U << i);
}

/// The edge from corner i to the next.
constexpr Feature edge_feature(std::size_t i) {
  return static_cast<Feature>(1U << i | 1U << ((i + 1) % 3));
}

constexpr std::size_t next(std::size_t i) {
  return (i + 1) % 3;
}

/// Corners less the point, sides, and the products that decide.
class Finder {
 public:
  Finder(const Vec3& point, const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      r_[i] = corner(t, i) - point;
      long_r_[i] = safe_length(r_[i]);
      e_[i] = corner(t, next(i)) - corner(t, i);
      long_e_[i] = safe_length(e_[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      from_[i] = dot(r_[i], e_[i]);
      to_[i] = -dot(r_[next(i)], e_[i]);
    }
  }

  [[nodiscard]] PointFeature find() const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t before = next(next(i));
      if (r_[i] == Vec3{}) {
        return {corner_feature(i), corner_feature(i), 0};  // the point is the corner
      }
      if (from_[i] >= 0 && to_[before] >= 0) {
        const bool sure = above(from_[i], long_r_[i] * long_e_[i]) &&
                          above(to_[before], long_r_[i] * long_e_[before]);
        return {sure ? corner_feature(i) : Feature{0}, corner_feature(i), long_r_[i]};
      }
    }
    const Vec3 n = cross(e_[0], -e_[2]);
    const double lengths = long_e_[0] * long_e_[2];
    std::array<double, 3> side;  // above 0: the point is on the inner side of the edge
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      side[i] = -dot(cross(e_[i], r_[i]), n);
      if (from_[i] <= 0 && to_[i] <= 0 && side[i] <= 0) {
        return edge(i, above(-side[i], long_e_[i] * long_r_[i] * lengths));
      }
      inside = inside && above(side[i], long_e_[i] * long_r_[i] * lengths);
    }
    const double square = dot(n, n) / (lengths * lengths);
    const bool sure = inside && square >= kLeastSquare;
    const double error = kFaceError * long_r_[0] / std::min(square, 1.0);
    return {sure ? kFace : Feature{0}, inside ? kFace : nearest_edge(), error};
  }

 private:
  static bool above(double value, double lengths) { return value > kSureShare * lengths; }

  [[nodiscard]] PointFeature edge(std::size_t i, bool outside) const {
    const bool sure = outside && above(-from_[i], long_r_[i] * long_e_[i]) &&
                      above(-to_[i], long_r_[next(i)] * long_e_[i]);
    const std::size_t first = first_corner(edge_feature(i));
    return {sure ? edge_feature(i) : Feature{0}, edge_feature(i),
            kEdgeError * (long_r_[first] + long_e_[i])};
  }

  /// Where rounding leaves no region, as with triangles of no area.
  [[nodiscard]] Feature nearest_edge() const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = std::clamp(-from_[i] / dot(e_[i], e_[i]), 0.0, 1.0);
      const Vec3 way = r_[i] + e_[i] * (std::isnan(share) ? 0 : share);
      const double square = dot(way, way);
      if (square < least) {
        least = square;
        best = i;
      }
    }
    return edge_feature(best);
  }

  std::array<Vec3, 3> r_;
  std::array<Vec3, 3> e_;  // from corner i to the next
  std::array<double, 3> long_r_;
  std::array<double, 3> long_e_;
  std::array<double, 3> from_;  // r.e of corner i
  std::array<double, 3> to_;    // of the next corner, the other way
};

template <class T>
using Vector = std::array<T, 3>;

template <class T>
Vector<T> difference(const Vec3& a, const Vec3& b) {
  if constexpr (std::is_same_v<T, double>) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  } else {
    return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
  }
}

template <class T>
T product(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

PointFeature find_feature(const Vec3& point, const Triangle& triangle) {
  return Finder(point, triangle).find();
}

template <class T>
std::array<T, 3> way_to(const Vec3& point, const Triangle& triangle, Feature feature) {
  const Vec3& first = corner(triangle, first_corner(feature));
  const Vector<T> r = difference<T>(first, point);
  if (corner_count(feature) == 1) {
    return r;
  }
  if (feature != kFace) {
    const Vector<T> e = difference<T>(corner(triangle, last_corner(feature)), first);
    const T g = product(r, e) / product(e, e);
    return {r[0] - e[0] * g, r[1] - e[1] * g, r[2] - e[2] * g};
  }
  const Vector<T> e = difference<T>(triangle.b, triangle.a);
  const Vector<T> f = difference<T>(triangle.c, triangle.a);
  const Vector<T> n = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                       e[0] * f[1] - e[1] * f[0]};
  const T share = product(n, r) / product(n, n);
  return {n[0] * share, n[1] * share, n[2] * share};
}

std::optional<std::array<DoubleDouble, 3>> aligned_way(const Vec3& point, const Triangle& triangle,
                                                       Feature feature) {
  const Vec3& first = corner(triangle, first_corner(feature));
  std::array<DoubleDouble, 3> way;
  int dimensions = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_level(triangle, feature, axis)) {
      way[axis] = two_sum(first[axis], -point[axis]);
    } else {
      ++dimensions;
    }
  }
  return dimensions < corner_count(feature) ? std::optional(way) : std::nullopt;
}

template std::array<double, 3> way_to(const Vec3&, const Triangle&, Feature);
template std::array<DoubleDouble, 3> way_to(const Vec3&, const Triangle&, Feature);

}  // namespace soms::detail
