#include "soms/scene/detail/near_phase.h"

#include "soms/base/parallel.h"
#include "soms/scene/detail/kept_memory.h"

namespace soms::detail {

Cost NearPhase::ask(std::span<const BodyPair> questions, const DistanceOptions& options,
                    const Limits& limits) {
  const bool few = questions.size() < kFewQuestions;
  const Limits whole = limits.silent();
  const Limits shared = few ? whole.alone() : whole;
  const Limits inside = (few ? whole : whole.alone()).without_deadline();  // no pair is cut
  answers_.assign(questions.size(), {});
  for_each_chunk(questions.size(), 1, shared, [&](std::size_t k, std::size_t) {
    answers_[k] = distance(*questions[k].mover, *questions[k].other, options, inside);
  });
  Cost cost;
  for (const Distance& answer : answers_) {
    cost += answer.cost;
  }
  return cost;
}

void NearPhase::give_back(std::size_t questions) {
  answers_.clear();
  if (is_far_above(bytes(answers_), questions * sizeof(Distance))) {
    release(answers_);
  }
}

std::size_t NearPhase::memory() const {
  return bytes(answers_);
}

}  // namespace soms::detail
