#include "soms/geometry/polygon_holes.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/newell.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace soms {

namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

/// Signs that differ, neither zero.
bool opposite(Sign a, Sign b) {
  return a != Sign::zero && b != Sign::zero && a != b;
}

}  // namespace

void HoleJoiner::choose_plane(std::span<const Vec3> outline) {
  const detail::PolygonPlane plane = detail::polygon_plane(outline);
  plane_ = plane.projection;
  first_axis_ = plane.first_axis;
  second_axis_ = plane.second_axis;
  reversed_ = plane.reversed;
}

/// Turn of three corners, positive where it is the way of the normal.
Sign HoleJoiner::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return reversed_ ? orientation2d(corners_[c], corners_[b], corners_[a], plane_)
                   : orientation2d(corners_[a], corners_[b], corners_[c], plane_);
}

bool HoleJoiner::same_place(std::uint32_t a, std::uint32_t b) const {
  return corners_[a][first_axis_] == corners_[b][first_axis_] &&
         corners_[a][second_axis_] == corners_[b][second_axis_];
}

/// The corner of a ring that is farthest along the first axis; of equally far ones along the
/// second.
std::uint32_t HoleJoiner::farthest(std::size_t begin, std::size_t end) const {
  const auto place = [&](std::size_t i) {
    return std::pair(corners_[i][first_axis_], corners_[i][second_axis_]);
  };
  std::size_t best = begin;
  for (std::size_t i = begin + 1; i < end; ++i) {
    best = place(i) > place(best) ? i : best;
  }
  return static_cast<std::uint32_t>(best);
}

/// True if a ring turns the way of the normal: decided where it is farthest out, where every ring
/// without crossings turns the way that it winds.
bool HoleJoiner::winds_with_normal(std::size_t begin, std::size_t end) const {
  const std::uint32_t corner = farthest(begin, end);
  const std::size_t count = end - begin;
  const auto beside = [&](std::size_t step) {
    for (std::size_t k = 1; k < count; ++k) {
      const auto i = static_cast<std::uint32_t>(begin + (corner - begin + k * step) % count);
      if (!same_place(i, corner)) {
        return i;
      }
    }
    return corner;
  };
  return turn(beside(count - 1), corner, beside(1)) == Sign::positive;
}

/// True if the inside of a segment meets an edge, but for an end that the two have in common.
bool HoleJoiner::crosses(std::uint32_t from, std::uint32_t to, std::uint32_t a,
                         std::uint32_t b) const {
  const auto strictly_between = [&](std::uint32_t p) {
    if (same_place(p, from) || same_place(p, to) || turn(from, to, p) != Sign::zero) {
      return false;
    }
    for (const std::size_t axis : {first_axis_, second_axis_}) {
      const double at_from = corners_[from][axis];
      const double at_to = corners_[to][axis];
      if (corners_[p][axis] < std::min(at_from, at_to) ||
          corners_[p][axis] > std::max(at_from, at_to)) {
        return false;
      }
    }
    return true;
  };
  if (strictly_between(a) || strictly_between(b)) {
    return true;
  }
  return opposite(turn(from, to, a), turn(from, to, b)) &&
         opposite(turn(a, b, from), turn(a, b, to));
}

/// True if no edge of the ring or of a hole that is not joined yet lies between two corners.
bool HoleJoiner::sees(std::uint32_t from, std::uint32_t to) const {
  for (std::size_t k = 0; k < ring_.size(); ++k) {
    if (crosses(from, to, ring_[k], ring_[k + 1 == ring_.size() ? 0 : k + 1])) {
      return false;
    }
  }
  for (std::size_t h = joined_; h < holes_.size(); ++h) {
    const Hole& hole = holes_[h];
    for (std::size_t i = hole.begin; i < hole.end; ++i) {
      if (crosses(from, to, static_cast<std::uint32_t>(i),
                  static_cast<std::uint32_t>(i + 1 == hole.end ? hole.begin : i + 1))) {
        return false;
      }
    }
  }
  return true;
}

/// True if the way from a place of the ring to a corner begins inside: left of its edges.
bool HoleJoiner::in_wedge(std::size_t place, std::uint32_t corner) const {
  const std::uint32_t before = ring_[place == 0 ? ring_.size() - 1 : place - 1];
  const std::uint32_t at = ring_[place];
  const std::uint32_t after = ring_[place + 1 == ring_.size() ? 0 : place + 1];
  const bool left_of_first = turn(before, at, corner) == Sign::positive;
  const bool left_of_second = turn(at, after, corner) == Sign::positive;
  switch (turn(before, at, after)) {
    case Sign::positive:
      return left_of_first && left_of_second;
    case Sign::negative:
      return left_of_first || left_of_second;
    case Sign::zero:
      break;
  }
  // Straight on; or back, where a spike ends: from there all but the spike is inside.
  const std::size_t axis =
      corners_[before][first_axis_] != corners_[at][first_axis_] ? first_axis_ : second_axis_;
  const bool back =
      (corners_[before][axis] < corners_[at][axis]) == (corners_[after][axis] < corners_[at][axis]);
  return back ? turn(before, at, corner) != Sign::zero : left_of_first;
}

