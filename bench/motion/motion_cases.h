/// \file
/// Sets of motions of one body beside another.
#pragma once

#include "soms/motion/rigid_motion.h"
#include "soms/query/body.h"

#include "bench/peers/libraries/library.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soms::bench {

/// Motions of a mover, none of which starts in contact.
struct MotionSet {
  std::string name;
  FloatMesh mover_mesh;
  FloatMesh fixed_mesh;
  Shape mover;
  Body fixed;
  std::vector<RigidMotion> motions;
};

/// A knot beside its twin, both at random poses: `approach` goes 0.8 toward it and turns by 29
/// degrees, `slide-0.001` and `slide-0.02` start at that gap, and go 0.3 along it with a turn by 10
/// degrees. The first also leaves it by 0.01.
[[nodiscard]] std::vector<MotionSet> knot_motions(std::uint64_t triangles, std::size_t count);

/// Movers in a generated city: a car on a street that goes 1 m and turns by 10 degrees; one that
/// goes 20 m and rises; a drone above the street that goes 5 m and turns by 29 degrees; a car 3 m
/// above the ground anywhere that goes 30 m and turns by 57 degrees.
[[nodiscard]] std::vector<MotionSet> city_motions(std::uint64_t triangles, std::size_t count);

}  // namespace soms::bench
