#include "soms/motion/detail/contact_traversal.h"

#include "soms/motion/detail/leaf_against_box.h"
#include "soms/motion/detail/pair_advance.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Both nodes are descended while neither is more than this much larger.
constexpr double kSimilarSwept = 2;

/// A bow up to this share of both boxes is no reason to halve the time.
constexpr double kBowShare = 0.1;

/// Nor is one that is next to the rounding, nor is a stretch of the way halved that is this short.
constexpr double kBowMargins = 8;
constexpr double kShortest = 0x1p-20;

/// Half the longest side of a lane's box, in units of the layout.
double half_of(const WideNode& node, std::uint32_t lane) {
  return std::max({node.half[0][lane], node.half[1][lane], node.half[2][lane]});
}

/// Lanes of a node that a task means: all, or that of a leaf.
bool means_lane(std::uint32_t id, std::size_t lane) {
  return !is_lane(id) || lane_of(id) == lane;
}

}  // namespace

template <class Source>
ContactTraversal<Source>::ContactTraversal(const MotionBounds& bounds, const Shape& mover,
                                           const Shape& other, ContactGoal& goal)
    : bounds_(bounds),
      mover_(mover),
      resting_(other, bounds.law().resting_pose()),
      goal_(goal),
      x_(mover),
      y_(other),
      unfinished_(kNever) {
  intervals_.emplace_back(bounds, 0.0, 1.0);
  push({0, kRootId, kRootId, 0, 0});
}

template <class Source>
void ContactTraversal<Source>::push(const Task& task) {
  heap_.push_back(task);
  std::push_heap(heap_.begin(), heap_.end(), Later());
}

template <class Source>
bool ContactTraversal<Source>::run(Limit& limit) {
  while (!heap_.empty() && heap_.front().key <= goal_.limit()) {
    if (limit.spend(0)) {
      return false;
    }
    std::pop_heap(heap_.begin(), heap_.end(), Later());
    const Task task = heap_.back();
    heap_.pop_back();
    step(task, limit);
    if (limit.late()) {
      unfinished_ = std::min(unfinished_, task.key);
      return false;
    }
  }
  return true;
}

template <class Source>
double ContactTraversal<Source>::free_until() const {
  double least = unfinished_;
  for (const Task& task : heap_) {
    least = std::min(least, task.key);
  }
  return least;
}

template <class Source>
void ContactTraversal<Source>::step(const Task& task, Limit& limit) {
  if (is_lane(task.x) && is_lane(task.y)) {
    look_at_leaves(task, limit);
    return;
  }
  static_cast<void>(limit.spend(64));
  open(task);
}

template <class Source>
std::uint32_t ContactTraversal<Source>::halves_of(std::uint32_t interval) {
  const MotionInterval whole = intervals_[interval];
  if (whole.halves != MotionInterval::kNone) {
    return whole.halves;
  }
  const auto first = static_cast<std::uint32_t>(intervals_.size());
  intervals_.emplace_back(bounds_, whole.from, whole.middle);
  intervals_.emplace_back(bounds_, whole.middle, whole.to);
  intervals_[interval].halves = first;
  return first;
}

template <class Source>
bool ContactTraversal<Source>::halve(const Task& task, const SweptBoxes& x, std::size_t lane_x,
                                     const SweptBoxes& y, std::size_t lane_y) {
  const MotionInterval& interval = intervals_[task.interval];
  const double give = x.give[lane_x];
  if (give <= kBowShare * (x.radius(lane_x) + y.radius(lane_y)) ||
      give <= kBowMargins * bounds_.box_margin() || interval.to - interval.from <= kShortest) {
    return false;
  }
  // Time is not cut where even the whole of it leaves the boxes apart.
  LaneWindows windows;
  find_windows(x, y, bounds_.box_margin(), windows);
  cost_.node_tests += x.count * y.count;
  if (windows[4 * lane_x + lane_y].empty()) {
    return true;
  }
  const std::uint32_t first = halves_of(task.interval);
  for (std::uint32_t half = first; half < first + 2; ++half) {
    if (task.key <= intervals_[half].to) {
      push({std::max(task.key, intervals_[half].from), task.x, task.y, half, task.depth});
    }
  }
  return true;
}

