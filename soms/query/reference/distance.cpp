#include "soms/query/reference/distance.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/nearest_points.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/detail/moved_triangles.h"
#include "soms/query/reference/detail/rounded_squares.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace soms::reference {

namespace {

using detail::BoxArrays;
using detail::kInfinity;
using detail::kRoundedUp;
using detail::kUnderflown;
using detail::square;
using soms::detail::ExactDistance;
using soms::detail::ExactPair;
using soms::detail::SquaredDistance;

/// Triangles of `a` that are taken together: the unit of work of a thread.
constexpr std::size_t kRows = 16;

/// The nearest pair of some, the least (i, j) of equally near ones; distance 0 has no features.
struct Nearest {
  bool found = false;
  TrianglePair pair;
  ExactDistance distance;

  [[nodiscard]] bool is_zero() const { return found && distance.squared.numerator.sign() == 0; }

  /// Takes a pair that comes after those before it.
  void take(const TrianglePair& next, ExactDistance&& exact) {
    if (!found || compare(exact.squared, distance.squared) < 0) {
      found = true;
      pair = next;
      distance = std::move(exact);
    }
  }
};

ExactDistance decide(const Triangle& a, const Triangle& b) {
  if (triangles_overlap(a, b)) {
    return {};
  }
  return exact_distance(ExactPair(a, b), {});
}

/// Two meshes where their poses have moved them.
struct Scan {
  std::vector<Triangle> a;
  std::vector<Triangle> b;
  BoxArrays boxes;

  Scan(const Body& body_a, const Body& body_b)
      : a(detail::moved_triangles(body_a.shape.mesh(), body_a.pose)),
        b(detail::moved_triangles(body_b.shape.mesh(), body_b.pose)),
        boxes(b) {}

  /// Not below the square of the distance of `a[i]` from all of `b`: the distance of two corners.
  [[nodiscard]] double upper_bound(std::size_t i) const {
    double least = kInfinity;
    for (const Triangle& t : b) {
      least = std::min(least, square(t.a - a[i].a));
    }
    return least * kRoundedUp + kUnderflown;
  }

  /// Not above the square of the distance of the box of a triangle from the box of `b[j]`, but for
  /// rounding.
  [[nodiscard]] double box_gap(const Box& box, std::size_t j) const {
    Vec3 gap;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      gap[axis] = std::max(
          {0.0, boxes.lower[axis][j] - box.upper[axis], box.lower[axis] - boxes.upper[axis][j]});
    }
    return square(gap);
  }

  [[nodiscard]] Nearest scan(std::size_t begin, std::size_t end, double bound, Cost& cost) const {
    Nearest nearest;
    for (std::size_t i = begin; i < end; ++i) {
      const Box box = bounds(a[i]);
      for (std::size_t j = 0; j < b.size() && !nearest.is_zero(); ++j) {
        ++cost.node_tests;
        if (box_gap(box, j) > bound * kRoundedUp + kUnderflown) {
          continue;
        }
        ++cost.triangle_tests;
        ++cost.exact_tests;
        nearest.take({static_cast<TriangleId>(i), static_cast<TriangleId>(j)}, decide(a[i], b[j]));
      }
    }
    return nearest;
  }

  [[nodiscard]] Nearest nearest(const Limits& limits, Cost& cost) const {
    const std::size_t parts = (a.size() + kRows - 1) / kRows;
    std::vector<double> upper(parts, kInfinity);
    for_each_chunk(a.size(), kRows, limits, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        upper[begin / kRows] = std::min(upper[begin / kRows], upper_bound(i));
      }
    });
    const double bound = upper.empty() ? 0 : *std::min_element(upper.begin(), upper.end());
    std::vector<Nearest> found(parts);
    std::vector<Cost> costs(parts);
    for_each_chunk(a.size(), kRows, limits, [&](std::size_t begin, std::size_t end) {
      found[begin / kRows] = scan(begin, end, bound, costs[begin / kRows]);
    });
    Nearest best;
    for (std::size_t part = 0; part < parts; ++part) {
      cost += costs[part];
      if (found[part].found) {
        best.take(found[part].pair, std::move(found[part].distance));
      }
    }
    return best;
  }
};

}  // namespace

Distance distance_by_brute_force(const Body& a, const Body& b, const Limits& limits) {
  const PlainArithmetic plain;
  const Scan scan(a, b);
  Distance answer;
  answer.distance = {kInfinity, kInfinity};
  const Nearest nearest = scan.nearest(limits, answer.cost);
  if (nearest.found) {
    const auto [i, j] = nearest.pair;
    answer.distance = bracket(nearest.distance.squared);
    answer.triangles = nearest.pair;
    const auto points = soms::detail::nearest_points(scan.a[i], scan.b[j]);
    answer.point_a = points[0];
    answer.point_b = points[1];
  }
  return answer;
}

bool within_by_brute_force(const Body& a, const Body& b, double clearance, const Limits& limits) {
  if (!(clearance >= 0)) {
    throw Error(ErrorKind::usage, "within: the clearance is negative or not a number", "");
  }
  const PlainArithmetic plain;
  Cost cost;
  const Nearest nearest = Scan(a, b).nearest(limits, cost);
  return nearest.found && compare(nearest.distance.squared, clearance) <= 0;
}

}  // namespace soms::reference
