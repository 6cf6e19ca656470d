#include "soms/geometry/detail/plane_cells.h"

#include "soms/geometry/detail/exact_distance.h"
#include "soms/geometry/detail/exact_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

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

/// Where two lines meet. \pre They are not parallel.
PlanePoint meeting(const PlaneForm& a, const PlaneForm& b) {
  PlanePoint p{a.v * b.w - a.w * b.v, a.w * b.u - a.u * b.w, a.u * b.v - a.v * b.u};
  return p.w.sign() < 0 ? PlanePoint{-p.u, -p.v, -p.w} : p;
}

/// A corner of a cell, and the edge from it to the next one.
struct CellCorner {
  PlanePoint at;
  const PlaneForm* line;
  int inner;  // the form's sign inside the cell
};

using Cell = std::vector<CellCorner>;

/// The part of a cell on one side of a line, given the signs of the corners.
Cell part_of(const Cell& cell, const std::vector<int>& signs, const PlaneForm& line, int side) {
  Cell part;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const int here = signs[i] * side;
    const int next = signs[(i + 1) % cell.size()] * side;
    if (here >= 0) {
      part.push_back(cell[i]);
      if (here == 0 && next < 0) {
        part.back().line = &line;
        part.back().inner = side;
      }
    }
    if (here > 0 && next < 0) {
      part.push_back({meeting(*cell[i].line, line), &line, side});
    } else if (here < 0 && next > 0) {
      part.push_back({meeting(*cell[i].line, line), cell[i].line, cell[i].inner});
    }
  }
  return part;
}

/// True if an edge of the cell has the segment on its outer side.
bool is_beside(const PlaneCut& cut, const Cell& cell) {
  return std::any_of(cell.begin(), cell.end(), [&](const CellCorner& corner) {
    return corner.line->sign(cut.from) * corner.inner <= 0 &&
           corner.line->sign(cut.to) * corner.inner <= 0;
  });
}

/// Signs of a cell's corners if the cut's segment passes through its interior, else none.
std::vector<int> signs_if_parted(const PlaneCut& cut, const Cell& cell) {
  std::vector<int> signs;
  bool below = false;
  bool above = false;
  for (const CellCorner& corner : cell) {
    signs.push_back(cut.line.sign(corner.at));
    below = below || signs.back() < 0;
    above = above || signs.back() > 0;
  }
  // A convex set and a segment are apart if an edge of either parts them.
  return below && above && !is_beside(cut, cell) ? signs : std::vector<int>();
}

/// A cell that may still be cut, and where among the cuts to go on.
struct OpenCell {
  Cell cell;
  std::vector<std::uint32_t> cuts;
};

PlanePoint inside_of(const Cell& cell) {
  const PlanePoint& a = cell[0].at;
  const PlanePoint& b = cell[1].at;
  const PlanePoint& c = cell[2].at;
  return {a.u + b.u + c.u, a.v + b.v + c.v, a.w + b.w + c.w};
}

/// Cuts a cell in two, if a cut does, and keeps the first part; nothing left to cut: nothing.
std::optional<OpenCell> cut_off(OpenCell& open, std::span<const PlaneCut> cuts) {
  while (!open.cuts.empty()) {
    const PlaneCut& cut = cuts[open.cuts.back()];
    open.cuts.pop_back();
    const std::vector<int> signs = signs_if_parted(cut, open.cell);
    if (!signs.empty()) {
      OpenCell other{part_of(open.cell, signs, cut.line, -1), open.cuts};
      open.cell = part_of(open.cell, signs, cut.line, 1);
      return other;
    }
  }
  return std::nullopt;
}

double up(double x) {
  return std::nextafter(x, kEndless);
}

double down(double x) {
  return std::nextafter(x, -kEndless);
}

}  // namespace

int PlaneForm::sign(const PlanePoint& p) const {
  return (u * p.u + v * p.v + w * p.w).sign();
}

int PlaneForm::sign_beside(const PlanePoint& p) const {
  const int there = sign(p);
  return there != 0 ? there : u.sign() != 0 ? u.sign() : v.sign();
}

bool PlaneForm::is_zero() const {
  return u.sign() == 0 && v.sign() == 0 && w.sign() == 0;
}

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

bool CellPlane::for_each_cell(std::span<const PlaneCut> cuts,
                              const std::function<bool(const PlanePoint&)>& visit) const {
  std::vector<OpenCell> stack(1);
  for (std::size_t i = 0; i < 3; ++i) {
    stack[0].cell.push_back({own_.corner_[i], &own_.edge_[i], own_.turn_});
  }
  for (std::size_t i = cuts.size(); i-- > 0;) {
    stack[0].cuts.push_back(static_cast<std::uint32_t>(i));
  }
  while (!stack.empty()) {
    OpenCell open = std::move(stack.back());
    stack.pop_back();
    while (std::optional<OpenCell> other = cut_off(open, cuts)) {
      stack.push_back(std::move(*other));
    }
    if (!visit(inside_of(open.cell))) {
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
