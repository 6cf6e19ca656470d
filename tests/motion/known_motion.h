/// \file
/// Pairs of triangles whose first contact is known: tests/data/motion/kisses.csv.
#pragma once

#include "soms/base/bracket.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/motion/rigid_motion.h"

#include "tests/motion/motion_table.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::test {

/// The doubles next to above / below, both small.
inline Bracket next_to(std::int64_t above, std::int64_t below) {
  return detail::bracket(detail::RayTime{detail::Integer(above), detail::Integer(below), 0});
}

/// A row of kisses.csv.
struct KnownMotion {
  Triangle moving;
  Triangle resting;
  RigidMotion motion;
  std::optional<Bracket> time;  ///< the doubles next to that of the first contact
};

inline Pose known_pose(const MotionTable& table, std::size_t row, const std::string& name) {
  return Pose::from_quaternion(table.number(row, name + "qw"), table.number(row, name + "qx"),
                               table.number(row, name + "qy"), table.number(row, name + "qz"),
                               table.vector(row, name));
}

inline KnownMotion known_motion(const MotionTable& table, std::size_t row) {
  const auto triangle = [&](const std::string& name) {
    return Triangle{table.vector(row, name + "0"), table.vector(row, name + "1"),
                    table.vector(row, name + "2")};
  };
  KnownMotion known{triangle("a"), triangle("b"),
                    RigidMotion::between(known_pose(table, row, "s"), known_pose(table, row, "e"),
                                         table.vector(row, "c")),
                    std::nullopt};
  if (table.text(row, "answer") == "contact") {
    known.time = next_to(static_cast<std::int64_t>(table.number(row, "above")),
                         static_cast<std::int64_t>(table.number(row, "below")));
  }
  return known;
}

}  // namespace soms::test
