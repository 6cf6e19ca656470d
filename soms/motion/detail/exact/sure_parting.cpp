#include "soms/motion/detail/exact/sure_parting.h"

#include "soms/geometry/detail/exact/double_double3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::detail {

namespace {

/// What coefficients are off, of N S.
constexpr double kOff = 0x1p-86;
constexpr double kUnderflow = 0x1p-800;
constexpr double kLargest = 0x1p200;

/// A stretch is halved so often at most.
constexpr int kPartingHalvings = 4;

using DoubleDouble4 = std::array<DoubleDouble, 4>;

/// Quaternion and place of the pivot, at a time.
struct Moment {
  DoubleDouble w;
  DoubleDouble3 u;
  DoubleDouble3 place;
};

DoubleDouble between(double from, double to, double t) {
  return from + two_sum(to, -from) * t;
}

Moment moment_at(const RigidMotion& motion, double t) {
  const auto& q0 = motion.from();
  const auto& q1 = motion.to();
  const Vec3& from = motion.pivot_from();
  const Vec3& to = motion.pivot_to();
  return {between(q0[0], q1[0], t),
          {between(q0[1], q1[1], t), between(q0[2], q1[2], t), between(q0[3], q1[3], t)},
          {between(from.x, to.x, t), between(from.y, to.y, t), between(from.z, to.z, t)}};
}

/// The bilinear form of |q|^2.
DoubleDouble squared(const Moment& p, const Moment& q) {
  return p.w * q.w + dot(p.u, q.u);
}

/// That of M(q) v: of (w^2 - u.u) v + 2 (u.v) u + 2 w (u x v).
DoubleDouble3 turned(const Moment& p, const Moment& q, const DoubleDouble3& v) {
  const DoubleDouble along = p.w * q.w - dot(p.u, q.u);
  const DoubleDouble to_p = dot(q.u, v);
  const DoubleDouble to_q = dot(p.u, v);
  const DoubleDouble3 by_p = cross(p.u, v);
  const DoubleDouble3 by_q = cross(q.u, v);
  DoubleDouble3 sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = (along * v[k] + (to_p * p.u[k] + to_q * q.u[k])) + (p.w * by_q[k] + q.w * by_p[k]);
  }
  return sum;
}

Vec3 rounded(const DoubleDouble3& v) {
  return {v[0].high, v[1].high, v[2].high};
}

double greatest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// From the resting triangle to the other.
struct Direction {
  DoubleDouble3 n{};
  double gap = -std::numeric_limits<double>::infinity();  ///< in the middle, rounded
};

class PartingCheck {
 public:
  PartingCheck(const RigidMotion& motion, const Triangle& moving, const Triangle& resting)
      : motion_(motion), world_{resting.a, resting.b, resting.c} {
    const std::array<Vec3, 3> corners{moving.a, moving.b, moving.c};
    for (std::size_t k = 0; k < 3; ++k) {
      arms_[k] = difference(corners[k], motion.pivot());
      edges_[k] = difference(corners[(k + 1) % 3], corners[k]);
      world_edges_[k] = difference(world_[(k + 1) % 3], world_[k]);
      arm_ = std::max(arm_, greatest(rounded(arms_[k])));
      reach_ = std::max(reach_, greatest(world_[k]));
    }
    size_ = (std::max(greatest(motion.pivot_from()), greatest(motion.pivot_to())) + reach_ + arm_) *
            (1 + 0x1p-40);
  }

  [[nodiscard]] bool parted(double from, double until, int depth) const {
    if (!(size_ <= kLargest)) {
      return false;
    }
    const double middle = from + (until - from) / 2;
    const Direction best = best_at(moment_at(motion_, middle));
    if (!(best.gap > 0)) {
      return false;
    }
    if (is_parting(best, moment_at(motion_, from), moment_at(motion_, until))) {
      return true;
    }
    return depth > 0 && middle > from && middle < until && parted(from, middle, depth - 1) &&
           parted(middle, until, depth - 1);
  }