template <class Source>
void ContactTraversal<Source>::open(const Task& from) {
  Task task = from;
  // Copies: sources may give up what they gave before.
  const WideNode node_x = x_.node(index_of(task.x));
  const WideNode node_y = y_.node(index_of(task.y));
  const WideTree& tree_x = mover_.layout();
  const WideTree& tree_y = resting_.shape.layout();
  const MotionInterval interval = intervals_[task.interval];
  const double size_x = node_x.l1_radius / tree_x.scale();
  const double size_y = node_y.l1_radius / tree_y.scale();
  const bool any_leaf = is_lane(task.x | task.y);
  const bool only_x = !any_leaf && size_x > kSimilarSwept * size_y;
  const bool only_y = !any_leaf && size_y > kSimilarSwept * size_x;
  const SweptBoxes whole_x = swept_boxes(tree_x, node_x, bounds_, interval, true);
  const SweptBoxes whole_y = resting_boxes(tree_y, node_y, resting_.pose, true);
  if (halve(task, whole_x, 0, whole_y, 0)) {
    return;
  }
  if (is_lane(task.y) && half_of(node_y, lane_of(task.y)) / tree_y.scale() > size_x) {
    task.key = std::max(task.key, free_of_box(node_y.child[lane_of(task.y)], whole_x, interval));
  } else if (is_lane(task.x) && half_of(node_x, lane_of(task.x)) / tree_x.scale() > size_y) {
    task.key = std::max(task.key, free_of_box(whole_y, node_x.child[lane_of(task.x)], interval));
  }
  if (task.key > interval.to || task.key > goal_.limit()) {
    return;
  }
  const SweptBoxes x = only_y ? whole_x : swept_boxes(tree_x, node_x, bounds_, interval, false);
  const SweptBoxes y = only_x ? whole_y : resting_boxes(tree_y, node_y, resting_.pose, false);
  LaneWindows windows;
  find_windows(x, y, bounds_.box_margin(), windows);
  cost_.node_tests += x.count * y.count;
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t j = 0; j < y.count; ++j) {
      const TimeWindow& window = windows[4 * i + j];
      if (window.empty() || (!only_y && !means_lane(task.x, i)) ||
          (!only_x && !means_lane(task.y, j))) {
        continue;
      }
      Task child = task;
      child.key = std::max(task.key, interval.begin_of(window));
      ++child.depth;
      if (!only_y && !is_lane(task.x)) {
        child.x = child_id(node_x, task.x, static_cast<std::uint32_t>(i));
      }
      if (!only_x && !is_lane(task.y)) {
        child.y = child_id(node_y, task.y, static_cast<std::uint32_t>(j));
      }
      if (child.key <= goal_.limit() && child.key <= interval.end_of(window)) {
        push(child);
      }
    }
  }
}

template <class Source>
void ContactTraversal<Source>::look_at_leaves(const Task& task, Limit& limit) {
  const WideNode node_x = x_.node(index_of(task.x));
  const WideNode node_y = y_.node(index_of(task.y));
  const MotionInterval interval = intervals_[task.interval];
  const SweptBoxes boxes_x = swept_boxes(mover_.layout(), node_x, bounds_, interval, false);
  const SweptBoxes boxes_y = resting_boxes(resting_.shape.layout(), node_y, resting_.pose, false);
  if (halve(task, boxes_x, lane_of(task.x), boxes_y, lane_of(task.y))) {
    static_cast<void>(limit.spend(16));
    return;
  }
  std::uint32_t token_x = node_x.child[lane_of(task.x)];
  for (bool more_x = true; more_x; token_x = x_.next(token_x)) {
    const TriangleBlock block_x = x_.block(token_x);
    more_x = block_x.following != 0;
    std::uint32_t token_y = node_y.child[lane_of(task.y)];
    for (bool more_y = true; more_y; token_y = y_.next(token_y)) {
      const TriangleBlock block_y = y_.block(token_y);
      more_y = block_y.following != 0;
      look_at_blocks(block_x, block_y,
                     {interval, boxes_x, lane_of(task.x), boxes_y, lane_of(task.y), task.key});
      if (limit.spend(256)) {
        return;
      }
    }
  }
}

