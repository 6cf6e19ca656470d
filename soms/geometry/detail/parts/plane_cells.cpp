#include "soms/geometry/detail/parts/plane_cells.h"

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/parts/cell_boxes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace soms::detail {

namespace {

/// So few cuts are tried all on all cells.
constexpr std::size_t kFewCuts = 16;

constexpr double kEndless = std::numeric_limits<double>::infinity();

const Integer& entry(const IntegerVec& v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

bool is_zero_vector(const IntegerVec& v) {
  return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0;
}

Integer with_sign(const Integer& value, int sign) {
  return sign < 0 ? -value : value;
}

/// The plane of the other two coordinates than `axis`, in order.
Projection across(std::size_t axis) {
  return axis == 0 ? Projection::yz : axis == 1 ? Projection::zx : Projection::xy;
}

/// A point without one coordinate.
struct FlatPoint {
  double u;
  double v;
};

/// Sign of `orientation2d` where its filter suffices, else 0.
int certain_turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  const double left = (b.u - a.u) * (c.v - a.v);
  const double right = (b.v - a.v) * (c.u - a.u);
  const double det = left - right;
  const double bound = kBound2d * (std::abs(left) + std::abs(right)) + kUnderflow;
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

double up(double x) {
  return std::nextafter(x, kEndless);
}

double down(double x) {
  return std::nextafter(x, -kEndless);
}

}  // namespace

PlanePoint SeenTriangle::crossing(std::size_t i) const {
  const std::size_t j = (i + 1) % 3;
  const int sign = height_[i].sign();  // that of j is the opposite one
  const Integer from = with_sign(height_[i], sign);
  const Integer to = with_sign(height_[j], -sign);
  const PlanePoint& p = corner_[i];
  const PlanePoint& q = corner_[j];
  return {to * p.u + from * q.u, to * p.v + from * q.v, (from + to) * p.w};
}

void SeenTriangle::append_cuts(std::vector<PlaneCut>& cuts) const {
  if (flat_) {
    return;
  }
  if (coplanar()) {
    for (std::size_t i = 0; i < 3; ++i) {
      cuts.push_back({edge_[i], corner_[i], corner_[(i + 1) % 3]});
    }
    return;
  }
  std::vector<PlanePoint> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    if (height_[i].sign() == 0) {
      ends.push_back(corner_[i]);
    } else if (height_[i].sign() * height_[(i + 1) % 3].sign() < 0) {
      ends.push_back(crossing(i));
    }
  }
  if (ends.size() == 2) {
    cuts.push_back({side_, std::move(ends[0]), std::move(ends[1])});
  }
}

bool SeenTriangle::covers(const PlanePoint& p) const {
  return edge_[0].sign_beside(p) == turn_ && edge_[1].sign_beside(p) == turn_ &&
         edge_[2].sign_beside(p) == turn_;
}

bool SeenTriangle::is_above(const PlanePoint& p) const {
  // The side of s on which the point lies is that of its normal, times the normal's sense along k,
  // where the point is above s.
  return turn_ != 0 && side_.sign_beside(p) == -turn_ && covers(p);
}

CellPlane::CellPlane(const Triangle& t, std::size_t axis)
    : triangle_(t), axis_(axis), exponent_(ExactPair(t, t).exponent()), own_(seen(t)) {
}

std::optional<CellPlane> CellPlane::of(const Triangle& t, View view) {
  const ExactPair pair(t, t);
  const IntegerVec n = cross(pair.at(0, 1) - pair.at(0, 0), pair.at(0, 2) - pair.at(0, 0));
  if (is_zero_vector(n)) {
    return std::nullopt;
  }
  std::optional<std::size_t> axis;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer size = with_sign(entry(n, k), entry(n, k).sign());
    if (size.sign() == 0) {
      continue;
    }
    const bool better = !axis || ((with_sign(entry(n, *axis), entry(n, *axis).sign()) < size) ==
                                  (view == View::steep));
    axis = better ? k : *axis;
  }
  return CellPlane(t, *axis);
}

