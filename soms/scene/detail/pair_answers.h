/// \file
/// One answer for each of many pairs of bodies.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/parallel.h"
#include "soms/query/answer.h"
#include "soms/scene/detail/kept_memory.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::detail {

/// Asks on the threads given, of which each of fewer questions than `kFew` gets all. Keeps its
/// memory from call to call.
template <class Answer, std::size_t kFew>
class PairAnswers {
 public:
  /// `ask(k, limits)` answers question k, by itself. No answer is cut.
  /// \errors As `ask`; between questions, as `check(Limits)`.
  template <class Ask>
  Cost ask(std::size_t questions, const Limits& limits, const Ask& ask) {
    const bool few = questions < kFew;
    const Limits whole = limits.silent();
    const Limits shared = few ? whole.alone() : whole;
    const Limits inside = (few ? whole : whole.alone()).without_deadline();
    answers_.assign(questions, {});
    for_each_chunk(questions, 1, shared,
                   [&](std::size_t k, std::size_t) { answers_[k] = ask(k, inside); });
    Cost cost;
    for (const Answer& answer : answers_) {
      cost += answer.cost;
    }
    return cost;
  }

  /// Of the questions of the last call, in their order.
  [[nodiscard]] std::span<const Answer> get() const { return answers_; }

  /// Gives up the answers, and memory that is far more than `questions` of them need.
  void give_back(std::size_t questions) {
    answers_.clear();
    if (is_far_above(bytes(answers_), questions * sizeof(Answer))) {
      release(answers_);
    }
  }

  [[nodiscard]] std::size_t memory() const { return bytes(answers_); }

 private:
  std::vector<Answer> answers_;
};

}  // namespace soms::detail
