/// \file
/// Which of many moving boxes meet each other?
///
/// \code
/// std::vector<soms::Box> boxes{
///     {{0, 0, 0}, {1, 1, 1}}, {{1, 0, 0}, {2, 1, 1}}, {{5, 0, 0}, {6, 1, 1}}};
/// soms::BroadPhase broad_phase;
/// for (const auto& [a, b] : broad_phase.find(boxes)) {
///   std::cout << a << " meets " << b << '\n';
/// }
/// boxes[2] = {{1.5, 0, 0}, {2.5, 1, 1}};  // it moved
/// std::cout << broad_phase.find(boxes).size() << " pairs after the move\n";
/// \endcode
/// It prints:
/// \verbatim
/// 0 meets 1
/// 2 pairs after the move
/// \endverbatim
#pragma once

#include "soms/base/box.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace soms {

/// Numbers of two boxes, the lesser first.
using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

/// All pairs of meeting boxes, call after call, where all boxes may have moved in between. What is
/// kept from call to call is larger boxes, stretched along the way that each took, and the pairs of
/// these. While boxes stay inside, a call only looks through the pairs. That serves speed alone: an
/// answer depends on the filter and on the boxes of its call only. \threads One caller at a time.
class BroadPhase {
 public:
  BroadPhase();
  ~BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;

  /// Sets which pairs later calls leave out: two boxes of one group, and the pairs of `ignored`.
  /// They are skipped where they would be found, so they take no memory: the boxes of one group may
  /// all coincide. Without this, no pair is left out.
  ///
  /// \shape   `groups`: one for each box; 0 is no group, and so is what lies behind the end.
  ///          `ignored`: numbers of two boxes in either order, in any order, any number of times.
  /// \errors  ErrorKind::out_of_range for a box of `ignored` that is 2^27 or more.
  /// \cost    k ignored pairs among the first n boxes: O(n + k log k). The next call starts from
  ///          nothing.
  void set_filter(std::vector<std::uint32_t> groups, std::span<const BoxPair> ignored);

  /// Pairs of boxes that share a point (touching counts), each once, sorted. The span is valid
  /// until the next call. Empty boxes meet nothing.
  /// \pre     Ends of magnitude at most 2^300, `lower` at most `upper`; or default boxes.
  /// \errors  ErrorKind::out_of_range above 2^27 boxes; those of `instruction_set`.
  /// \cost    n boxes, p pairs: O(n + p) where the boxes are scattered. O(n log n + p) or somewhat
  ///          more where they are not (clusters far apart, sizes over many decades). Never
  ///          quadratic because boxes coincide, but for their pairs. Memory is reused, and given
  ///          back where it is far more than a call needs.
  [[nodiscard]] std::span<const BoxPair> find(std::span<const Box> boxes);

  /// Lets the next call start from nothing.
  void forget();

  /// Bytes held: O(n + p + k) for n boxes and p pairs of the last call and k pairs of the filter,
  /// whatever calls before needed. A filter that names boxes beyond those counts as if the last
  /// call had them: 8 bytes a number.
  [[nodiscard]] std::size_t memory() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms
