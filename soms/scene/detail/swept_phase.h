/// \file
/// The ways of movers since the last step, and the first contacts on them.
#pragma once

#include "soms/base/limits.h"
#include "soms/motion/first_contact.h"
#include "soms/scene/detail/first_contacts.h"
#include "soms/scene/detail/pair_answers.h"
#include "soms/scene/detail/residents.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Keeps its memory from step to step.
class SweptPhase {
 public:
  /// Finds the movers that have left the place of the last of so many steps.
  /// \errors ErrorKind::out_of_range where one may come beyond 2^300; it is named.
  void start(const Residents& movers, std::uint64_t steps);

  /// The same of a step without ways: no mover has left its place.
  void skip() { boxes_.clear(); }

  /// The mover in a place has a way.
  [[nodiscard]] bool moves(std::uint32_t place) const {
    return place < boxes_.size() && !boxes_[place].empty();
  }

  /// Holds the mover in a place all the way, which is where it is if it has none.
  [[nodiscard]] const Box& box(const Residents& movers, std::uint32_t place) const {
    return moves(place) ? boxes_[place] : movers.places()[place].value.box;
  }

  /// The first contact of each pair, at parts of the way. `others` are parts, or the movers again.
  /// One body of a pair has a way. The first triangle of an answer is that of `mover`.
  /// \errors As `first_contact`.
  Cost ask(std::span<const Candidate> pairs, const Residents& movers, const Residents& others,
           const Limits& limits);

  /// Of the pairs of the last call, in their order.
  [[nodiscard]] std::span<const FirstContact> answers() const { return answers_.get(); }

  /// Gives back memory that is far more than so many movers and pairs need.
  void give_back(std::size_t movers, std::size_t pairs);

  [[nodiscard]] std::size_t memory() const { return bytes(boxes_) + answers_.memory(); }

 private:
  std::uint64_t steps_ = 0;
  std::vector<Box> boxes_;  ///< of each place, over the way; empty without one
  PairAnswers<FirstContact, 0> answers_;
};

}  // namespace soms::detail
