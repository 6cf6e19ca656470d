/// \file
/// Lists of pairs of nodes that a traversal has still to look at.
#pragma once

#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// A pair of nodes in two trees: node ids of which one at least is a node (see NodeTask), or tokens
/// of WideNode::child that are leaves both.
struct NodeRefPair {
  std::uint32_t x;
  std::uint32_t y;

  [[nodiscard]] bool blocks() const { return (x & WideNode::kLeafBit) != 0; }
};

/// A stack of pairs that allocates only when it outgrows what it has.
class PairList {
 public:
  PairList() = default;
  PairList(const PairList&) = delete;
  PairList& operator=(const PairList&) = delete;
  ~PairList() = default;

  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] std::size_t size() const { return size_; }

  void clear() { size_ = 0; }

  void push(const NodeRefPair& pair) {
    reserve(1);
    x_[size_] = pair.x;
    y_[size_++] = pair.y;
  }

  NodeRefPair pop() {
    --size_;
    return {x_[size_], y_[size_]};
  }

  /// Takes the last `count` pairs off; `at` still has them until something is added.
  void drop(std::size_t count) { size_ -= count; }

  [[nodiscard]] NodeRefPair at(std::size_t i) const { return {x_[i], y_[i]}; }

  void set(std::size_t i, const NodeRefPair& pair) {
    x_[i] = pair.x;
    y_[i] = pair.y;
  }

  /// Makes room for `more` pairs at `end_x` and `end_y`, which `add` then counts.
  void reserve(std::size_t more) {
    if (size_ + more > capacity_) {
      grow(size_ + more);
    }
  }

  [[nodiscard]] std::uint32_t* end_x() { return x_ + size_; }

  [[nodiscard]] std::uint32_t* end_y() { return y_ + size_; }

  void add(std::size_t count) { size_ += count; }

 private:
  static constexpr std::size_t kNear = 256;

  void grow(std::size_t least);

  std::array<std::uint32_t, 2 * kNear> near_;
  std::vector<std::uint32_t> far_;
  std::uint32_t* x_ = near_.data();
  std::uint32_t* y_ = near_.data() + kNear;
  std::size_t size_ = 0;
  std::size_t capacity_ = kNear;
};

}  // namespace soms::detail
