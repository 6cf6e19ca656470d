#include "soms/tree/layout/orientation.h"

#include <cmath>

namespace soms::layout {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

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

}  // namespace

Axes principal_axes(std::span<const Vec3> points) {
  Matrix m = covariance(points);
  Matrix axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr int kSweeps = 6;  // it converges quadratically; four are enough for doubles
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    turn(m, axes, 0, 1);
    turn(m, axes, 0, 2);
    turn(m, axes, 1, 2);
  }
  Axes rounded = kMeshAxes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rounded[3 * i + j] = static_cast<float>(axes[i][j]);
    }
  }
  return rounded;
}

}  // namespace soms::layout