/// Joins a hole where one of its corners stands at a corner of the ring; false if none does.
bool HoleJoiner::join_at_shared_corner(Hole hole) {
  const std::size_t count = hole.end - hole.begin;
  for (std::size_t place = 0; place < ring_.size(); ++place) {
    for (std::size_t i = hole.begin; i < hole.end; ++i) {
      const auto next = static_cast<std::uint32_t>(hole.begin + (i - hole.begin + 1) % count);
      if (same_place(ring_[place], static_cast<std::uint32_t>(i)) && in_wedge(place, next)) {
        hole.corner = static_cast<std::uint32_t>(i);
        splice(hole, place, true);
        return true;
      }
    }
  }
  return false;
}

/// The place of the ring that a hole is joined to; kNowhere if none sees it.
std::size_t HoleJoiner::bridge_to(const Hole& hole) const {
  const auto distance = [&](std::size_t place) {
    const double x = corners_[ring_[place]][first_axis_] - corners_[hole.corner][first_axis_];
    const double y = corners_[ring_[place]][second_axis_] - corners_[hole.corner][second_axis_];
    return x * x + y * y;
  };
  std::vector<std::pair<double, std::size_t>> nearest;
  nearest.reserve(ring_.size());
  for (std::size_t place = 0; place < ring_.size(); ++place) {
    nearest.emplace_back(distance(place), place);
  }
  std::sort(nearest.begin(), nearest.end());
  for (const auto& [unused, place] : nearest) {
    if (!same_place(ring_[place], hole.corner) && in_wedge(place, hole.corner) &&
        sees(ring_[place], hole.corner)) {
      return place;
    }
  }
  return kNowhere;
}

/// Goes from a place of the ring to the hole, around it against the normal, and back. `shared`: its
/// corner stands at this place, so there is no way to go.
void HoleJoiner::splice(const Hole& hole, std::size_t place, bool shared) {
  const std::size_t count = hole.end - hole.begin;
  const std::size_t step = winds_with_normal(hole.begin, hole.end) ? count - 1 : 1;
  spliced_.assign(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(place) + 1);
  for (std::size_t k = shared ? 1 : 0; k <= count; ++k) {
    spliced_.push_back(
        static_cast<std::uint32_t>(hole.begin + (hole.corner - hole.begin + k * step) % count));
  }
  spliced_.insert(spliced_.end(),
                  ring_.begin() + static_cast<std::ptrdiff_t>(shared ? place + 1 : place),
                  ring_.end());
  ring_.swap(spliced_);
}

std::span<const std::uint32_t> HoleJoiner::join(std::span<const Vec3> corners,
                                                std::span<const std::size_t> ends,
                                                const Limits& limits) {
  const PlainArithmetic plain;
  corners_ = corners;
  left_out_ = 0;
  holes_.clear();
  ring_.resize(ends.empty() ? 0 : ends.front());
  std::iota(ring_.begin(), ring_.end(), 0U);
  if (ends.size() < 2 || ring_.size() < 3) {
    left_out_ = ends.empty() ? 0 : ends.size() - 1;
    return ring_;
  }
  choose_plane(corners.first(ends.front()));
  for (std::size_t h = 1; h < ends.size(); ++h) {
    if (ends[h] - ends[h - 1] < 3) {
      ++left_out_;
    } else {
      holes_.push_back({ends[h - 1], ends[h], farthest(ends[h - 1], ends[h])});
    }
  }
  std::stable_sort(holes_.begin(), holes_.end(), [&](const Hole& a, const Hole& b) {
    return corners_[a.corner][first_axis_] > corners_[b.corner][first_axis_];
  });
  for (joined_ = 0; joined_ < holes_.size(); ++joined_) {
    check(limits);
    if (join_at_shared_corner(holes_[joined_])) {
      continue;
    }
    const std::size_t place = bridge_to(holes_[joined_]);
    if (place == kNowhere) {
      ++left_out_;
    } else {
      splice(holes_[joined_], place, false);
    }
  }
  return ring_;
}

}  // namespace soms
