#include "soms/query/detail/pair_walk.h"

#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/box_tests.h"
#include "soms/query/detail/triangle_tests.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// Both nodes are opened while neither is more than this much larger.
constexpr float kSimilar = 2;

template <class Place>
float size_of(const Place& place) {
  return std::max({place.own_half[0], place.own_half[1], place.own_half[2]});
}

Triangle moved(const WalkSide& side, TriangleId id) {
  const Triangle t = side.shape->mesh().triangle(id);
  return {side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
}

}  // namespace

void PlaceStack::grow() {
  if (far_.empty()) {
    far_.assign(near_.begin(), near_.end());
  }
  far_.resize(2 * capacity_);
  capacity_ = far_.size();
  data_ = far_.data();
}

PairWalk::PairWalk(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
                   PlaceStack& stack)
    : relative_(relative),
      x_(x),
      y_(y),
      nodes_x_(x.shape->layout().nodes().data()),
      nodes_y_(y.shape->layout().nodes().data()),
      blocks_x_(x.shape->layout().blocks().data()),
      blocks_y_(y.shape->layout().blocks().data()),
      swapped_(swapped),
      stack_(stack) {
}

void PairWalk::run(Collector& collector, Watch& watch) {
  ++cost_.node_tests;
  if (!relative_.apart()) {
    run({0, 0}, collector, watch);
  }
}

void PairWalk::run(const PlacePair& from, Collector& collector, Watch& watch) {
  stack_.clear();
  stack_.push(from);
  while (!stack_.empty() && !watch.spend(1)) {
    const PlacePair pair = stack_.pop();
    if (is_leaf(pair.x) && is_leaf(pair.y)) {
      if (blocks(pair, collector, watch)) {
        return;
      }
    } else {
      open(pair);
    }
  }
}

std::vector<PlacePair> PairWalk::frontier(std::size_t enough) {
  ++cost_.node_tests;
  if (relative_.apart()) {
    return {};
  }
  std::vector<PlacePair> level{{0, 0}};
  std::vector<PlacePair> next;
  bool opened = true;
  while (opened && level.size() < enough) {
    next.clear();
    opened = false;
    for (const PlacePair& pair : level) {
      if (is_leaf(pair.x) && is_leaf(pair.y)) {
        next.push_back(pair);
        continue;
      }
      stack_.clear();
      open(pair);
      opened = true;
      for (std::size_t i = 0; i < stack_.size(); ++i) {
        next.push_back(stack_[i]);
      }
    }
    level.swap(next);
  }
  return level;
}

void PairWalk::push_children_x(const WideNode& x, std::uint32_t lanes, std::uint32_t y) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::uint32_t child = x.child[static_cast<std::size_t>(__builtin_ctz(lanes))];
    stack_.push({child, y});
    if (is_leaf(child)) {
      for (std::uint32_t k = block_x(child).following; k > 0; --k) {
        stack_.push({child + k, y});
      }
    }
  }
}

void PairWalk::push_children_y(std::uint32_t x, const WideNode& y, std::uint32_t lanes) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::uint32_t child = y.child[static_cast<std::size_t>(__builtin_ctz(lanes))];
    stack_.push({x, child});
    if (is_leaf(child)) {
      for (std::uint32_t k = block_y(child).following; k > 0; --k) {
        stack_.push({x, child + k});
      }
    }
  }
}

void PairWalk::open(const PlacePair& pair) {
  if (is_leaf(pair.x)) {
    open_y_at_block(pair);
  } else if (is_leaf(pair.y)) {
    open_x_at_block(pair);
  } else {
    open_nodes(pair);
  }
}

void PairWalk::open_x_at_block(const PlacePair& pair) {
  const WideNode& x = node_x(pair.x);
  const TriangleBlock& y = block_y(pair.y);
  Relation relation;
  relative_.relate(x, y, relation);
  if (size_of(y) > size_of(x) * relative_.ratio()) {
    cost_.node_tests += y.count;
    if (box_against_y(relation, x.own_half, y) == 0) {
      return;
    }
  }
  cost_.node_tests += x.count;
  push_children_x(x, four_against_one(relation, x, y.own_half), pair.y);
}