SeenTriangle CellPlane::seen(const Triangle& s) const {
  const ExactPair pair(triangle_, s);
  const std::size_t ku = (axis_ + 1) % 3;
  const std::size_t kv = (axis_ + 2) % 3;
  const IntegerVec& origin = pair.at(0, 0);
  const IntegerVec n = cross(pair.at(0, 1) - origin, pair.at(0, 2) - origin);
  const std::array<IntegerVec, 3> q{pair.at(1, 0) - origin, pair.at(1, 1) - origin,
                                    pair.at(1, 2) - origin};
  const IntegerVec m = cross(q[1] - q[0], q[2] - q[0]);
  SeenTriangle seen;
  seen.flat_ = is_zero_vector(m);
  seen.turn_ = entry(m, axis_).sign();
  // Both grids are powers of two; that of the pair is the finer one.
  const auto shift = static_cast<std::size_t>(exponent_ - pair.exponent());
  const int sense = entry(n, axis_).sign();
  const Integer& nk = entry(n, axis_);
  const Integer& mk = entry(m, axis_);
  // m (x - q) with x_k = -(n_u x_u + n_v x_v) / n_k, times |n_k|.
  seen.side_ = {
      with_sign(nk * entry(m, ku) - mk * entry(n, ku), sense) << shift,
      with_sign(nk * entry(m, kv) - mk * entry(n, kv), sense) << shift,
      with_sign(nk * dot(m, q[0]), -sense),
  };
  const Integer unit(1, shift);
  for (std::size_t i = 0; i < 3; ++i) {
    const IntegerVec& p = q[i];
    const IntegerVec e = q[(i + 1) % 3] - p;
    seen.edge_[i] = {(-entry(e, kv)) << shift, entry(e, ku) << shift,
                     entry(e, kv) * entry(p, ku) - entry(e, ku) * entry(p, kv)};
    seen.corner_[i] = {entry(p, ku), entry(p, kv), unit};
    seen.height_[i] = dot(n, p);
  }
  return seen;
}

Cell CellPlane::whole() const {
  Cell cell;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.push_back({own_.corner_[i], &own_.edge_[i], own_.turn_});
  }
  return cell;
}

bool CellPlane::for_each_cell(std::span<const PlaneCut> cuts, const CellVisit& visit) const {
  std::vector<std::uint32_t> all(cuts.size());
  std::iota(all.rbegin(), all.rend(), 0U);
  return for_each_part(whole(), cuts, std::move(all), visit);
}

bool CellPlane::for_each_cell_in_boxes(std::span<const PlaneCut> cuts,
                                       const CellVisit& visit) const {
  return cuts.size() <= kFewCuts ? for_each_cell(cuts, visit)
                                 : CellBoxes(cuts, exponent_).for_each_part(whole(), visit);
}

PlaneCut CellPlane::cut_between(const Vec3& p, const Vec3& q) const {
  SeenTriangle edge = seen({p, q, q});
  return {std::move(edge.edge_[0]), std::move(edge.corner_[0]), std::move(edge.corner_[1])};
}

bool CellPlane::may_part(const Vec3& p, const Vec3& q, Predicates& predicates) const {
  const Projection plane = across(axis_);
  const std::array<Vec3, 3> corners{triangle_.a, triangle_.b, triangle_.c};
  bool above = false;
  bool below = false;
  for (const Vec3& corner : corners) {
    const Sign sign = predicates.orientation2d(p, q, corner, plane);
    above = above || sign == Sign::positive;
    below = below || sign == Sign::negative;
  }
  if (!above || !below) {
    return false;
  }
  const Sign inner = own_.turn_ > 0 ? Sign::positive : Sign::negative;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    if (predicates.orientation2d(a, b, p, plane) != inner &&
        predicates.orientation2d(a, b, q, plane) != inner) {
      return false;
    }
  }
  return true;
}

bool CellPlane::may_cover(const Triangle& s, const Box& ray) const {
  const std::size_t ku = (axis_ + 1) % 3;
  const std::size_t kv = (axis_ + 2) % 3;
  const std::array<FlatPoint, 3> p{FlatPoint{s.a[ku], s.a[kv]}, FlatPoint{s.b[ku], s.b[kv]},
                                   FlatPoint{s.c[ku], s.c[kv]}};
  const int turn = certain_turn(p[0], p[1], p[2]);
  for (std::size_t i = 0; i < 3 && turn != 0; ++i) {
    const FlatPoint& a = turn > 0 ? p[i] : p[(i + 1) % 3];
    const FlatPoint& b = turn > 0 ? p[(i + 1) % 3] : p[i];
    // Of the box, the corner that is farthest to the left.
    const FlatPoint corner{b.v > a.v ? ray.lower[ku] : ray.upper[ku],
                           b.u > a.u ? ray.upper[kv] : ray.lower[kv]};
    if (certain_turn(a, b, corner) < 0) {
      return false;
    }
  }
  return true;
}

bool CellPlane::has_below(const Triangle& s, Predicates& predicates) const {
  const Sign above = own_.turn_ > 0 ? Sign::positive : Sign::negative;
  const auto& [a, b, c] = triangle_;
  return predicates.orientation(a, b, c, s.a) != above &&
         predicates.orientation(a, b, c, s.b) != above &&
         predicates.orientation(a, b, c, s.c) != above;
}

Box CellPlane::ray_box(const PlanePoint& p) const {
  Box box = bounds(triangle_);
  box.upper[axis_] = kEndless;
  const auto narrow = [&](std::size_t axis, const Integer& above) {
    // Both the quotient and the sum are rounded to nearest.
    const double offset = nearest_double(above, p.w, exponent_);
    box.lower[axis] = down(triangle_.a[axis] + down(offset));
    box.upper[axis] = up(triangle_.a[axis] + up(offset));
  };
  narrow((axis_ + 1) % 3, p.u);
  narrow((axis_ + 2) % 3, p.v);
  return box;
}

}  // namespace soms::detail
