#include "soms/tree/layout/detail/node_axes.h"

#include <cmath>

namespace soms::layout {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Matrix covariance(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3& p : points) {
    sum += p;
  }
  const Vec3 mean = sum * (1 / static_cast<double>(points.size()));
  Matrix m = {};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        m[i][j] += d[i] * d[j];
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      m[i][j] = m[j][i];
    }
  }
  return m;
}

/// Turns the plane (p, q) so that m[p][q] vanishes; the turn is gathered in `axes`.
void turn(Matrix& m, Matrix& axes, std::size_t p, std::size_t q) {
  if (!(std::abs(m[p][q]) > 0x1p-60 * (std::abs(m[p][p]) + std::abs(m[q][q])))) {
    return;
  }
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[k][p];
    const double b = m[k][q];
    m[k][p] = c * a - s * b;
    m[k][q] = s * a + c * b;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[p][k];
    const double b = m[q][k];
    m[p][k] = c * a - s * b;
    m[q][k] = s * a + c * b;
    const double x = axes[k][p];
    const double y = axes[k][q];
    axes[k][p] = c * x - s * y;
    axes[k][q] = s * x + c * y;
  }
}

Axes rounded(const Matrix& axes) {
  Axes out = kMeshAxes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out[3 * i + j] = static_cast<float>(axes[i][j]);
    }
  }
  return out;
}

Axes principal_axes(Matrix m) {
  Matrix axes = kIdentity;
  constexpr int kSweeps = 6;  // it converges quadratically; four are enough for doubles
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    turn(m, axes, 0, 1);
    turn(m, axes, 0, 2);
    turn(m, axes, 1, 2);
  }
  return rounded(axes);
}

Matrix covariance(const Moments& m) {
  Matrix c = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    c[i][i] = m.square[i] - m.sum[i] * m.sum[i] / m.points;
    c[i][j] = c[j][i] = m.product[i] - m.sum[i] * m.sum[j] / m.points;
  }
  return c;
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

std::array<double, 3> times(const Matrix& m, const std::array<double, 3>& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

/// Two unit vectors at right angles to a third.
std::array<std::array<double, 3>, 2> across(const std::array<double, 3>& n) {
  // Duff et al. 2017, Building an orthonormal basis, revisited.
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1 / (sign + n[2]);
  const double b = n[0] * n[1] * a;
  return {
      {{1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]}, {b, sign + n[1] * n[1] * a, -n[1]}}};
}

/// Axis 2 is `n`; the others are principal in the plane across it.
Axes flat_axes(const Matrix& covariance, const std::array<double, 3>& n) {
  auto [u, v] = across(n);
  const auto cu = times(covariance, u);
  const double uu = dot(u, cu);
  const double uv = dot(v, cu);
  const double vv = dot(v, times(covariance, v));
  if (std::abs(uv) > 0x1p-30 * (std::abs(uu) + std::abs(vv))) {  // rounding may leave them negative
    const double theta = (vv - uu) / (2 * uv);
    const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1);
    const double s = t * c;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = u[k];
      const double b = v[k];
      u[k] = c * a - s * b;
      v[k] = s * a + c * b;
    }
  }
  return rounded({{{u[0], v[0], n[0]}, {u[1], v[1], n[1]}, {u[2], v[2], n[2]}}});
}

}  // namespace

Axes principal_axes(std::span<const Vec3> points) {
  return principal_axes(covariance(points));
}

void Moments::add(const Moments& other, const Vec3& offset) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double shift = other.points * offset[i];
    sum[i] += other.sum[i] + shift;
    square[i] += other.square[i] + (2 * other.sum[i] + shift) * offset[i];
    product[i] += (other.product[i] + other.sum[i] * offset[j]) +
                  (other.sum[j] * offset[i] + shift * offset[j]);
    normal[i] += other.normal[i];
  }
  points += other.points;
  area += other.area;
}

Axes axes_of(const Moments& moments) {
  constexpr double kFlatShare = 0.7;  // share of the area that the mean normal must keep
  const Matrix m = covariance(moments);
  const auto& n = moments.normal;
  const double norm = (std::abs(n[0]) + std::abs(n[1])) + std::abs(n[2]);
  if (!(norm > kFlatShare * moments.area) || norm < 0x1p-400) {
    return principal_axes(m);
  }
  const std::array<double, 3> scaled{n[0] / norm, n[1] / norm, n[2] / norm};
  const double length = std::sqrt(dot(scaled, scaled));
  return flat_axes(m, {scaled[0] / length, scaled[1] / length, scaled[2] / length});
}

}  // namespace soms::layout
