#include "soms/query/detail/pair_walk.h"

#include "soms/geometry/triangle_overlap.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// Both nodes are opened while neither is more than this much larger.
constexpr float kSimilar = 2;

float size_of(const WideNode& node) {
  return std::max({node.own_half[0], node.own_half[1], node.own_half[2]});
}

void move_leaf(const WideTree& tree, const WideLeaf& leaf, const WalkSide& side,
               std::vector<MovedTriangle>& into) {
  into.clear();
  for (const TriangleId id : tree.triangles_of(leaf)) {
    const Triangle t = side.shape->mesh().triangle(id);
    const Triangle moved{side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
    into.push_back({moved, bounds(moved), id});
  }
}

const WideLeaf& leaf_at(const WideTree& tree, std::uint32_t place, std::uint32_t& index) {
  const std::uint32_t slot = place & ~WideNode::kLeafBit;
  index = tree.nodes()[slot >> 2].child[slot & 3] & ~WideNode::kLeafBit;
  return tree.leaves()[index];
}

}  // namespace

PairWalk::PairWalk(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
                   WalkMemory& memory)
    : relative_(relative),
      x_(x),
      y_(y),
      tree_x_(x.shape->layout()),
      tree_y_(y.shape->layout()),
      swapped_(swapped),
      memory_(memory) {
}

std::uint32_t PairWalk::place_of(std::uint32_t node, const WideNode& wide, std::uint32_t lane) {
  const std::uint32_t child = wide.child[lane];
  return is_leaf(child) ? WideNode::kLeafBit | node << 2 | lane : child;
}

void PairWalk::run(Collector& collector, Watch& watch) {
  ++cost_.node_tests;
  if (!relative_.apart()) {
    run({0, 0}, collector, watch);
  }
}

void PairWalk::run(const PlacePair& from, Collector& collector, Watch& watch) {
  auto& stack = memory_.stack;
  stack.clear();
  stack.push_back(from);
  while (!stack.empty() && !watch.stopped()) {
    const PlacePair pair = stack.back();
    stack.pop_back();
    if (is_leaf(pair.x) && is_leaf(pair.y)) {
      if (leaves(pair, collector, watch)) {
        return;
      }
    } else {
      open(pair, stack);
      static_cast<void>(watch.spend(1));
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
      } else {
        open(pair, next);
        opened = true;
      }
    }
    level.swap(next);
  }
  return level;
}

void PairWalk::open(const PlacePair& pair, std::vector<PlacePair>& into) {
  if (is_leaf(pair.x)) {
    open_y(pair, into);
    return;
  }
  if (is_leaf(pair.y)) {
    open_x(pair, into);
    return;
  }
  const float x = size_of(tree_x_.nodes()[pair.x]) * relative_.ratio();
  const float y = size_of(tree_y_.nodes()[pair.y]);
  if (x > kSimilar * y) {
    open_x(pair, into);
  } else if (y > kSimilar * x) {
    open_y(pair, into);
  } else {
    open_both(pair, into);
  }
}

void PairWalk::open_x(const PlacePair& pair, std::vector<PlacePair>& into) {
  const WideNode& x = tree_x_.nodes()[pair.x];
  const WideNode& y = tree_y_.nodes()[node_of(pair.y)];
  const OneBox box = is_leaf(pair.y) ? OneBox::lane(y, pair.y & 3) : OneBox::whole(y);
  const std::uint32_t meet = four_against_one(relative_, x, y, box);
  cost_.node_tests += x.count;
  for (std::uint32_t k = 0; k < x.count; ++k) {
    if ((meet >> k & 1) != 0) {
      into.push_back({place_of(pair.x, x, k), pair.y});
    }
  }
}

void PairWalk::open_y(const PlacePair& pair, std::vector<PlacePair>& into) {
  const WideNode& x = tree_x_.nodes()[node_of(pair.x)];
  const WideNode& y = tree_y_.nodes()[pair.y];
  const OneBox box = is_leaf(pair.x) ? OneBox::lane(x, pair.x & 3) : OneBox::whole(x);
  const std::uint32_t meet = one_against_four(relative_, x, box, y);
  cost_.node_tests += y.count;
  for (std::uint32_t k = 0; k < y.count; ++k) {
    if ((meet >> k & 1) != 0) {
      into.push_back({pair.x, place_of(pair.y, y, k)});
    }
  }
}

void PairWalk::open_both(const PlacePair& pair, std::vector<PlacePair>& into) {
  const WideNode& x = tree_x_.nodes()[pair.x];
  const WideNode& y = tree_y_.nodes()[pair.y];
  std::uint32_t meet = four_against_four(relative_, x, y);
  cost_.node_tests += std::uint64_t{x.count} * y.count;
  for (; meet != 0; meet &= meet - 1) {
    const auto bit = static_cast<std::uint32_t>(__builtin_ctz(meet));
    const std::uint32_t k = bit & 3;
    into.push_back({place_of(pair.x, x, k), place_of(pair.y, y, (k + (bit >> 2)) & 3)});
  }
}

bool PairWalk::leaves(const PlacePair& pair, Collector& collector, Watch& watch) {
  std::uint32_t index_x = 0;
  std::uint32_t index_y = 0;
  const WideLeaf& leaf_x = leaf_at(tree_x_, pair.x, index_x);
  const WideLeaf& leaf_y = leaf_at(tree_y_, pair.y, index_y);
  if (index_x != moved_x_) {
    move_leaf(tree_x_, leaf_x, x_, memory_.x);
    moved_x_ = index_x;
  }
  if (index_y != moved_y_) {
    move_leaf(tree_y_, leaf_y, y_, memory_.y);
    moved_y_ = index_y;
  }
  for (const MovedTriangle& s : memory_.x) {
    for (const MovedTriangle& t : memory_.y) {
      const TrianglePair ids = swapped_ ? TrianglePair{t.id, s.id} : TrianglePair{s.id, t.id};
      if (!overlaps(s.box, t.box) || !collector.wants(ids)) {
        continue;
      }
      ++cost_.triangle_tests;
      if (triangles_overlap(s.triangle, t.triangle, &cost_.exact_tests) && collector.add(ids)) {
        return true;
      }
    }
    if (watch.spend(memory_.y.size())) {
      return true;
    }
  }
  return false;
}

}  // namespace soms::detail
