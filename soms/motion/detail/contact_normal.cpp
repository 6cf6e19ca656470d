#include "soms/motion/detail/contact_normal.h"

#include "soms/motion/detail/motion_interval.h"

#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// Shares of a face or an edge that count as its border.
constexpr double kBorder = 0x1p-20;

/// Products of directions below this are of parallel ones.
constexpr double kFlat = 0x1p-20;

/// Where the features of two triangles meet.
class FeatureSearch {
 public:
  FeatureSearch(const Corners& x, const Corners& y, double reach) : x_(x), y_(y), reach_(reach) {
    for (const Vec3& corner : x) {
      look_at_face(y, corner);
    }
    for (const Vec3& corner : y) {
      look_at_face(x, corner);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        look_at_edges(i, j);
      }
    }
  }

  /// The direction of the one meeting; zero where there is none, or another.
  [[nodiscard]] Vec3 found() const { return count_ == 1 ? direction_ : Vec3{}; }

 private:
  void look_at_face(const Corners& face, const Vec3& corner) {
    const Vec3 u = face[1] - face[0];
    const Vec3 v = face[2] - face[0];
    const Vec3 n = direction_of(cross(direction_of(u), direction_of(v)));
    const Vec3 w = corner - face[0];
    if (!(std::abs(dot(n, w)) <= reach_)) {
      return;
    }
    const double area = dot(n, cross(u, v));
    const double s = dot(n, cross(w, v)) / area;
    const double t = dot(n, cross(u, w)) / area;
    if (s > kBorder && t > kBorder && s + t < 1 - kBorder) {
      take(n);
    }
  }

  void look_at_edges(std::size_t i, std::size_t j) {
    const Vec3 e = x_[(i + 1) % 3] - x_[i];
    const Vec3 f = y_[(j + 1) % 3] - y_[j];
    const Vec3 across = cross(direction_of(e), direction_of(f));
    if (!(dot(across, across) > kFlat * kFlat)) {
      return;
    }
    const Vec3 n = direction_of(across);
    const Vec3 r = y_[j] - x_[i];
    if (!(std::abs(dot(n, r)) <= reach_)) {
      return;
    }
    // x[i] + s e and y[j] + t f are nearest to each other.
    const double area = dot(n, cross(e, f));
    const double s = dot(n, cross(r, f)) / area;
    const double t = dot(n, cross(r, e)) / area;
    if (s > kBorder && s < 1 - kBorder && t > kBorder && t < 1 - kBorder) {
      take(n);
    }
  }

  void take(const Vec3& n) {
    direction_ = n;
    ++count_;
  }

  const Corners& x_;
  const Corners& y_;
  double reach_;
  Vec3 direction_;
  int count_ = 0;
};

}  // namespace

std::optional<Vec3> contact_normal(const Corners& x, const Corners& y, double reach,
                                   const Corners& before) {
  const Vec3 n = FeatureSearch(x, y, reach).found();
  if (n == Vec3{}) {
    return std::nullopt;
  }
  return parted_along(n, before, y).direction;
}

}  // namespace soms::detail
