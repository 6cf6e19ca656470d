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

/// A pair of places in two trees: nodes, or blocks of triangles (with WideNode::kLeafBit).
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

  [[nodiscard]] const PlacePair& operator[](std::size_t i) const { return data_[i]; }

 private:
  static constexpr std::size_t kNear = 256;

  void grow();

  std::array<PlacePair, kNear> near_;
  std::vector<PlacePair> far_;
  PlacePair* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = kNear;
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
           PlaceStack& stack);

  /// Walks from the roots.
  void run(Collector& collector, Watch& watch);

  /// Walks from one pair of places.
  void run(const PlacePair& from, Collector& collector, Watch& watch);

  /// Opens pairs in order, level by level, until there are `enough` or only blocks are left: the
  /// same pairs whatever the number of threads.
  [[nodiscard]] std::vector<PlacePair> frontier(std::size_t enough);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static bool is_leaf(std::uint32_t place) { return (place & WideNode::kLeafBit) != 0; }

  [[nodiscard]] const WideNode& node_x(std::uint32_t place) const { return nodes_x_[place]; }

  [[nodiscard]] const WideNode& node_y(std::uint32_t place) const { return nodes_y_[place]; }

  [[nodiscard]] const TriangleBlock& block_x(std::uint32_t place) const {
    return blocks_x_[place & ~WideNode::kLeafBit];
  }

  [[nodiscard]] const TriangleBlock& block_y(std::uint32_t place) const {
    return blocks_y_[place & ~WideNode::kLeafBit];
  }

  /// Puts the pairs below `pair` that may meet on the stack.
  void open(const PlacePair& pair);
  void open_nodes(const PlacePair& pair);
  void open_x_at_block(const PlacePair& pair);
  void open_y_at_block(const PlacePair& pair);
  void push_children_x(const WideNode& x, std::uint32_t lanes, std::uint32_t y);
  void push_children_y(std::uint32_t x, const WideNode& y, std::uint32_t lanes);

  /// Decides all triangles of two blocks; true when the walk is to stop.
  [[nodiscard]] bool blocks(const PlacePair& pair, Collector& collector, Watch& watch);

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
  PlaceStack& stack_;
  Cost cost_;
};

}  // namespace soms::detail
