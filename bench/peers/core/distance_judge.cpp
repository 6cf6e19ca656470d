#include "bench/peers/core/distance_judge.h"

#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace soms::bench {

namespace {

double squared(const Vec3& v) {
  return dot(v, v);
}

double squared_distance(const Vec3& p, const Triangle& t) {
  const Vec3 u = t.b - t.a;
  const Vec3 v = t.c - t.a;
  const Vec3 w = p - t.a;
  const Vec3 n = cross(u, v);
  const double area = dot(n, n);
  const double s = dot(cross(w, v), n);
  const double r = dot(cross(u, w), n);
  if (area > 0 && s >= 0 && r >= 0 && s + r <= area) {
    const double height = dot(w, n);
    return height * height / area;
  }
  double best = squared(w);
  for (const auto& [from, along] : {std::pair{t.a, u}, {t.a, v}, {t.b, t.c - t.b}}) {
    const double length = squared(along);
    const double at = length > 0 ? std::clamp(dot(p - from, along) / length, 0.0, 1.0) : 0;
    best = std::min(best, squared(p - (from + at * along)));
  }
  return best;
}

/// Least squared distance of two segments from `p` along `u` and from `q` along `v`.
double squared_distance(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 w = p - q;
  const double a = squared(u);
  const double b = dot(u, v);
  const double c = squared(v);
  const double d = dot(u, w);
  const double e = dot(v, w);
  const double determinant = a * c - b * b;
  double s = determinant > 0 ? std::clamp((b * e - c * d) / determinant, 0.0, 1.0) : 0;
  const double t = c > 0 ? std::clamp((b * s + e) / c, 0.0, 1.0) : 0;
  s = a > 0 ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0;
  return squared((p + s * u) - (q + t * v));
}

/// Of triangles that share no point: corner against face, or edge against edge.
double squared_distance(const Triangle& s, const Triangle& t) {
  const std::array<Vec3, 3> p{s.a, s.b, s.c};
  const std::array<Vec3, 3> q{t.a, t.b, t.c};
  double best = squared(s.a - t.a);
  for (std::size_t i = 0; i < 3; ++i) {
    best = std::min({best, squared_distance(p[i], t), squared_distance(q[i], s)});
    for (std::size_t j = 0; j < 3; ++j) {
      best = std::min(best,
                      squared_distance(p[i], p[(i + 1) % 3] - p[i], q[j], q[(j + 1) % 3] - q[j]));
    }
  }
  return best;
}

double squared_gap(const Box& a, const Box& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, a.lower[k] - b.upper[k], b.lower[k] - a.upper[k]});
    sum += gap * gap;
  }
  return sum;
}

/// The least of `best` and the squared distances of the triangles of two bunches.
double least_of(std::span<const Triangle> of_a, std::span<const Triangle> of_b, const Box& box_b,
                double best) {
  for (const Triangle& s : of_a) {
    const Box box = bounds(s);
    if (squared_gap(box, box_b) >= best) {
      continue;
    }
    for (const Triangle& t : of_b) {
      const double gap = squared_gap(box, bounds(t));
      if (gap == 0 && triangles_overlap(s, t)) {
        return 0;
      }
      if (gap < best) {
        best = std::min(best, std::max(squared_distance(s, t), std::numeric_limits<double>::min()));
      }
    }
  }
  return best;
}

}  // namespace

DistanceJudge::DistanceJudge(const FloatMesh& mover, const FloatMesh& fixed)
    : mover_(bunches_of(mover)),
      fixed_(bunches_of(fixed)),
      mover_bounds_(bounds_of(mover_)),
      fixed_bounds_(bounds_of(fixed_)) {
}

double DistanceJudge::distance(const Pose& pose) const {
  struct Pair {
    double gap;
    const Bunch* a;
    const Bunch* b;
  };

  const Bunches moved = placed(mover_, pose);
  std::vector<Pair> pairs;
  pairs.reserve(moved.list.size() * fixed_.list.size());
  for (const Bunch& a : moved.list) {
    for (const Bunch& b : fixed_.list) {
      pairs.push_back({squared_gap(a.box, b.box), &a, &b});
    }
  }
  const auto farther = [](const Pair& p, const Pair& q) { return p.gap > q.gap; };
  std::make_heap(pairs.begin(), pairs.end(), farther);
  double best = std::numeric_limits<double>::infinity();
  while (!pairs.empty() && pairs.front().gap < best) {
    const Bunch& a = *pairs.front().a;
    const Bunch& b = *pairs.front().b;
    best = least_of(moved.of(a), fixed_.of(b), b.box, best);
    std::pop_heap(pairs.begin(), pairs.end(), farther);
    pairs.pop_back();
  }
  return std::sqrt(best);
}

double DistanceJudge::slack(Precision precision, const Pose& pose) const {
  const Vec3 shift = pose.shift();
  // No rotation takes a corner farther from the origin than three of its coordinates are long.
  const double moved = 3 * reach(mover_bounds_) +
                       std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)});
  const double largest = std::max(moved, reach(fixed_bounds_));
  return largest * (precision == Precision::floats ? kSlackOfFloats : kSlackOfDoubles);
}

}  // namespace soms::bench
