/// \file
/// How one part of a set stands to another.
#pragma once

#include "soms/base/limits.h"
#include "soms/clash/clash.h"
#include "soms/clash/part_bodies.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <optional>

namespace soms::detail {

/// Decides one pair of parts after the other, and adds up the cost.
class PairOfParts {
 public:
  PairOfParts(const ClashOptions& options, const Limits& limits)
      : options_(options), alone_(limits.alone()) {}

  /// The clash of two parts, if they are not clear. Nothing is known of it where `cut` says so
  /// afterwards. Which one is named first changes nothing else.
  [[nodiscard]] std::optional<Clash> decide(const PartBody& a, const PartBody& b);

  /// The deadline passed before the last pair was decided.
  [[nodiscard]] bool cut() const { return cut_; }

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  template <class Answer>
  [[nodiscard]] Answer counted(Answer answer) {
    cost_ += answer.cost;
    cut_ = cut_ || answer.coverage == Coverage::cut;
    return answer;
  }

  /// Counts and places what surfaces share. True if they pass through each other, which is
  /// looked at only where a part is `open`.
  bool meet(const Body& a, const Body& b, bool open, Clash& clash);

  /// Whether the surfaces of two bodies share a point.
  [[nodiscard]] bool meet_anywhere(const Body& a, const Body& b);

  /// The gap of parts whose surfaces do not meet; false if it exceeds `at_most`.
  bool measure(const Body& a, const Body& b, double at_most, Clash& clash);

  /// The clash of two parts, whatever they are together with others.
  [[nodiscard]] std::optional<Clash> decide_parts(const PartBody& a, const PartBody& b);

  /// What the clash of two parts lacks that lead bodies (`lead_bodies`): one of the bodies may be
  /// inside the other, an open group, and no pair of their parts says so.
  [[nodiscard]] std::optional<Clash> of_led_bodies(const PartBody& a, const PartBody& b);

  [[nodiscard]] std::optional<Clash> decide_in_order(const PartBody& a, const PartBody& b);
  [[nodiscard]] std::optional<Clash> of_open(const PartBody& a, const PartBody& b);
  [[nodiscard]] std::optional<Clash> of_clear(const Body& a, const Body& b, Clash clash);

  /// How a part whose surface does not meet that of a closed one stands to it, by its components:
  /// all of them inside, some, or none.
  [[nodiscard]] Relation relation_to_closed(const PartBody& part, const ClosedBody& closed,
                                            Relation all_inside);

  /// How parts stand to each other whose surfaces do not meet and of which one may be closed, as
  /// far as a closed one says.
  [[nodiscard]] Relation relation_of_apart(const PartBody& a, const PartBody& b);

  /// Whether `inner` may be inside `outer`, at least in part, whose surface is open and does not
  /// meet that of `inner`: a component lies in its box, or goes through what closes it.
  [[nodiscard]] bool may_be_inside(const PartBody& inner, const PartBody& outer);

  const ClashOptions& options_;
  Limits alone_;
  bool cut_ = false;
  Cost cost_;
};

}  // namespace soms::detail
