/// \file
/// What a robot touches between two states, one pair of states after the other.
#pragma once

#include "soms/base/box.h"
#include "soms/robot/detail/chain_law.h"
#include "soms/robot/detail/state_query.h"
#include "soms/robot/robot_path.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {

/// One thread's share of `robot_path`.
class PathQuery {
 public:
  /// Refers to both.
  PathQuery(const RobotModel& model, const RobotChains& chains, const Limits& limits);

  /// The answer between two states, whose own are known.
  /// \errors As `robot_path`.
  [[nodiscard]] RobotSegment answer(std::span<const double> from, std::span<const double> to,
                                    const RobotAnswer& first, const RobotAnswer& last);

 private:
  /// Two bodies whose boxes meet on the way, in the order in which they are answered.
  struct Near {
    RobotPair pair;
    std::uint32_t i = 0;
    std::uint32_t j = 0;

    [[nodiscard]] auto operator<=>(const Near&) const = default;
  };

  /// Surfaces of all pairs, between the two states and in the last one.
  void follow(const StateMotion& motion, const RobotAnswer& last, RobotSegment& segment);
  void sweep_boxes(const StateMotion& motion);
  void add(const Near& near, const FirstContact& found, RobotSegment& segment) const;

  [[nodiscard]] ChainLaw law_of(const StateMotion& motion, std::uint32_t i, std::uint32_t j) const;

  [[nodiscard]] const Shape& shape(std::uint32_t i) const { return model_.body(i).part.body.shape; }

  const RobotModel& model_;
  const RobotChains& chains_;
  Limits alone_;
  BroadPhase broad_phase_;
  std::vector<Box> boxes_;  ///< that hold the bodies all the way
};

}  // namespace soms::detail
