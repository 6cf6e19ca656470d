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

template <class T>
void finish(const AboutCorner<T>& place, const Vector<T>& a, const Vector<T>& b, Ends<T>& result) {
  constexpr double kUnit = std::is_same_v<T, double> ? kUnitOfDouble : kUnitOfDoubleDouble;
  const Vector<T> between = minus(b, a);
  result.point_a = a;
  result.point_b = b;
  result.upper = sqrt(product(between, between)) + T(kUpperUnits * kUnit * place.reach);
}

template <class T>
Ends<T> ends_of_corners(const AboutCorner<T>& place, const Vector<T>& a, const Vector<T>& b) {
  Ends<T> result;
  finish(place, a, b, result);
  result.lower = lower_bound(place, minus(b, a));
  return result;
}

/// A corner, and an edge of the other triangle.
template <class T>
Ends<T> ends_of_edge(const AboutCorner<T>& place, const Vector<T>& tip, const Vector<T>& begin,
                     const Vector<T>& end, bool tip_first) {
  const Vector<T> e = minus(end, begin);
  const Vector<T> r = minus(tip, begin);
  const Vector<T> foot = plus(begin, e, clamped(T(product(r, e) / product(e, e)), T(1)));
  Ends<T> result;
  finish(place, tip_first ? tip : foot, tip_first ? foot : tip, result);
  result.lower = lower_bound(place, across(e, r));
  return result;
}

template <class T>
Ends<T> ends_of_face(const AboutCorner<T>& place, const Vector<T>& tip, const Vector<T>* face,
                     bool tip_first) {
  const Vector<T> e = minus(face[1], face[0]);
  const Vector<T> f = minus(face[2], face[0]);
  const Vector<T> r = minus(tip, face[0]);
  const Vector<T> n = cross_product(e, f);
  const T square = product(n, n);
  const T s = clamped(T(product(cross_product(r, f), n) / square), T(1));
  const T t = clamped(T(product(cross_product(e, r), n) / square), T(1) - s);
  const Vector<T> foot = plus(plus(face[0], e, s), f, t);
  Ends<T> result;
  finish(place, tip_first ? tip : foot, tip_first ? foot : tip, result);
  result.lower = lower_bound(place, n);
  return result;
}

template <class T>
Ends<T> ends_of_edges(const AboutCorner<T>& place, const std::array<const Vector<T>*, 4>& at) {
  const Vector<T> e = minus(*at[1], *at[0]);
  const Vector<T> f = minus(*at[3], *at[2]);
  const Vector<T> r = minus(*at[2], *at[0]);
  const Vector<T> n = cross_product(e, f);
  const T square = product(n, n);
  const T s = clamped(T(product(cross_product(r, f), n) / square), T(1));
  const T t = clamped(T(product(cross_product(r, e), n) / square), T(1));
  Ends<T> result;
  finish(place, plus(*at[0], e, s), plus(*at[2], f, t), result);
  result.lower = lower_bound(place, n);
  // The product of nearly parallel edges is mostly rounding; what is across one of them is not.
  if (first_part(square) < 0x1p-20 * first_part(product(e, e)) * first_part(product(f, f))) {
    const T other = lower_bound(place, across(e, r));
    result.lower = std::max(result.lower, other);
  }
  return result;
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
  const Vector<T>* const a = place.corners.data();
  const Vector<T>* const b = a + 3;
  const Vector<T>& first_a = a[first_corner(features[0])];
  const Vector<T>& first_b = b[first_corner(features[1])];
  const Vector<T>& last_a = a[last_corner(features[0])];
  const Vector<T>& last_b = b[last_corner(features[1])];
  if (features[0] == kFace) {
    return ends_of_face(place, first_b, a, false);
  }
  if (features[1] == kFace) {
    return ends_of_face(place, first_a, b, true);
  }
  switch (2 * corner_count(features[0]) + corner_count(features[1])) {
    case 3:
      return ends_of_corners(place, first_a, first_b);
    case 4:
      return ends_of_edge(place, first_a, first_b, last_b, true);
    case 5:
      return ends_of_edge(place, first_b, first_a, last_a, false);
    default:
      return ends_of_edges(place, {&first_a, &last_a, &first_b, &last_b});
  }
}

template struct AboutCorner<double>;
template struct AboutCorner<DoubleDouble>;
template Ends<double> ends(const AboutCorner<double>&, const FeaturePair&);
template Ends<DoubleDouble> ends(const AboutCorner<DoubleDouble>&, const FeaturePair&);

}  // namespace soms::detail