 private:
  [[nodiscard]] Direction best_at(const Moment& now) const {
    std::array<DoubleDouble3, 3> turned_edges;
    std::array<Vec3, 3> corners;
    const double square = squared(now, now).high;
    for (std::size_t k = 0; k < 3; ++k) {
      turned_edges[k] = turned(now, now, edges_[k]);
      corners[k] = rounded(now.place) + rounded(turned(now, now, arms_[k])) * (1 / square);
    }
    Direction best;
    const auto look = [&](const DoubleDouble3& a, const DoubleDouble3& b) {
      const Direction next = gap_along(cross(a, b), corners);
      if (next.gap > best.gap) {
        best = next;
      }
    };
    look(world_edges_[0], world_edges_[1]);
    look(turned_edges[0], turned_edges[1]);
    for (const DoubleDouble3& a : turned_edges) {
      for (const DoubleDouble3& b : world_edges_) {
        look(a, b);
      }
    }
    return best;
  }

  [[nodiscard]] Direction gap_along(const DoubleDouble3& n,
                                    const std::array<Vec3, 3>& corners) const {
    const Vec3 axis = rounded(n);
    const double length = std::sqrt(dot(axis, axis));
    if (!(length > 0)) {
      return {};
    }
    std::array<double, 3> x{};
    std::array<double, 3> y{};
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = dot(axis, corners[k] - world_[0]);
      y[k] = dot(axis, world_[k] - world_[0]);
    }
    const auto [x_least, x_most] = std::minmax_element(x.begin(), x.end());
    const auto [y_least, y_most] = std::minmax_element(y.begin(), y.end());
    const double up = *x_least - *y_most;
    const double down = *y_least - *x_most;
    return up >= down ? Direction{n, up / length} : Direction{{-n[0], -n[1], -n[2]}, down / length};
  }

  /// Coefficients in Bernstein's form, the inner ones three times theirs.
  [[nodiscard]] bool is_parting(const Direction& direction, const Moment& begin,
                                const Moment& end) const {
    const Vec3 rough = rounded(direction.n);
    const double off =
        kOff * (std::abs(rough.x) + std::abs(rough.y) + std::abs(rough.z)) * size_ + kUnderflow;
    const std::array<DoubleDouble, 3> squares{squared(begin, begin), squared(begin, end),
                                              squared(end, end)};
    const DoubleDouble3& n = direction.n;
    const DoubleDouble first = dot(n, begin.place);
    const DoubleDouble last = dot(n, end.place);
    for (const DoubleDouble3& arm : arms_) {
      const std::array<DoubleDouble, 3> turns{dot(n, turned(begin, begin, arm)),
                                              dot(n, turned(begin, end, arm)),
                                              dot(n, turned(end, end, arm))};
      for (const Vec3& corner : world_) {
        const DoubleDouble level = dot(n, {corner.x, corner.y, corner.z});
        const DoubleDouble a = first - level;
        const DoubleDouble b = last - level;
        const DoubleDouble4 coefficients{
            a * squares[0] + turns[0],
            (b * squares[0] + 2.0 * (a * squares[1])) + (turns[0] + 2.0 * turns[1]),
            (2.0 * (b * squares[1]) + a * squares[2]) + (2.0 * turns[1] + turns[2]),
            b * squares[2] + turns[2]};
        if (!std::all_of(coefficients.begin(), coefficients.end(),
                         [&](const DoubleDouble& c) { return c.high > 2 * off; })) {
          return false;
        }
      }
    }
    return true;
  }

  const RigidMotion& motion_;
  std::array<Vec3, 3> world_;
  std::array<DoubleDouble3, 3> arms_;  ///< a - c
  std::array<DoubleDouble3, 3> edges_;
  std::array<DoubleDouble3, 3> world_edges_;
  double arm_ = 0;
  double reach_ = 0;
  double size_ = 0;  ///< S
};

}  // namespace

bool surely_parted(const RigidMotion& motion, const Triangle& moving, const Triangle& resting,
                   double from, double until) {
  return PartingCheck(motion, moving, resting).parted(from, until, kPartingHalvings);
}

}  // namespace soms::detail
