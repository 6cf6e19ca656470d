/// \file
/// Which links of a robot are compared with each other, and which may touch?
#pragma once

#include "soms/kinematics/robot.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace soms {

/// The nearest link above each link that has collision meshes: what it hangs from.
/// \param  has_meshes A flag for each link. \pre The joints make a tree.
[[nodiscard]] std::vector<std::optional<std::uint32_t>> links_above(
    const std::vector<Joint>& joints, const std::vector<std::uint8_t>& has_meshes);

/// Pairs of a link that has collision meshes and the nearest links below it that have some, sorted:
/// those that a joint connects, where a link without meshes is passed, as a flange is. They touch
/// at their joint as a rule.
/// \pre `check(robot)` passes.
[[nodiscard]] std::vector<LinkPair> neighbor_pairs(const Robot& robot);

/// Pairs of links with collision meshes that are not compared, sorted: those of Robot::allowed
/// where it is set, and no others; else the neighbors.
/// \pre `check(robot)` passes.
[[nodiscard]] std::vector<LinkPair> skipped_pairs(const Robot& robot);

/// All other pairs of links with collision meshes, sorted.
/// \pre `check(robot)` passes.
[[nodiscard]] std::vector<LinkPair> compared_pairs(const Robot& robot);

}  // namespace soms
