#include "soms/query/detail/winding/far_field.h"

#include "soms/base/box.h"
#include "soms/base/double_limits.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

constexpr double kPi = 3.141592653589793;
constexpr double kFourPi = 4 * kPi;

// Constants of the proof in far_field.h.
constexpr double kTermsOfRounding = 128;
constexpr double kLeastDistance = 2;     // over the reach
constexpr double kMostSquare = 0x1p900;  // of a distance; beyond, triangles add nothing
constexpr double kNothing = 0x1p-400;    // at least what they add there, and what underflows
constexpr double kUnderflowOfMoments = 0x1p-500;  // covers it in what a triangle adds
constexpr double kUpward = 1 + 0x1p-20;  // covers the rounding of sums of fewer than 2^31 terms
static_assert((6 * (1 + 32) + 335) / kFourPi < (1 + kTermsOfRounding) / 2);
static_assert(6 / kFourPi < 0.5);

/// A power of two that brings a length next to 1. \pre `length` >= 0, at most 2^302
double unit_for(double length) {
  int exponent = 0;
  std::frexp(length, &exponent);
  return length == 0 ? 1 : std::ldexp(1.0, std::min(-exponent, 1000));
}

}  // namespace

FarField::FarField(std::span<const Triangle> triangles) {
  Box box;
  for (const Triangle& t : triangles) {
    box.grow(bounds(t));
  }
  center_ = box.lower + box.extent() * 0.5;
  double reach = 0;
  for (const Triangle& t : triangles) {
    for (const Vec3& corner : {t.a, t.b, t.c}) {
      const Vec3 y = corner - center_;
      reach = std::max({reach, std::abs(y.x), std::abs(y.y), std::abs(y.z)});
    }
  }
  scale_ = unit_for(reach);
  for (const Triangle& t : triangles) {
    add(t);
  }
  reach_ = std::sqrt(reach_) * kUpward;
  area_ *= kUpward;
  cubes_ *= kUpward;
  rounding_ = (static_cast<double>(triangles.size()) + kTermsOfRounding) * kRoundingUnit * area_;
}

void FarField::add(const Triangle& t) {
  const Vec3 e = (t.b - t.a) * scale_;
  const Vec3 f = (t.c - t.a) * scale_;
  const Vec3 n = cross(e, f) * 0.5;
  const std::array<Vec3, 3> y{(t.a - center_) * scale_, (t.b - center_) * scale_,
                              (t.c - center_) * scale_};
  const double most = std::max({dot(y[0], y[0]), dot(y[1], y[1]), dot(y[2], y[2])});
  const double area = 0.5 * std::sqrt(dot(e, e)) * std::sqrt(dot(f, f)) + kUnderflowOfMoments;
  reach_ = std::max(reach_, most);
  area_ += area;
  cubes_ += area * most * std::sqrt(most);
  normal_ += n;
  const Vec3 sum = (y[0] + y[1]) + y[2];
  const Vec3 mean = sum * (1.0 / 3);
  trace_ += dot(n, mean);
  const std::array<double, 6> first{n.x * mean.x,
                                    n.y * mean.y,
                                    n.z * mean.z,
                                    n.x * mean.y + n.y * mean.x,
                                    n.x * mean.z + n.z * mean.x,
                                    n.y * mean.z + n.z * mean.y};
  for (std::size_t k = 0; k < 6; ++k) {
    first_[k] += first[k];
  }
  // Means over the triangle: of y_i y_j.
  const auto mean_of = [&](std::size_t i, std::size_t j) {
    return ((sum[i] * sum[j] + y[0][i] * y[0][j]) + (y[1][i] * y[1][j] + y[2][i] * y[2][j])) *
           (1.0 / 12);
  };
  const double xx = mean_of(0, 0);
  const double yy = mean_of(1, 1);
  const double zz = mean_of(2, 2);
  const double xy = mean_of(0, 1);
  const double xz = mean_of(0, 2);
  const double yz = mean_of(1, 2);
  const Vec3 along{(n.x * xx + n.y * xy) + n.z * xz, (n.x * xy + n.y * yy) + n.z * yz,
                   (n.x * xz + n.y * yz) + n.z * zz};
  second_ += along * 2 + n * ((xx + yy) + zz);
  const std::array<double, 10> cubic{n.x * xx,
                                     n.y * yy,
                                     n.z * zz,
                                     2 * n.x * xy + n.y * xx,
                                     2 * n.x * xz + n.z * xx,
                                     2 * n.y * xy + n.x * yy,
                                     2 * n.y * yz + n.z * yy,
                                     2 * n.z * xz + n.x * zz,
                                     2 * n.z * yz + n.y * zz,
                                     2 * ((n.x * yz + n.y * xz) + n.z * xy)};
  for (std::size_t k = 0; k < 10; ++k) {
    second_of_normal_[k] += cubic[k];
  }
}

std::optional<Estimate> FarField::at(const Vec3& point, double tolerance) const {
  if (reach_ == 0) {
    return tolerance >= 0 && point != center_ ? std::optional(Estimate{0, 0}) : std::nullopt;
  }
  const Vec3 g = (center_ - point) * scale_;
  const double square = dot(g, g);
  if (!(square < kMostSquare)) {
    return kNothing <= tolerance ? std::optional(Estimate{0, kNothing}) : std::nullopt;
  }
  const double distance = std::sqrt(square);
  if (distance <= kLeastDistance * reach_ * kUpward) {
    return std::nullopt;
  }
  const double gap = distance * (1 - 0x1p-20) - reach_;
  const double cube = gap * gap * gap;
  const double error =
      (cubes_ / (kPi * gap * gap * cube) + rounding_ / square) * kUpward + kNothing;
  if (!(error <= tolerance)) {
    return std::nullopt;
  }
  const double inverse = 1 / distance;
  return Estimate{value(g * inverse, inverse), error};
}

double FarField::value(const Vec3& v, double inverse) const {
  const auto& m = first_;
  const auto& q = second_of_normal_;
  const double xx = v.x * v.x;
  const double yy = v.y * v.y;
  const double zz = v.z * v.z;
  const double turned = ((m[0] * xx + m[1] * yy) + m[2] * zz) +
                        ((m[3] * (v.x * v.y) + m[4] * (v.x * v.z)) + m[5] * (v.y * v.z));
  const double cubic = ((v.x * (q[0] * xx + (q[5] * yy + q[7] * zz))) +
                        (v.y * (q[1] * yy + (q[3] * xx + q[8] * zz)))) +
                       ((v.z * (q[2] * zz + (q[4] * xx + q[6] * yy))) + q[9] * (v.x * v.y * v.z));
  const double order0 = dot(normal_, v);
  const double order1 = trace_ - 3 * turned;
  const double order2 = 0.5 * (15 * cubic - 3 * dot(second_, v));
  return (inverse * inverse) * (order0 + inverse * (order1 + inverse * order2)) / kFourPi;
}

}  // namespace soms::detail
