/// \file
/// What is known of the first contact so far.
#pragma once

#include "soms/base/bracket.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/answer.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace soms::detail {

/// Spells of time that were not proved free, and the earliest time with a proved contact.
class ContactGoal {
 public:
  /// Later contacts are of no interest; infinity until one is proved.
  [[nodiscard]] double limit() const { return contact_; }

  /// Until here everything that was looked at is free; infinity if all of it is.
  [[nodiscard]] double free_until() const { return spell_; }

  /// The end of the last spell that is not proved free.
  [[nodiscard]] double last() const { return last_; }

  /// The pair with the proved contact, or else that of the first spell.
  [[nodiscard]] const std::optional<TrianglePair>& triangles() const {
    return contact_pair_ ? contact_pair_ : spell_pair_;
  }

  /// The exact time of the proved contact, if that is known.
  [[nodiscard]] const std::optional<RayTime>& exact() const { return exact_; }

  [[nodiscard]] bool proved() const { return contact_pair_.has_value(); }

  /// Pairs that do not count, sorted.
  void leave_out(std::vector<TrianglePair> pairs) { left_out_ = std::move(pairs); }

  [[nodiscard]] bool leaves_out(const TrianglePair& pair) const {
    return std::binary_search(left_out_.begin(), left_out_.end(), pair);
  }

  /// A pair is not proved free in [from, to].
  void add_spell(const TrianglePair& pair, double from, double to) {
    if (from < spell_ || (from == spell_ && spell_pair_ && pair < *spell_pair_)) {
      spell_ = from;
      spell_pair_ = pair;
    }
    last_ = to > last_ ? to : last_;
  }

  /// A pair touches at this very time, and not before.
  void add_exact(const TrianglePair& pair, RayTime time) {
    const auto order = exact_ ? compare(time, *exact_) : std::strong_ordering::less;
    if (order < 0 || (order == 0 && pair < *contact_pair_)) {
      const Bracket next = bracket(time);
      spell_ = next.lower;
      contact_ = next.upper;
      contact_pair_ = pair;
      exact_ = std::move(time);
    }
  }

  /// A pair touches at `at`.
  void add_contact(const TrianglePair& pair, double at) {
    if (at < contact_ || (at == contact_ && contact_pair_ && pair < *contact_pair_)) {
      contact_ = at;
      contact_pair_ = pair;
    }
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double contact_ = kNever;
  double spell_ = kNever;
  double last_ = 0;
  std::optional<RayTime> exact_;
  std::optional<TrianglePair> contact_pair_;
  std::optional<TrianglePair> spell_pair_;
  std::vector<TrianglePair> left_out_;
};

}  // namespace soms::detail
