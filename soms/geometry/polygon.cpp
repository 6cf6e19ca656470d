#include "soms/geometry/polygon.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/newell.h"

#include <algorithm>
#include <numeric>

namespace soms {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
/// Large outlines take long; a request to stop is looked at once in so many ears.
constexpr std::uint32_t kClipsPerCheck = 64;
/// Nor may the search for one ear look at all corners for each: so many are tried between checks.
constexpr std::uint32_t kCornersPerCheck = 64;

}  // namespace

void PolygonTriangulator::choose_plane() {
  const detail::PolygonPlane plane = detail::polygon_plane(corners_);
  plane_ = plane.projection;
  first_axis_ = plane.first_axis;
  second_axis_ = plane.second_axis;
  reversed_ = plane.reversed;
}

/// Turn of three corners, positive where it is the way of the normal.
Sign PolygonTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return reversed_ ? orientation2d(corners_[c], corners_[b], corners_[a], plane_)
                   : orientation2d(corners_[a], corners_[b], corners_[c], plane_);
}

bool PolygonTriangulator::is_fan() const {
  bool positive = false;
  bool negative = false;
  const auto n = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t i = 1; i + 1 < n && !(positive && negative); ++i) {
    const Sign sign = turn(0, i, i + 1);
    positive = positive || sign == Sign::positive;
    negative = negative || sign == Sign::negative;
  }
  return !(positive && negative);
}

/// True if two corners stand at one place of the plane.
bool PolygonTriangulator::same_place(std::uint32_t a, std::uint32_t b) const {
  return corners_[a][first_axis_] == corners_[b][first_axis_] &&
         corners_[a][second_axis_] == corners_[b][second_axis_];
}

/// True if a side of `corner`, which stands where `ear` does, leads into the angle of `ear`, or if
/// its sides are those of `ear` the other way: there is nothing between them.
bool PolygonTriangulator::leads_into(std::uint32_t corner, std::uint32_t ear) const {
  const Link& link = ring_[ear];
  const auto is_inside = [&](std::uint32_t other) {
    return turn(link.previous, ear, other) == Sign::positive &&
           turn(ear, link.next, other) == Sign::positive;
  };
  const Link& other = ring_[corner];
  return is_inside(other.previous) || is_inside(other.next) ||
         (same_place(other.previous, link.next) && same_place(other.next, link.previous));
}

/// True if `corner` lies in the closed triangle of `ear`, at none of its three positions, or at the
/// ear's with a side that leads in.
bool PolygonTriangulator::blocks(std::uint32_t corner, std::uint32_t ear) const {
  const Link& link = ring_[ear];
  if (corner == ear || corner == link.previous || corner == link.next) {
    return false;
  }
  const std::array<std::uint32_t, 3> t = {link.previous, ear, link.next};
  const Vec3& p = corners_[corner];
  for (const std::size_t axis : {first_axis_, second_axis_}) {
    const double a = corners_[t[0]][axis];
    const double b = corners_[t[1]][axis];
    const double c = corners_[t[2]][axis];
    if (p[axis] < std::min({a, b, c}) || p[axis] > std::max({a, b, c})) {
      return false;
    }
  }
  for (const std::uint32_t i : t) {
    if (same_place(corner, i)) {
      return i == ear && leads_into(corner, ear);
    }
  }
  return turn(t[0], t[1], corner) != Sign::negative && turn(t[1], t[2], corner) != Sign::negative &&
         turn(t[2], t[0], corner) != Sign::negative;
}

void PolygonTriangulator::measure(std::uint32_t ear) {
  Link& link = ring_[ear];
  link.turn = turn(link.previous, ear, link.next);
  const double least = std::min({corners_[link.previous][first_axis_], corners_[ear][first_axis_],
                                 corners_[link.next][first_axis_]});
  const auto first = std::lower_bound(
      order_.begin(), order_.end(), least,
      [&](std::uint32_t i, double value) { return corners_[i][first_axis_] < value; });
  link.cursor = static_cast<std::uint32_t>(first - order_.begin());
}

