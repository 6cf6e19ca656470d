#include "soms/query/detail/pair_walk.h"

#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/box_tests.h"
#include "soms/query/detail/triangle_tests.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are opened while neither is more than this much larger.
constexpr float kSimilar = 2;

/// Pairs worked on at once: enough to hide the wait for memory and for results.
constexpr std::size_t kGroup = 2;

float longest(const std::array<float, 3>& half) {
  return std::max({half[0], half[1], half[2]});
}

Triangle moved(const WalkSide& side, TriangleId id) {
  const Triangle t = side.shape->mesh().triangle(id);
  return {side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
}

std::size_t lowest(std::uint32_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
}

/// Starts to load what a pushed pair will look at first.
void fetch(const void* place) {
  constexpr std::size_t kLine = 64;
  const auto* bytes = static_cast<const char*>(place);
  for (std::size_t line = 0; line < sizeof(WideNode); line += kLine) {
    __builtin_prefetch(bytes + line);
  }
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
                   WalkMemory& memory)
    : relative_(relative),
      x_(x),
      y_(y),
      nodes_x_(x.shape->layout().nodes().data()),
      nodes_y_(y.shape->layout().nodes().data()),
      blocks_x_(x.shape->layout().blocks().data()),
      blocks_y_(y.shape->layout().blocks().data()),
      swapped_(swapped),
      memory_(memory) {
}

void PairWalk::start() {
  ++cost_.node_tests;
  memory_.clear();
  if (!relative_.apart()) {
    push({0, 0});
  }
}

void PairWalk::start(const PlacePair& from) {
  memory_.clear();
  push(from);
}

void PairWalk::push(const PlacePair& pair) {
  const bool leaf_x = is_leaf(pair.x);
  const bool leaf_y = is_leaf(pair.y);
  leaf_x ? fetch(&block_x(pair.x)) : fetch(&node_x(pair.x));
  leaf_y ? fetch(&block_y(pair.y)) : fetch(&node_y(pair.y));
  PlaceStack& stack = leaf_x && leaf_y   ? memory_.blocks
                      : leaf_x || leaf_y ? memory_.mixed
                                         : memory_.nodes;
  stack.push(pair);
}

PlacePair PairWalk::take(PlaceStack& stack) {
  const PlacePair pair = stack.pop();
  const PlacePair here{is_run(pair.x) ? pair.x & ~WideNode::kRunBit : pair.x,
                       is_run(pair.y) ? pair.y & ~WideNode::kRunBit : pair.y};
  // Row by row: only the head of a row, whose y is still a run too, goes on to the next row.
  if (is_run(pair.x) && block_x(here.x).following > 0) {
    stack.push({pair.x + 1, pair.y});
  }
  if (is_run(pair.y) && block_y(here.y).following > 0) {
    stack.push({here.x, pair.y + 1});
  }
  return here;
}

void PairWalk::push_meeting(const Opening& opening) {
  const PlacePair& pair = opening.pair;
  for (std::uint32_t meet = opening.meet; meet != 0; meet &= meet - 1) {
    const std::size_t bit = lowest(meet);
    if (opening.open == Open::both) {
      push({node_x(pair.x).child[bit & 3], node_y(pair.y).child[(bit + (bit >> 2)) & 3]});
    } else if (opening.open == Open::x) {
      push({node_x(pair.x).child[bit], pair.y});
    } else {
      push({pair.x, node_y(pair.y).child[bit]});
    }
  }
}

template <void (PairWalk::*Test)(PairWalk::Opening&)>
void PairWalk::open_group(PlaceStack& stack) {
  std::array<Opening, kGroup> group;
  const std::size_t count = std::min(kGroup, stack.size());
  for (std::size_t i = 0; i < count; ++i) {
    group[i].pair = take(stack);
  }
  for (std::size_t i = 0; i < count; ++i) {
    (this->*Test)(group[i]);
  }
  for (std::size_t i = count; i > 0; --i) {
    push_meeting(group[i - 1]);
  }
}

void PairWalk::test_mixed(Opening& opening) {
  Relation relation;
  if (is_leaf(opening.pair.x)) {
    const TriangleBlock& x = block_x(opening.pair.x);
    const WideNode& y = node_y(opening.pair.y);
    relative_.relate(x, y, relation);
    opening.open = Open::y;
    opening.meet = 0;
    if (longest(x.own_half) * relative_.ratio() > longest(y.own_half())) {
      cost_.node_tests += x.count;
      if (box_against_x(relation, x, y.own_half()) == 0) {
        return;
      }
    }
    cost_.node_tests += y.count;
    opening.meet = one_against_four(relation, x.own_half, y);
    return;
  }
  const WideNode& x = node_x(opening.pair.x);
  const TriangleBlock& y = block_y(opening.pair.y);
  relative_.relate(x, y, relation);
  opening.open = Open::x;
  opening.meet = 0;
  if (longest(y.own_half) > longest(x.own_half()) * relative_.ratio()) {
    cost_.node_tests += y.count;
    if (box_against_y(relation, x.own_half(), y) == 0) {
      return;
    }
  }
  cost_.node_tests += x.count;
  opening.meet = four_against_one(relation, x, y.own_half);
}

void PairWalk::test_nodes(Opening& opening) {
  const WideNode& x = node_x(opening.pair.x);
  const WideNode& y = node_y(opening.pair.y);
  Relation relation;
  relative_.relate(x, y, relation);
  const float size_x = longest(x.own_half()) * relative_.ratio();
  const float size_y = longest(y.own_half());
  if (size_x > kSimilar * size_y) {
    opening.open = Open::x;
    opening.meet = four_against_one(relation, x, y.own_half());
    cost_.node_tests += x.count;
  } else if (size_y > kSimilar * size_x) {
    opening.open = Open::y;
    opening.meet = one_against_four(relation, x.own_half(), y);
    cost_.node_tests += y.count;
  } else {
    opening.open = Open::both;
    opening.meet = four_against_four(relation, x, y);
    cost_.node_tests += std::uint64_t{x.count} * y.count;
  }
}

bool PairWalk::step(Collector& collector, Watch& watch) {
  if (!memory_.blocks.empty()) {
    return !decide_group(collector) && !watch.spend(8 * kGroup);
  }
  if (!memory_.mixed.empty()) {
    open_group<&PairWalk::test_mixed>(memory_.mixed);
  } else if (!memory_.nodes.empty()) {
    open_group<&PairWalk::test_nodes>(memory_.nodes);
  } else {
    return false;
  }
  return !watch.spend(kGroup);
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
      memory_.clear();
      push(pair);
      memory_.mixed.empty() ? open_group<&PairWalk::test_nodes>(memory_.nodes)
                            : open_group<&PairWalk::test_mixed>(memory_.mixed);
      for (const PlaceStack* stack : {&memory_.blocks, &memory_.mixed, &memory_.nodes}) {
        next.insert(next.end(), stack->begin(), stack->end());
      }
      opened = true;
    }
    level.swap(next);
  }
  return level;
}

