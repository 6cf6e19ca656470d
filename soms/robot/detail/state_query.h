/// \file
/// The answer for one state of a robot after the other, with memory that is used again.
#pragma once

#include "soms/base/box.h"
#include "soms/base/stop_token.h"
#include "soms/robot/robot_query.h"
#include "soms/scene/broad_phase.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// A broad phase over the bodies of a model: bodies of one link do not meet each other, nor do
/// those of the cell.
[[nodiscard]] BroadPhase broad_phase_of(const RobotModel& model);

/// One thread's share of `robot_contacts`.
class StateQuery {
 public:
  StateQuery(const RobotModel& model, const RobotOptions& options, const Limits& limits);

  /// \errors As `robot_contacts`.
  [[nodiscard]] RobotAnswer answer(std::span<const double> state);

 private:
  /// A pair of bodies, and the pair of the robot that it belongs to.
  struct Candidate {
    RobotPair pair;
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    double bound = 0;  ///< of the distance, from below

    [[nodiscard]] auto operator<=>(const Candidate&) const = default;
  };

  void place_bodies(std::span<const double> state);
  void find_contacts(RobotAnswer& answer);
  void decide(const Candidate& candidate, RobotAnswer& answer);
  [[nodiscard]] bool is_inside(std::size_t inner, std::size_t outer, RobotAnswer& answer);
  [[nodiscard]] bool may_be_inside(std::size_t inner, std::size_t outer, RobotAnswer& answer);
  [[nodiscard]] const ClosedBody* closed(std::size_t i);
  [[nodiscard]] const std::vector<Box>& exact_boxes(std::size_t i);
  void measure(RobotAnswer& answer);
  [[nodiscard]] std::vector<Candidate> by_bound(double at_most) const;

  template <class Answer>
  [[nodiscard]] Answer counted(Answer found, RobotAnswer& answer) {
    answer.cost += found.cost;
    cut_ = cut_ || found.coverage == Coverage::cut;
    return found;
  }

  const RobotModel& model_;
  const RobotOptions& options_;
  Limits alone_;
  BroadPhase broad_phase_;
  std::vector<Body> bodies_;                       ///< at the poses of the state
  std::vector<Box> boxes_;                         ///< that hold them
  std::vector<std::optional<ClosedBody>> closed_;  ///< of an open one, its core
  std::vector<std::uint8_t> was_closed_;           ///< `closed_` was tried for this state
  /// Of each connected part, and of the body, which is last; empty until they are needed.
  std::vector<std::vector<Box>> exact_boxes_;
  bool cut_ = false;
};

}  // namespace soms::detail
