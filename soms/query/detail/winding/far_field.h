/// \file
/// What triangles far away add to a winding number, all at once, and a proved bound on the error.
///
/// The winding number of triangles T from p is 1/(4 pi) times the integral of n.f(x - p) over T,
/// with f(v) = v / |v|^3 and n the unit normals. About a center c, with y = x - c and g = c - p, f
/// is expanded to second order, and what is left are sums over the triangles:
///   N.g / R^3 + (tr M - 3 g.M g / R^2) / R^3 + (-3 W.g / R^5 + 15 Q(g, g, g) / R^7) / 2,
/// where R = |g|, N is the integral of n, M of n y^T, W of 2 (n.y) y + (y.y) n, and Q(g, g, g) of
/// (n.g) (y.g)^2. \source Barill, Dickson, Schmidt, Levin and Jacobson 2018, whose criterion for
/// what is far is another: theirs is a heuristic.
///
/// What is left out. f = -grad(1/r), and the k-th derivative of the harmonic function 1/r along
/// unit vectors, whichever they are, is at most k! / r^(k+1): along one vector it is k! P_k(cos) /
/// r^(k+1) with a Legendre polynomial, and for symmetric forms one vector is the worst case
/// (Banach). With Lagrange's remainder the integrand is off by at most 4! |y|^3 / (3! (R - r)^5),
/// r the largest |y|. So the sum is off by at most C / (pi (R - r)^5), C the integral of |y|^3,
/// which is at most the sum of each triangle's area times its largest |y|^3.
///
/// Rounding, for n triangles, u = 2^-53, and A the sum of |e| |e'| / 2 over them for two edges
/// each: their areas are at most that. A vector of area is off by 5.7 u |e| |e'| / 2, the moments
/// over it by at most 12 u more, and sums by n u: together (n + 32) u A r^k for the moments of
/// degree k. In the formula, powers of 1/R and R are off by at most 27 u, products and sums add up
/// to 25, 50 and 70 u for the three terms, which in absolute values are at most 1, 4 r/R and 12
/// (r/R)^2 times A / R^2. Taken are only p with r <= R / 2; so all is at most (6 (n + 32) + 335) u
/// A / R^2, over 4 pi less than (n + 128) u A / (2 R^2); used is twice that.
///
/// Lengths are in units of a power of two next to r, so nothing overflows; where the point is so
/// far that a square would, the triangles add less than 2^-400. Where r is 0 all triangles are in
/// one place, and add nothing to the number of any other point.
///
/// Underflow. In that unit r is at least 2^-75: the unit is 2^-1000 at least, and what it is about
/// is not below 2^-1074. So R - r, above r, has a fifth power of 2^-375 and more, and squares and
/// cubes of R do not underflow either; where the power overflows, what it divides is below 2^-400.
/// Of a triangle, products of lengths may: its moments are off by less than 2^-1070, and A has
/// 2^-500 more for each, u times which is above that. In the formula, terms of v are off by 2^-1074
/// each: below 2^-400, which is added to the error.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <optional>
#include <span>

namespace soms::detail {

/// A number, and by how much it is off at most.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// Moments of triangles.
class FarField {
 public:
  FarField() = default;

  /// \cost O(n)
  explicit FarField(std::span<const Triangle> triangles);

  /// What the triangles add to the winding number of `point`; nothing where it may be off by more
  /// than `tolerance`, or is not far.
  [[nodiscard]] std::optional<Estimate> at(const Vec3& point, double tolerance) const;

 private:
  void add(const Triangle& t);

  [[nodiscard]] double value(const Vec3& toward, double inverse) const;

  Vec3 center_;
  double scale_ = 1;                              // to its unit of length
  double reach_ = 0;                              // r, and all below, in that unit
  double area_ = 0;                               // A, at least
  double cubes_ = 0;                              // C, at least
  double rounding_ = 0;                           // error by rounding, times R^2
  Vec3 normal_;                                   // N
  double trace_ = 0;                              // of M
  std::array<double, 6> first_ = {};              // M made symmetric: xx yy zz, 2 xy, 2 xz, 2 yz
  Vec3 second_;                                   // W
  std::array<double, 10> second_of_normal_ = {};  // Q: xxx yyy zzz xxy xxz yyx yyz zzx zzy xyz
};

}  // namespace soms::detail