void PairWalk::open_y_at_block(const PlacePair& pair) {
  const TriangleBlock& x = block_x(pair.x);
  const WideNode& y = node_y(pair.y);
  Relation relation;
  relative_.relate(x, y, relation);
  if (size_of(x) * relative_.ratio() > size_of(y)) {
    cost_.node_tests += x.count;
    if (box_against_x(relation, x, y.own_half) == 0) {
      return;
    }
  }
  cost_.node_tests += y.count;
  push_children_y(pair.x, y, one_against_four(relation, x.own_half, y));
}

void PairWalk::open_nodes(const PlacePair& pair) {
  const WideNode& x = node_x(pair.x);
  const WideNode& y = node_y(pair.y);
  Relation relation;
  relative_.relate(x, y, relation);
  const float size_x = size_of(x) * relative_.ratio();
  const float size_y = size_of(y);
  if (size_x > kSimilar * size_y) {
    cost_.node_tests += x.count;
    push_children_x(x, four_against_one(relation, x, y.own_half), pair.y);
    return;
  }
  if (size_y > kSimilar * size_x) {
    cost_.node_tests += y.count;
    push_children_y(pair.x, y, one_against_four(relation, x.own_half, y));
    return;
  }
  cost_.node_tests += std::uint64_t{x.count} * y.count;
  for (std::uint32_t meet = four_against_four(relation, x, y); meet != 0; meet &= meet - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(meet));
    push_children_y(x.child[bit & 3], y, 1U << ((bit + (bit >> 2)) & 3));
    const std::uint32_t child = x.child[bit & 3];
    if (is_leaf(child)) {
      for (std::uint32_t k = block_x(child).following; k > 0; --k) {
        push_children_y(child + k, y, 1U << ((bit + (bit >> 2)) & 3));
      }
    }
  }
}

bool PairWalk::blocks(const PlacePair& pair, Collector& collector, Watch& watch) {
  const TriangleBlock& x = block_x(pair.x);
  const TriangleBlock& y = block_y(pair.y);
  Relation relation;
  relative_.relate(x, y, relation);
  cost_.node_tests += y.count;
  const std::uint32_t lanes_y = box_against_y(relation, x.own_half, y);
  if (lanes_y == 0) {
    return false;
  }
  cost_.node_tests += x.count;
  std::uint32_t lanes_x = box_against_x(relation, x, y.own_half);
  if (lanes_x == 0) {
    return false;
  }
  const BlockPair rows(relation, x, y);
  for (; lanes_x != 0; lanes_x &= lanes_x - 1) {
    const auto i = static_cast<std::uint32_t>(__builtin_ctz(lanes_x));
    const std::uint32_t lanes = rows.row(i, lanes_y);
    if (lanes != 0 && decide(x.id[i], y, lanes, collector)) {
      return true;
    }
  }
  return watch.spend(4);
}

bool PairWalk::decide(TriangleId i, const TriangleBlock& y, std::uint32_t lanes,
                      Collector& collector) {
  const Triangle s = moved(x_, i);
  const Box box = bounds(s);
  for (; lanes != 0; lanes &= lanes - 1) {
    const TriangleId j = y.id[static_cast<std::size_t>(__builtin_ctz(lanes))];
    const TrianglePair ids = swapped_ ? TrianglePair{j, i} : TrianglePair{i, j};
    if (!collector.wants(ids)) {
      continue;
    }
    const Triangle t = moved(y_, j);
    if (!overlaps(box, bounds(t))) {
      continue;
    }
    ++cost_.triangle_tests;
    if (triangles_overlap(s, t, &cost_.exact_tests) && collector.add(ids)) {
      return true;
    }
  }
  return false;
}

}  // namespace soms::detail
