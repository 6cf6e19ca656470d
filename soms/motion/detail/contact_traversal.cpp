#include "soms/motion/detail/contact_traversal.h"

#include "soms/motion/detail/pair_advance.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Both nodes are descended while neither is more than this much larger.
constexpr double kSimilarSwept = 2;

/// A bow up to this share of both boxes is no reason to halve the time.
constexpr double kBowShare = 0.03;

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

/// Takes the top of a heap.
template <class Order, class Item>
Item popped(std::vector<Item>& heap) {
  std::pop_heap(heap.begin(), heap.end(), Order());
  const Item item = heap.back();
  heap.pop_back();
  return item;
}

}  // namespace

template <class Source>
ContactTraversal<Source>::ContactTraversal(const MotionBounds& bounds, const Shape& mover,
                                           const Shape& other, std::span<const std::uint32_t> nodes,
                                           ContactGoal& goal)
    : bounds_(bounds),
      mover_(mover),
      resting_(other, bounds.law().resting_pose()),
      goal_(goal),
      x_(mover),
      y_(other),
      kernels_(motion_kernels()),
      unfinished_(kNever) {
  intervals_.emplace_back(bounds, 0.0, 1.0);
  for (const std::uint32_t node : nodes) {
    push({0, kRootId, node, 0, 0});
  }
}

template <class Source>
void ContactTraversal<Source>::push(const Task& task) {
  heap_.push_back(task);
  std::push_heap(heap_.begin(), heap_.end(), Later());
}

template <class Source>
bool ContactTraversal<Source>::meeting_is_next() const {
  return !meetings_.empty() && (heap_.empty() || meetings_.front().key <= heap_.front().key);
}