template <class Source>
void ContactTraversal<Source>::look_at_blocks(const TriangleBlock& x, const TriangleBlock& y,
                                              const LeafPair& leaves) {
  const double margin = bounds_.box_margin();
  swept_.clear();
  swept_ids_.clear();
  meetings_.clear();
  cost_.node_tests += x.count + y.count;
  for (std::size_t i = 0; i < x.count; ++i) {
    const SweptTriangle moving =
        swept_triangle(mover_.mesh().triangle(x.id[i]), bounds_, leaves.interval);
    if (!window_of(moving, leaves.y, leaves.lane_y, margin).empty()) {
      swept_.push_back(moving);
      swept_ids_.push_back(x.id[i]);
    }
  }
  for (std::size_t j = 0; j < y.count && !swept_.empty(); ++j) {
    const Corners resting = corners_of(moved_triangle(resting_, y.id[j]));
    if (window_of(leaves.x, leaves.lane_x, resting, margin).empty()) {
      continue;
    }
    const TriangleSides sides = sides_of(resting);
    for (std::uint32_t i = 0; i < swept_.size(); ++i) {
      const TimeWindow window = window_of(swept_[i], resting, sides, margin);
      ++cost_.triangle_tests;
      const double from = std::max(leaves.key, leaves.interval.begin_of(window));
      if (!window.empty() && from <= goal_.limit()) {
        meetings_.push_back(
            {from, std::max(from, leaves.interval.end_of(window)), i, swept_ids_[i], y.id[j]});
      }
    }
  }
  advance_meetings();
}

template <class Source>
void ContactTraversal<Source>::advance_meetings() {
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
    return a.from != b.from ? a.from < b.from
                            : std::pair(a.id_x, a.id_y) < std::pair(b.id_x, b.id_y);
  });
  for (const Meeting& meeting : meetings_) {
    if (meeting.from <= goal_.limit()) {
      PairAdvance(bounds_, mover_, resting_, {meeting.id_x, meeting.id_y}, goal_, cost_)
          .run(meeting.from, meeting.until);
    }
  }
}

template <class Source>
double ContactTraversal<Source>::free_of_box(std::uint32_t token, const SweptBoxes& x,
                                             const MotionInterval& interval) {
  double first = kNever;
  for (;; token = y_.next(token)) {
    const TriangleBlock& block = y_.block(token);
    cost_.node_tests += block.count;
    for (std::size_t j = 0; j < block.count; ++j) {
      const Corners resting = corners_of(moved_triangle(resting_, block.id[j]));
      const TimeWindow window = window_of(x, 0, resting, bounds_.box_margin());
      first = window.empty() ? first : std::min(first, interval.begin_of(window));
    }
    if (block.following == 0) {
      return first;
    }
  }
}

template <class Source>
double ContactTraversal<Source>::free_of_box(const SweptBoxes& y, std::uint32_t token,
                                             const MotionInterval& interval) {
  double first = kNever;
  for (;; token = x_.next(token)) {
    const TriangleBlock& block = x_.block(token);
    cost_.node_tests += block.count;
    for (std::size_t i = 0; i < block.count; ++i) {
      const SweptTriangle moving =
          swept_triangle(mover_.mesh().triangle(block.id[i]), bounds_, interval);
      const TimeWindow window = window_of(moving, y, 0, bounds_.box_margin());
      first = window.empty() ? first : std::min(first, interval.begin_of(window));
    }
    if (block.following == 0) {
      return first;
    }
  }
}

template class ContactTraversal<WideSource>;
template class ContactTraversal<CompactSource>;

}  // namespace soms::detail
