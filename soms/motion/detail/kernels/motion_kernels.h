/// \file
/// Windows of times of triangles side by side, once for each instruction set. All give the same
/// bits: every lane is a double, and each operation is rounded by itself.
#pragma once

#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/swept_boxes.h"
#include "soms/motion/detail/triangle_lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace soms::detail {

/// Windows of pairs of lanes of nodes: bit 4 j + i of `open` is set where that of lane i of x and
/// lane j of y is not empty. Those of others may be anything.
struct alignas(64) WindowsOfPairs {
  std::array<SweptBoxes::Row, SweptBoxes::kLanes> lower;
  std::array<SweptBoxes::Row, SweptBoxes::kLanes> upper;
  std::uint32_t open = 0;

  [[nodiscard]] bool has(std::size_t i, std::size_t j) const {
    return (open >> (SweptBoxes::kLanes * j + i) & 1U) != 0;
  }

  [[nodiscard]] TimeWindow at(std::size_t i, std::size_t j) const {
    return {lower[j][i], upper[j][i]};
  }
};

/// One instruction set's functions.
struct MotionKernels {
  /// When lanes of x that move and lanes of y that rest may meet.
  /// \param margin As MotionBounds::box_margin, here and below
  void (*meet_nodes)(const SweptBoxes& x, const SweptBoxes& y, double margin,
                     WindowsOfPairs& windows);

  /// Turns corners in the coordinates of the body into triangles over the stretch. The way of no
  /// point leaves its chord by more than `bow`.
  void (*sweep)(const MotionInterval& interval, double bow, TriangleLanes& lanes);

  /// The same of triangles that rest.
  void (*place)(const Pose& pose, TriangleLanes& lanes);

  /// When triangles and the box of lane 0 may meet, either of which moves. Boxes of large triangles
  /// say little; their planes say more.
  void (*meet_box)(const TriangleLanes& lanes, const SweptBoxes& box, double margin,
                   WindowsOfLanes& windows);

  /// When triangles of x that move and triangle `j` of y, which rests, may meet.
  void (*meet_triangle)(const TriangleLanes& x, const TriangleLanes& y, std::size_t j,
                        double margin, WindowsOfLanes& windows);
};

/// Those of an instruction set of `instruction_sets`, which this processor has.
[[nodiscard]] const MotionKernels& motion_kernels(std::string_view instruction_set);

/// Those of the instruction set that queries run on.
[[nodiscard]] const MotionKernels& motion_kernels();

#if defined(__x86_64__)
/// \pre The processor has AVX2.
[[nodiscard]] const MotionKernels& motion_kernels_of_avx2();
#endif

}  // namespace soms::detail
