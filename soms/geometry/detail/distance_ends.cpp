#include "soms/geometry/detail/distance_ends.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace soms::detail {

namespace {

template <class T>
using Vector = Coordinates3<T>;

double first_part(double x) {
  return x;
}

double first_part(const DoubleDouble& x) {
  return x.high;
}

using std::sqrt;

template <class T>
Vector<T> minus(const Vector<T>& a, const Vector<T>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class T>
Vector<T> plus(const Vector<T>& a, const Vector<T>& b, const T& s) {
  return {a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s};
}

template <class T>
T product(const Vector<T>& a, const Vector<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class T>
Vector<T> cross_product(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class T>
double largest(const Vector<T>& v) {
  return std::max(std::max(std::abs(first_part(v[0])), std::abs(first_part(v[1]))),
                  std::abs(first_part(v[2])));
}

/// x in [0, most]; 0 for what is not a number.
template <class T>
T clamped(const T& x, const T& most) {
  return x > T(0) ? (x < most ? x : most) : T(0);
}

/// b less its part along a, taken off twice, since once leaves u |b|.
template <class T>
Vector<T> across(const Vector<T>& a, const Vector<T>& b) {
  const T square = product(a, a);
  const Vector<T> once = plus(b, a, -(product(a, b) / square));
  return plus(once, a, -(product(a, once) / square));
}

/// A lower bound of the distance from a direction that points from triangle 0 to 1, or to 0.
template <class T>
T lower_bound(const AboutCorner<T>& place, const Vector<T>& n) {
  constexpr double kUnit = std::is_same_v<T, double> ? kUnitOfDouble : kUnitOfDoubleDouble;
  if (!(largest(n) >= kLeastDirection && largest(n) <= kMostDirection)) {
    return 0;
  }
  std::array<T, 6> height;
  for (std::size_t i = 0; i < 6; ++i) {
    height[i] = product(n, place.corners[i]);
  }
  const auto least = [&](std::size_t i) {
    return std::min(std::min(height[i], height[i + 1]), height[i + 2]);
  };
  const auto most = [&](std::size_t i) {
    return std::max(std::max(height[i], height[i + 1]), height[i + 2]);
  };
  const T gap = std::max(least(3) - most(0), least(0) - most(3));
  const double sum =
      std::abs(first_part(n[0])) + std::abs(first_part(n[1])) + std::abs(first_part(n[2]));
  const T rest = gap - T(kLowerUnits * kUnit * (sum * place.reach));
  if (!(rest > T(0))) {
    return 0;
  }
  return rest / sqrt(product(n, n)) * (T(1) - T(8 * kUnit));
}

/// The points of two features that are nearest to each other, and the normal that gave them: of the
/// face, or of both edges; nothing for corners and a corner with an edge.
template <class T>
struct Feet {
  Vector<T> point_a = {};
  Vector<T> point_b = {};
  Vector<T> normal = {};
};

/// The corners of the features of both triangles.
template <class T>
struct FeatureCorners {
  const Vector<T>* a;
  const Vector<T>* b;
  const Vector<T>& first_a;
  const Vector<T>& last_a;
  const Vector<T>& first_b;
  const Vector<T>& last_b;

  FeatureCorners(const AboutCorner<T>& place, const FeaturePair& features)
      : a(place.corners.data()),
        b(a + 3),
        first_a(a[first_corner(features[0])]),
        last_a(a[last_corner(features[0])]),
        first_b(b[first_corner(features[1])]),
        last_b(b[last_corner(features[1])]) {}
};

enum class FeatureKind : std::uint8_t {
  corners,
  edge_of_b,
  edge_of_a,
  edges,
  face_of_a,
  face_of_b
};

FeatureKind kind_of(const FeaturePair& features) {
  if (features[0] == kFace) {
    return FeatureKind::face_of_a;
  }
  if (features[1] == kFace) {
    return FeatureKind::face_of_b;
  }
  switch (2 * corner_count(features[0]) + corner_count(features[1])) {
    case 3:
      return FeatureKind::corners;
    case 4:
      return FeatureKind::edge_of_b;
    case 5:
      return FeatureKind::edge_of_a;
    default:
      return FeatureKind::edges;
  }
}

template <class T>
Vector<T> foot_on_edge(const Vector<T>& tip, const Vector<T>& begin, const Vector<T>& end) {
  const Vector<T> e = minus(end, begin);
  const Vector<T> r = minus(tip, begin);
  return plus(begin, e, clamped(T(product(r, e) / product(e, e)), T(1)));
}

template <class T>
Vector<T> foot_on_face(const Vector<T>& tip, const Vector<T>* face, Vector<T>& normal) {
  const Vector<T> e = minus(face[1], face[0]);
  const Vector<T> f = minus(face[2], face[0]);
  const Vector<T> r = minus(tip, face[0]);
  normal = cross_product(e, f);
  const T square = product(normal, normal);
  const T s = clamped(T(product(cross_product(r, f), normal) / square), T(1));
  const T t = clamped(T(product(cross_product(e, r), normal) / square), T(1) - s);
  return plus(plus(face[0], e, s), f, t);
}

template <class T>
Feet<T> feet_of_edges(const FeatureCorners<T>& at) {
  const Vector<T> e = minus(at.last_a, at.first_a);
  const Vector<T> f = minus(at.last_b, at.first_b);
  const Vector<T> r = minus(at.first_b, at.first_a);
  const Vector<T> n = cross_product(e, f);
  const T square = product(n, n);
  const T s = clamped(T(product(cross_product(r, f), n) / square), T(1));
  const T t = clamped(T(product(cross_product(r, e), n) / square), T(1));
  return {plus(at.first_a, e, s), plus(at.first_b, f, t), n};
}

template <class T>
Feet<T> feet(const FeatureCorners<T>& at, FeatureKind kind) {
  Feet<T> result;
  switch (kind) {
    case FeatureKind::corners:
      return {at.first_a, at.first_b};
    case FeatureKind::edge_of_b:
      return {at.first_a, foot_on_edge(at.first_a, at.first_b, at.last_b)};
    case FeatureKind::edge_of_a:
      return {foot_on_edge(at.first_b, at.first_a, at.last_a), at.first_b};
    case FeatureKind::edges:
      return feet_of_edges(at);
    case FeatureKind::face_of_a:
      result.point_b = at.first_b;
      result.point_a = foot_on_face(at.first_b, at.a, result.normal);
      return result;
    case FeatureKind::face_of_b:
      result.point_a = at.first_a;
      result.point_b = foot_on_face(at.first_a, at.b, result.normal);
      return result;
  }
  return result;
}

/// The lower bound of edges. The product of nearly parallel ones is mostly rounding; what is across
/// one of them is not.
template <class T>
T lower_of_edges(const AboutCorner<T>& place, const FeatureCorners<T>& at, const Vector<T>& n) {
  const T lower = lower_bound(place, n);
  const Vector<T> e = minus(at.last_a, at.first_a);
  const Vector<T> f = minus(at.last_b, at.first_b);
  if (first_part(product(n, n)) < 0x1p-20 * first_part(product(e, e)) * first_part(product(f, f))) {
    const T other = lower_bound(place, across(e, minus(at.first_b, at.first_a)));
    return std::max(lower, other);
  }
  return lower;
}

template <class T>
T lower_end(const AboutCorner<T>& place, const FeatureCorners<T>& at, FeatureKind kind,
            const Feet<T>& found) {
  switch (kind) {
    case FeatureKind::corners:
      return lower_bound(place, minus(at.first_b, at.first_a));
    case FeatureKind::edge_of_b:
      return lower_bound(place,
                         across(minus(at.last_b, at.first_b), minus(at.first_a, at.first_b)));
    case FeatureKind::edge_of_a:
      return lower_bound(place,
                         across(minus(at.last_a, at.first_a), minus(at.first_b, at.first_a)));
    case FeatureKind::edges:
      return lower_of_edges(place, at, found.normal);
    default:
      return lower_bound(place, found.normal);
  }
}

/// The exponent of a number above 0, without that of the number's unit.
int binary_exponent(double x) {
  return std::ilogb(x);
}

}  // namespace

template <class T>
AboutCorner<T>::AboutCorner(const Triangle& a, const Triangle& b) {
  const Vec3& origin = a.a;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec3& c = corner(i < 3 ? a : b, i % 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if constexpr (std::is_same_v<T, double>) {
        corners[i][axis] = c[axis] - origin[axis];
      } else {
        corners[i][axis] = two_sum(c[axis], -origin[axis]);
      }
      reach = std::max(reach, std::abs(first_part(corners[i][axis])));
    }
  }
  if ((reach >= 0x1p-100 && reach <= 0x1p100) || reach == 0) {
    return;
  }
  exponent = binary_exponent(reach);
  const auto scaled = [this](double x) { return std::ldexp(x, -exponent); };
  for (Coordinates3<T>& c : corners) {
    for (T& x : c) {
      if constexpr (std::is_same_v<T, double>) {
        x = scaled(x);
      } else {
        x = {scaled(x.high), scaled(x.low)};
      }
    }
  }
  reach = scaled(reach);
}

template <class T>
Ends<T> ends(const AboutCorner<T>& place, const FeaturePair& features) {
  constexpr double kUnit = std::is_same_v<T, double> ? kUnitOfDouble : kUnitOfDoubleDouble;
  const FeatureCorners<T> at(place, features);
  const FeatureKind kind = kind_of(features);
  const Feet<T> found = feet(at, kind);
  const Vector<T> between = minus(found.point_b, found.point_a);
  Ends<T> result;
  result.points = {found.point_a, found.point_b};
  result.upper = sqrt(product(between, between)) + T(kUpperUnits * kUnit * place.reach);
  result.lower = lower_end(place, at, kind, found);
  return result;
}

template <class T>
EndPoints<T> end_points(const AboutCorner<T>& place, const FeaturePair& features) {
  const Feet<T> found = feet(FeatureCorners<T>(place, features), kind_of(features));
  return {found.point_a, found.point_b};
}

template struct AboutCorner<double>;
template struct AboutCorner<DoubleDouble>;
template Ends<double> ends(const AboutCorner<double>&, const FeaturePair&);
template Ends<DoubleDouble> ends(const AboutCorner<DoubleDouble>&, const FeaturePair&);
template EndPoints<DoubleDouble> end_points(const AboutCorner<DoubleDouble>&, const FeaturePair&);

}  // namespace soms::detail
