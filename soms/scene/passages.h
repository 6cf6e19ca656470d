/// \file
/// Passages of swept steps: which ones no step shows, and where a mover is at the moment of one.
///
/// \code
/// const soms::Shape ball(soms::generate_sphere(320));  // of radius 1, about the origin
/// const soms::RigidMotion way = soms::way_of_step(ball, soms::Pose::translation(-4, 0, 0),
///                                                 soms::Pose::translation(4, 0, 0));
/// std::cout << "half way: " << way.pose_at(0.5).apply({0, 0, 0}) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// half way: Vec3{0, 0, 0}
/// \endverbatim
#pragma once

#include "soms/base/pose.h"
#include "soms/motion/rigid_motion.h"
#include "soms/query/body.h"
#include "soms/scene/step_report.h"

#include <span>

namespace soms {

/// The two touch between the steps alone, or may, where the passage grazes: in contact neither at
/// the pose before nor now. `contacts` are those of the report or frame of the passage, sorted.
[[nodiscard]] bool is_between_steps(const EnvironmentPassage& passage,
                                    std::span<const EnvironmentContact> contacts);
[[nodiscard]] bool is_between_steps(const MoverPassage& passage,
                                    std::span<const MoverContact> contacts);

/// The part of the way at which a passage is shown: in contact then, or next to it where nothing is
/// proved.
[[nodiscard]] double moment_of(const Bracket& t);

/// The way of a mover from the pose of one step to that of the next, as swept steps take it.
/// \errors As `RigidMotion::between`.
[[nodiscard]] RigidMotion way_of_step(const Shape& shape, const Pose& before, const Pose& now);

}  // namespace soms