template <class Source>
bool ContactTraversal<Source>::run(Limit& limit) {
  while (free_until() <= goal_.limit() && (!heap_.empty() || !meetings_.empty())) {
    if (limit.spend(0)) {
      return false;
    }
    if (meeting_is_next()) {
      advance(popped<LaterMeeting>(meetings_));
      static_cast<void>(limit.spend(64));
      continue;
    }
    const Task task = popped<Later>(heap_);
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
  least = heap_.empty() ? least : std::min(least, heap_.front().key);
  return meetings_.empty() ? least : std::min(least, meetings_.front().key);
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
bool ContactTraversal<Source>::bows(const MotionInterval& interval, double give,
                                    double radii) const {
  return give > kBowShare * radii && give > kBowMargins * bounds_.box_margin() &&
         interval.to - interval.from > kShortest;
}

template <class Source>
void ContactTraversal<Source>::halve(const Task& task, const SweptBoxes& x, const SweptBoxes& y) {
  // Time is not cut where even the whole of it leaves the boxes apart.
  WindowsOfPairs windows;
  kernels_.meet_nodes(x, y, bounds_.box_margin(), windows);
  ++cost_.node_tests;
  if (windows.open == 0) {
    return;
  }
  const std::uint32_t first = halves_of(task.interval);
  for (std::uint32_t half = first; half < first + 2; ++half) {
    if (task.key <= intervals_[half].to) {
      push({std::max(task.key, intervals_[half].from), task.x, task.y, half, task.depth});
    }
  }
}

template <class Source>
void ContactTraversal<Source>::open(const Task& from) {
  Task task = from;
  const Kept<WideNode> node_x = x_.node(index_of(task.x));
  const Kept<WideNode> node_y = y_.node(index_of(task.y));
  const WideTree& tree_x = mover_.layout();
  const WideTree& tree_y = resting_.shape.layout();
  const MotionInterval& interval = intervals_[task.interval];
  const double size_x = node_x.l1_radius / tree_x.scale();
  const double size_y = node_y.l1_radius / tree_y.scale();
  const bool any_leaf = is_lane(task.x | task.y);
  const bool only_x = !any_leaf && size_x > kSimilarSwept * size_y;
  const bool only_y = !any_leaf && size_y > kSimilarSwept * size_x;
  const BoxSway sway = sway_of_whole(tree_x, node_x, bounds_, interval);
  if (bows(interval, sway.give, sway.radius + radius_of_whole(tree_y, node_y))) {
    halve(task, swept_boxes(tree_x, node_x, bounds_, interval, kWholeNode),
          resting_boxes(tree_y, node_y, resting_.pose, kWholeNode));
    return;
  }
  if (is_lane(task.y) && half_of(node_y, lane_of(task.y)) / tree_y.scale() > size_x) {
    const SweptBoxes box = swept_boxes(tree_x, node_x, bounds_, interval, kWholeNode);
    task.key = std::max(task.key, rest_free_of_box(node_y.child[lane_of(task.y)], box, interval));
  } else if (is_lane(task.x) && half_of(node_x, lane_of(task.x)) / tree_x.scale() > size_y) {
    const SweptBoxes box = resting_boxes(tree_y, node_y, resting_.pose, kWholeNode);
    task.key = std::max(task.key,
                        mover_free_of_box(node_x.child[lane_of(task.x)], sway.bow, box, interval));
  }
  if (task.key > interval.to || task.key > goal_.limit()) {
    return;
  }
  const SweptBoxes x =
      swept_boxes(tree_x, node_x, bounds_, interval, only_y ? kWholeNode : all_lanes(node_x));
  const SweptBoxes y =
      resting_boxes(tree_y, node_y, resting_.pose, only_x ? kWholeNode : all_lanes(node_y));
  WindowsOfPairs windows;
  kernels_.meet_nodes(x, y, bounds_.box_margin(), windows);
  cost_.node_tests += x.count * y.count;
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t j = 0; j < y.count; ++j) {
      if (!windows.has(i, j) || (!only_y && !means_lane(task.x, i)) ||
          (!only_x && !means_lane(task.y, j))) {
        continue;
      }
      const TimeWindow window = windows.at(i, j);
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
  const Kept<WideNode> node_x = x_.node(index_of(task.x));
  const Kept<WideNode> node_y = y_.node(index_of(task.y));
  const MotionInterval& interval = intervals_[task.interval];
  const SweptBoxes box_x =
      swept_boxes(mover_.layout(), node_x, bounds_, interval, one_lane(lane_of(task.x)));
  const SweptBoxes box_y =
      resting_boxes(resting_.shape.layout(), node_y, resting_.pose, one_lane(lane_of(task.y)));
  if (bows(interval, box_x.give[0], box_x.radius(0) + box_y.radius(0))) {
    halve(task, box_x, box_y);
    static_cast<void>(limit.spend(16));
    return;
  }
  std::uint32_t token_x = node_x.child[lane_of(task.x)];
  for (bool more_x = true; more_x; token_x = x_.next(token_x)) {
    const Kept<TriangleBlock> block_x = x_.block(token_x);
    more_x = block_x.following != 0;
    std::uint32_t token_y = node_y.child[lane_of(task.y)];
    for (bool more_y = true; more_y; token_y = y_.next(token_y)) {
      const Kept<TriangleBlock> block_y = y_.block(token_y);
      more_y = block_y.following != 0;
      look_at_blocks(block_x, block_y, {interval, box_x, box_y, task.key});
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
  cost_.node_tests += x.count + y.count;
  gather_lanes(mover_.mesh(), x, lanes_x_);
  kernels_.sweep(leaves.interval, leaves.x.bow[0], lanes_x_);
  kernels_.meet_box(lanes_x_, leaves.y, margin, windows_);
  if (windows_.open == 0) {
    return;
  }
  keep_lanes(windows_.open, lanes_x_);
  gather_lanes(resting_.shape.mesh(), y, lanes_y_);
  kernels_.place(resting_.pose, lanes_y_);
  kernels_.meet_box(lanes_y_, leaves.x, margin, windows_);
  for (std::uint32_t left = windows_.open; left != 0; left &= left - 1) {
    const auto j = static_cast<std::size_t>(std::countr_zero(left));
    kernels_.meet_triangle(lanes_x_, lanes_y_, j, margin, windows_);
    cost_.triangle_tests += lanes_x_.count;
    for (std::uint32_t open = windows_.open; open != 0; open &= open - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(open));
      const TimeWindow window = windows_.at(i);
      const double from = std::max(leaves.key, leaves.interval.begin_of(window));
      if (from <= goal_.limit()) {
        meetings_.push_back({from,
                             std::max(from, leaves.interval.end_of(window)),
                             {lanes_x_.id[i], lanes_y_.id[j]}});
        std::push_heap(meetings_.begin(), meetings_.end(), LaterMeeting());
      }
    }
  }
}

template <class Source>
void ContactTraversal<Source>::advance(const Meeting& meeting) {
  PairAdvance(bounds_, mover_, resting_, meeting.ids, goal_, cost_).run(meeting.key, meeting.until);
}

template <class Source>
double ContactTraversal<Source>::first_begin(const MotionInterval& interval) const {
  double first = kNever;
  for (std::uint32_t open = windows_.open; open != 0; open &= open - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(open));
    first = std::min(first, interval.begin_of(windows_.at(lane)));
  }
  return first;
}

template <class Source>
double ContactTraversal<Source>::rest_free_of_box(std::uint32_t token, const SweptBoxes& box,
                                                  const MotionInterval& interval) {
  double first = kNever;
  for (bool more = true; more; token = y_.next(token)) {
    const TriangleBlock& block = y_.block(token);
    more = block.following != 0;
    cost_.node_tests += block.count;
    gather_lanes(resting_.shape.mesh(), block, lanes_y_);
    kernels_.place(resting_.pose, lanes_y_);
    kernels_.meet_box(lanes_y_, box, bounds_.box_margin(), windows_);
    first = std::min(first, first_begin(interval));
  }
  return first;
}

template <class Source>
double ContactTraversal<Source>::mover_free_of_box(std::uint32_t token, double bow,
                                                   const SweptBoxes& box,
                                                   const MotionInterval& interval) {
  double first = kNever;
  for (bool more = true; more; token = x_.next(token)) {
    const TriangleBlock& block = x_.block(token);
    more = block.following != 0;
    cost_.node_tests += block.count;
    gather_lanes(mover_.mesh(), block, lanes_x_);
    kernels_.sweep(interval, bow, lanes_x_);
    kernels_.meet_box(lanes_x_, box, bounds_.box_margin(), windows_);
    first = std::min(first, first_begin(interval));
  }
  return first;
}

template class ContactTraversal<WideSource>;
template class ContactTraversal<CompactSource>;

}  // namespace soms::detail
