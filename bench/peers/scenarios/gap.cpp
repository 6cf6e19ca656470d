#include "bench/peers/scenarios/gap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::bench {

namespace {

constexpr std::uint32_t kLeaf = 4;

Vec3 middle(const Triangle& t) {
  return (1.0 / 3) * (t.a + t.b + t.c);
}

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

/// Of triangles that do not touch: corner against face, or edge against edge.
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

Triangle moved(const Pose& pose, const Triangle& t) {
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

/// The box about a moved box, to rounding: near misses need no more.
Box moved(const Pose& pose, const Box& box) {
  const Vec3 center = pose.apply(box.center());
  const Vec3 half = 0.5 * box.extent();
  const auto radius = [&](std::size_t row) {
    return std::abs(pose.m[row]) * half.x + std::abs(pose.m[row + 1]) * half.y +
           std::abs(pose.m[row + 2]) * half.z;
  };
  const Vec3 around{radius(0), radius(4), radius(8)};
  return {center - around, center + around};
}

}  // namespace

GapTree::GapTree(const FloatMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    triangles_.push_back(mesh.triangle(i));
  }
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(triangles_.size()), 0});
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const std::uint32_t id = pending.back();
    pending.pop_back();
    split(id, pending);
  }
}

void GapTree::split(std::uint32_t id, std::vector<std::uint32_t>& pending) {
  const std::uint32_t first = nodes_[id].first;
  const std::uint32_t count = nodes_[id].count;
  Box box;
  Box middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    box.grow(bounds(triangles_[i]));
    middles.grow(middle(triangles_[i]));
  }
  nodes_[id].box = box;
  if (count <= kLeaf) {
    return;
  }
  const Vec3 e = middles.extent();
  const std::size_t axis = e.x > e.y ? (e.x > e.z ? 0 : 2) : (e.y > e.z ? 1 : 2);
  const auto begin = triangles_.begin() + first;
  std::nth_element(
      begin, begin + count / 2, begin + count,
      [axis](const Triangle& a, const Triangle& b) { return middle(a)[axis] < middle(b)[axis]; });
  nodes_[id].count = 0;
  nodes_[id].right = static_cast<std::uint32_t>(nodes_.size() + 1);
  nodes_[id].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, first, count / 2, 0});
  nodes_.push_back({{}, first + count / 2, count - count / 2, 0});
  pending.push_back(nodes_[id].first);
  pending.push_back(nodes_[id].right);
}

double GapTree::distance(const GapTree& mover, const Pose& pose, double enough,
                         double too_near) const {
  struct Entry {
    double gap;
    std::uint32_t i;
    std::uint32_t j;
  };

  double best = enough * enough;
  std::vector<Entry> stack{{0, 0, 0}};
  while (!stack.empty() && best >= too_near * too_near) {
    const Entry entry = stack.back();
    stack.pop_back();
    const Node& a = mover.nodes_[entry.i];
    const Node& b = nodes_[entry.j];
    if (entry.gap >= best) {
      continue;
    }
    if (a.count != 0 && b.count != 0) {
      for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
        const Triangle t = moved(pose, mover.triangles_[i]);
        const Box box = bounds(t);
        for (std::uint32_t j = b.first; j < b.first + b.count; ++j) {
          if (squared_gap(box, bounds(triangles_[j])) < best) {
            best = std::min(best, squared_distance(t, triangles_[j]));
          }
        }
      }
      continue;
    }
    const bool split_a = b.count != 0 || (a.count == 0 && volume(a.box) > volume(b.box));
    Entry left = split_a ? Entry{0, a.first, entry.j} : Entry{0, entry.i, b.first};
    Entry right = split_a ? Entry{0, a.right, entry.j} : Entry{0, entry.i, b.right};
    for (Entry* e : {&left, &right}) {
      e->gap = squared_gap(moved(pose, mover.nodes_[e->i].box), nodes_[e->j].box);
    }
    if (left.gap < right.gap) {
      std::swap(left, right);
    }
    stack.push_back(left);
    stack.push_back(right);
  }
  return std::sqrt(best);
}

}  // namespace soms::bench
