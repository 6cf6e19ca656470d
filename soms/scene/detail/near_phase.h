/// \file
/// How near are the bodies of many pairs?
#pragma once

#include "soms/base/limits.h"
#include "soms/query/distance.h"
#include "soms/scene/detail/narrow_phase.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::detail {

/// Asks for distances on the threads given. Keeps its memory from call to call.
class NearPhase {
 public:
  /// Answers depend on each question alone. \errors As `distance`.
  Cost ask(std::span<const BodyPair> questions, const DistanceOptions& options,
           const Limits& limits);

  /// Of the questions of the last call, in their order.
  [[nodiscard]] std::span<const Distance> answers() const { return answers_; }

  /// Gives up the answers, and memory that is far more than `questions` of them need.
  void give_back(std::size_t questions);

  [[nodiscard]] std::size_t memory() const;

 private:
  std::vector<Distance> answers_;
};

}  // namespace soms::detail
