/// \file
/// The brute-force twin of `robot_contacts`: every pair of bodies, no tree, no broad phase. What
/// tests and `--verify` believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/robot/robot_query.h"

#include <span>

namespace soms::reference {

/// Same meaning as `robot_contacts` of one state with all contacts; `measure` asks for the gap,
/// too. Surfaces meet by `reference::overlap`; a body is inside a closed one where one of its
/// corners is, by `reference::contains_by_brute_force` for each triangle; of an open one, those
/// connected parts that are closed count, and what may be inside else is undecided, by boxes and
/// `caps_by_brute_force`; the gap is the least by
/// `reference::distance_by_brute_force`. Bodies whose boxes do not meet, or are farther apart than
/// others, are passed over. Points of the gap and cost are not given.
/// \errors  As `robot_contacts`.
/// \cost    O(n m) for each pair of bodies whose boxes meet.
[[nodiscard]] RobotAnswer robot_contacts_by_brute_force(const RobotModel& model,
                                                        std::span<const double> state,
                                                        bool measure = false,
                                                        const Limits& limits = {});

/// Whether an answer of `robot_contacts` is what the twin says: its verdict, its contacts (with
/// `first_contact`, the first of them), its limits, and its gap with its pair. What was cut, or is
/// undecided, is compared as far as it goes.
[[nodiscard]] bool agrees(const RobotAnswer& answer, const RobotAnswer& twin);

}  // namespace soms::reference
