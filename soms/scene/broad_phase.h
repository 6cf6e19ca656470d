/// \file
/// Which of many moving boxes meet each other?
#pragma once

#include "soms/base/box.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace soms {

/// Numbers of two boxes, the lesser first.
using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// All pairs of meeting boxes, call after call, where all boxes may have moved in between. Kept
/// from call to call are larger boxes, stretched along the way that each took, and the pairs of
/// these: while boxes stay inside, a call only looks through the pairs. That serves speed alone: an
/// answer depends on the boxes of its call only. \threads One caller at a time.
class BroadPhase {
 public:
  BroadPhase();
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  /// Pairs of boxes that share a point (touching counts), each once, sorted. The span is valid
  /// until the next call. Empty boxes meet nothing.
  /// \pre     Ends of magnitude at most 2^300, `lower` at most `upper`; or default boxes.
  /// \errors  ErrorKind::out_of_range above 2^27 boxes.
  /// \cost    n boxes, p pairs: O(n + p) where the boxes are scattered; O(n log n + p) or somewhat
  ///          more where they are not (clusters far apart, sizes over many decades); never
  ///          quadratic because boxes coincide, but for their pairs. Memory is reused.
  [[nodiscard]] std::span<const BoxPair> find(std::span<const Box> boxes);

  /// Lets the next call start from nothing.
  void forget();

  /// Bytes held.
  [[nodiscard]] std::size_t memory() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms
