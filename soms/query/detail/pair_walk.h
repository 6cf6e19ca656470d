/// \file
/// The default traversal: two wide trees walked together, with a stack that grows.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/box_tests.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/shape.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// A pair of places in two trees: nodes, or lanes that hold leaves.
struct PlacePair {
  std::uint32_t x;
  std::uint32_t y;
};

/// A triangle where its body's pose put it.
struct MovedTriangle {
  Triangle triangle;
  Box box;
  TriangleId id;
};

/// Memory of a walk, to be used again: nothing is allocated once it has grown.
struct WalkMemory {
  std::vector<PlacePair> stack;
  std::vector<MovedTriangle> x;
  std::vector<MovedTriangle> y;
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

  /// Walks from the roots.
  void run(Collector& collector, Watch& watch);

  /// Walks from one pair of places.
  void run(const PlacePair& from, Collector& collector, Watch& watch);

  /// Opens pairs in order, level by level, until there are `enough` or only leaves are left: the
  /// same pairs whatever the number of threads.
  [[nodiscard]] std::vector<PlacePair> frontier(std::size_t enough);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static bool is_leaf(std::uint32_t place) { return (place & WideNode::kLeafBit) != 0; }

  static std::uint32_t node_of(std::uint32_t place) {
    return is_leaf(place) ? (place & ~WideNode::kLeafBit) >> 2 : place;
  }

  static std::uint32_t place_of(std::uint32_t node, const WideNode& wide, std::uint32_t lane);

  void open(const PlacePair& pair, std::vector<PlacePair>& into);
  void open_x(const PlacePair& pair, std::vector<PlacePair>& into);
  void open_y(const PlacePair& pair, std::vector<PlacePair>& into);
  void open_both(const PlacePair& pair, std::vector<PlacePair>& into);

  /// Decides all triangles of two leaves; true when the walk is to stop.
  [[nodiscard]] bool leaves(const PlacePair& pair, Collector& collector, Watch& watch);

  const RelativePose& relative_;
  WalkSide x_;
  WalkSide y_;
  const WideTree& tree_x_;
  const WideTree& tree_y_;
  bool swapped_;
  WalkMemory& memory_;
  Cost cost_;
  std::uint32_t moved_x_ = kNone;  // leaf whose triangles memory_.x holds
  std::uint32_t moved_y_ = kNone;

  static constexpr std::uint32_t kNone = 0xffffffffU;
};

}  // namespace soms::detail
