/// \file
/// The nearest of many bodies, whatever is measured: the distance from a point, or t on a ray.
#pragma once

#include "soms/base/bracket.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/measures.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace soms::detail {

/// Memory of searches, for one at a time.
using SearchMemory = std::vector<KeyedBounds>;

/// Calls `visit(body, number, key)` for bodies of all sets, set by set, in the order of their keys:
/// of each set for keys up to `limit` as it is then, and after that up to what `visit` returned
/// last.
/// \return The number of boxes that were given a key.
template <class KeyOf, class Visit>
std::uint64_t for_each_near_body(BodySets sets, const KeyOf& key_of, const double& limit,
                                 SearchMemory& memory, const Visit& visit) {
  std::uint64_t keyed = 0;
  std::uint32_t first = 0;
  for (const BodySet* set : sets) {
    keyed += set->boxes().search(key_of, limit, memory, [&](std::uint32_t k, double key) {
      return visit(set->body(k), first + k, key);
    });
    first += static_cast<std::uint32_t>(set->size());
  }
  return keyed;
}

/// A question whose answers name a triangle and hold what is measured in a bracket. It has
/// - `Answer`, with `triangle`, `coverage` and `cost`; `Found`, the same with `body`, its number;
/// - `measure(answer)`, its bracket: the narrowest one;
/// - `key(box)`: not above what is measured anywhere in a box;
/// - `limit()`: nothing beyond it matters;
/// - `ask(body, number, limit)`: the answer of one body, which may leave out what is beyond
/// `limit`;
/// - `compare(body, triangle, other body, other triangle)`: the order of both, exactly.
template <class Question>
class NearestBody {
 public:
  using Answer = typename Question::Answer;
  using Found = typename Question::Found;

  explicit NearestBody(const Question& question) : question_(question), limit_(question.limit()) {}

  void run(BodySets sets, SearchMemory& memory) {
    cost_.node_tests += for_each_near_body(
        sets, [&](const Box& box) { return question_.key(box); }, limit_, memory,
        [&](const Body& body, std::uint32_t number, double key) {
          return visit(body, number, key);
        });
  }

  /// The nearest so far; nothing if no triangle was found.
  [[nodiscard]] const std::optional<Found>& found() const { return found_; }

  [[nodiscard]] bool cut() const { return cut_; }

  /// Where the search was cut: nothing that is not found is nearer than this.
  [[nodiscard]] double at_least() const { return at_least_; }

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// What this set is searched up to from now on. A search that is cut takes the least key of each
  /// further set, too.
  double visit(const Body& body, std::uint32_t number, double key) {
    if (!cut_) {
      Answer answer = question_.ask(body, number, limit_);
      cost_ += answer.cost;
      cut_ = answer.coverage == Coverage::cut;
      if (answer.triangle && is_nearer(answer, body, number)) {
        limit_ = std::min(limit_, question_.measure(answer).upper);
        found_.emplace(Found{std::move(answer), number});
        body_ = &body;
      }
    }
    if (cut_) {
      at_least_ = std::min(at_least_, key);
      return -kInfinity;
    }
    return limit_;
  }

  [[nodiscard]] bool is_nearer(const Answer& answer, const Body& body, std::uint32_t number) const {
    if (!found_) {
      return true;
    }
    const std::strong_ordering order = order_of(
        question_.measure(answer), question_.measure(*found_),
        [&] { return question_.compare(body, *answer.triangle, *body_, *found_->triangle); });
    return order < 0 || (order == 0 && number < *found_->body);
  }

  const Question& question_;
  double limit_;
  std::optional<Found> found_;
  const Body* body_ = nullptr;  // of what was found
  bool cut_ = false;
  double at_least_ = kInfinity;
  Cost cost_;
};

}  // namespace soms::detail
