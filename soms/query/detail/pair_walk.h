/// \file
/// The default traversal: two wide trees walked together, with a stack that grows.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/shape.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// A pair of places in two trees: nodes, or blocks of triangles (WideNode::kLeafBit), or blocks
/// with those that follow in their leaves (WideNode::kRunBit too).
struct PlacePair {
  std::uint32_t x;
  std::uint32_t y;
};

/// A stack that allocates only when it outgrows what it has.
class PlaceStack {
 public:
  PlaceStack() { data_ = near_.data(); }

  PlaceStack(const PlaceStack&) = delete;
  PlaceStack& operator=(const PlaceStack&) = delete;
  ~PlaceStack() = default;

  [[nodiscard]] bool empty() const { return size_ == 0; }

  void clear() { size_ = 0; }

  void push(const PlacePair& pair) {
    if (size_ == capacity_) {
      grow();
    }
    data_[size_++] = pair;
  }

  PlacePair pop() { return data_[--size_]; }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] const PlacePair* begin() const { return data_; }

  [[nodiscard]] const PlacePair* end() const { return data_ + size_; }

 private:
  static constexpr std::size_t kNear = 128;

  void grow();

  std::array<PlacePair, kNear> near_;
  std::vector<PlacePair> far_;
  PlacePair* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = kNear;
};

/// Pairs still to be opened or decided, by kind, so that several of a kind are worked on at once.
struct WalkMemory {
  PlaceStack nodes;   // two nodes
  PlaceStack mixed;   // a node and a block
  PlaceStack blocks;  // two blocks

  void clear() {
    nodes.clear();
    mixed.clear();
    blocks.clear();
  }
};

/// A shape at a pose, as one side of a walk.
struct WalkSide {
  const Shape* shape;
  const Pose* pose;
};

/// One query. Sides x and y are the caller's a and b, or b and a when `swapped`.
class PairWalk {
 public:
  PairWalk(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
           WalkMemory& memory);

  /// Begins at the roots.
  void start();

  /// Begins at a pair of places.
  void start(const PlacePair& from);

  /// Works on a few pairs; false when the walk is over.
  [[nodiscard]] bool step(Collector& collector, Watch& watch);

  /// Steps until the walk is over.
  void run(Collector& collector, Watch& watch) {
    while (step(collector, watch)) {
    }
  }

  /// Opens pairs in order, level by level, until there are `enough` or only blocks are left: the
  /// same pairs whatever the number of threads.
  [[nodiscard]] std::vector<PlacePair> frontier(std::size_t enough);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static bool is_leaf(std::uint32_t place) { return (place & WideNode::kLeafBit) != 0; }

  static bool is_run(std::uint32_t place) {
    return is_leaf(place) && (place & WideNode::kRunBit) != 0;
  }

  [[nodiscard]] const WideNode& node_x(std::uint32_t place) const { return nodes_x_[place]; }

  [[nodiscard]] const WideNode& node_y(std::uint32_t place) const { return nodes_y_[place]; }

  [[nodiscard]] const TriangleBlock& block_x(std::uint32_t place) const {
    return blocks_x_[place & ~(WideNode::kLeafBit | WideNode::kRunBit)];
  }

  [[nodiscard]] const TriangleBlock& block_y(std::uint32_t place) const {
    return blocks_y_[place & ~(WideNode::kLeafBit | WideNode::kRunBit)];
  }

  /// Which sides of a pair are opened.
  enum class Open : std::uint8_t { x, y, both };

  /// A pair and what of it meets: lanes of x, of y, or pairs of lanes as `four_against_four` says.
  struct Opening {
    PlacePair pair;
    std::uint32_t meet;
    Open open;
  };

  void push(const PlacePair& pair);

  /// Pops a pair. Of a run of blocks it gives the first and leaves the rest on the stack.
  [[nodiscard]] PlacePair take(PlaceStack& stack);

  /// Takes up to `kGroup` pairs off a stack, tests them all, then pushes what meets: tests of one
  /// pair wait for memory and for each other, tests of several do not.
  template <void (PairWalk::*Test)(Opening&)>
  void open_group(PlaceStack& stack);
  void test_nodes(Opening& opening);
  void test_mixed(Opening& opening);
  void push_meeting(const Opening& opening);

  /// Decides up to `kGroup` pairs of blocks; true when the walk is to stop.
  [[nodiscard]] bool decide_group(Collector& collector);

  /// Decides all triangles of two blocks.
  [[nodiscard]] bool decide(const PlacePair& pair, const Relation& relation, std::uint32_t lanes_y,
                            Collector& collector);

  /// Decides one triangle of x against those of y in `lanes`.
  [[nodiscard]] bool decide(TriangleId i, const TriangleBlock& y, std::uint32_t lanes,
                            Collector& collector);

  const RelativePose& relative_;
  WalkSide x_;
  WalkSide y_;
  const WideNode* nodes_x_;
  const WideNode* nodes_y_;
  const TriangleBlock* blocks_x_;
  const TriangleBlock* blocks_y_;
  bool swapped_;
  WalkMemory& memory_;
  Cost cost_;
};

}  // namespace soms::detail