bool PairWalk::decide_group(Collector& collector) {
  std::array<PlacePair, kGroup> group;
  std::array<Relation, kGroup> relations;
  std::array<std::uint32_t, kGroup> lanes;
  const std::size_t count = std::min(kGroup, memory_.blocks.size());
  for (std::size_t i = 0; i < count; ++i) {
    group[i] = take(memory_.blocks);
    const TriangleBlock& x = block_x(group[i].x);
    const TriangleBlock& y = block_y(group[i].y);
    relative_.relate(x, y, relations[i]);
    cost_.node_tests += y.count;
    lanes[i] = box_against_y(relations[i], x.own_half, y);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (lanes[i] != 0 && decide(group[i], relations[i], lanes[i], collector)) {
      return true;
    }
  }
  return false;
}

bool PairWalk::decide(const PlacePair& pair, const Relation& relation, std::uint32_t lanes_y,
                      Collector& collector) {
  const TriangleBlock& x = block_x(pair.x);
  const TriangleBlock& y = block_y(pair.y);
  cost_.node_tests += x.count;
  std::uint32_t lanes_x = box_against_x(relation, x, y.own_half);
  if (lanes_x == 0) {
    return false;
  }
  const BlockPair rows(relation, x, y);
  for (; lanes_x != 0; lanes_x &= lanes_x - 1) {
    const auto i = static_cast<std::uint32_t>(lowest(lanes_x));
    const std::uint32_t lanes = rows.row(i, lanes_y);
    if (lanes != 0 && decide(x.id[i], y, lanes, collector)) {
      return true;
    }
  }
  return false;
}

bool PairWalk::decide(TriangleId i, const TriangleBlock& y, std::uint32_t lanes,
                      Collector& collector) {
  const Triangle s = moved(x_, i);
  const Box box = bounds(s);
  for (; lanes != 0; lanes &= lanes - 1) {
    const TriangleId j = y.id[lowest(lanes)];
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