/// Looks for a corner that blocks, from where the last search for the same triangle stopped: what
/// did not block does not begin to, so each triangle looks at each corner once.
bool PolygonTriangulator::is_ear(std::uint32_t corner) {
  Link& link = ring_[corner];
  if (link.turn != Sign::positive) {
    return false;
  }
  const double most = std::max({corners_[link.previous][first_axis_], corners_[corner][first_axis_],
                                corners_[link.next][first_axis_]});
  for (; link.cursor < order_.size(); ++link.cursor) {
    const std::uint32_t other = order_[link.cursor];
    if (corners_[other][first_axis_] > most) {
      break;
    }
    if (!ring_[other].clipped && blocks(other, corner)) {
      return false;
    }
  }
  return true;
}

void PolygonTriangulator::clip(std::uint32_t ear) {
  const std::uint32_t previous = ring_[ear].previous;
  const std::uint32_t next = ring_[ear].next;
  triangles_.push_back({previous, ear, next});
  ring_[previous].next = next;
  ring_[next].previous = previous;
  ring_[ear].clipped = true;
  --left_;
  measure(previous);
  measure(next);
}

/// The first ear of the ring from `start` on, or kNone.
std::uint32_t PolygonTriangulator::find_ear(std::uint32_t start, const Limits& limits) {
  std::uint32_t i = start;
  std::uint32_t tried = 0;
  do {
    if (++tried % kCornersPerCheck == 0) {
      check(limits);
    }
    if (is_ear(i)) {
      return i;
    }
    i = ring_[i].next;
  } while (i != start);
  return kNone;
}

/// The first corner without turn of the ring from `start` on, or kNone.
std::uint32_t PolygonTriangulator::find_straight(std::uint32_t start) const {
  std::uint32_t i = start;
  do {
    if (ring_[i].turn == Sign::zero) {
      return i;
    }
    i = ring_[i].next;
  } while (i != start);
  return kNone;
}

void PolygonTriangulator::clip_ears(const Limits& limits) {
  const auto n = static_cast<std::uint32_t>(corners_.size());
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0U);
  std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return corners_[a][first_axis_] < corners_[b][first_axis_];
  });
  ring_.assign(n, {});
  for (std::uint32_t i = 0; i < n; ++i) {
    ring_[i].previous = i == 0 ? n - 1 : i - 1;
    ring_[i].next = i + 1 == n ? 0 : i + 1;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    measure(i);
  }
  left_ = n;
  std::uint32_t start = 0;
  while (left_ > 3) {
    if (left_ % kClipsPerCheck == 0) {
      check(limits);
    }
    std::uint32_t ear = find_ear(start, limits);
    if (ear == kNone) {
      ear = find_straight(start);
    }
    if (ear == kNone) {
      break;
    }
    start = ring_[ear].next;
    clip(ear);
  }
  std::uint32_t first = 0;
  while (ring_[first].clipped) {
    ++first;
  }
  const std::uint32_t last = ring_[first].previous;
  for (std::uint32_t i = ring_[first].next; i != last; i = ring_[i].next) {
    triangles_.push_back({first, i, ring_[i].next});
  }
}

std::span<const std::array<std::uint32_t, 3>> PolygonTriangulator::triangulate(
    std::span<const Vec3> corners, const Limits& limits) {
  const PlainArithmetic plain;
  corners_ = corners;
  triangles_.clear();
  if (corners.size() < 3) {
    return {};
  }
  if (corners.size() == 3) {
    triangles_.push_back({0, 1, 2});
    return triangles_;
  }
  choose_plane();
  if (is_fan()) {
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) {
      triangles_.push_back({0, i, i + 1});
    }
  } else {
    clip_ears(limits);
  }
  return triangles_;
}

}  // namespace soms
